// SPDX-License-Identifier: Apache-2.0
// The sky from below: the horizon as a circle, north up, with the sun's paths on the solstices, the equinoxes and the
// day of the scene. A drag of the sun along its path changes the hour, and a drag across the paths changes the day.
import type { KeyboardEvent, PointerEvent, ReactElement } from 'react';
import { useRef } from 'react';

import { use_store } from '../base/store.ts';
import { Button } from '../controls/button.tsx';
import { use_held } from '../controls/use_held.ts';
import { use_document, use_page } from '../page/use_page.ts';
import { TimeModel } from '../time/time_model.ts';
import { drag_values, set_values, value_now } from '../time/values_now.ts';
import type { Json } from '../values/json.ts';
import { value_at } from '../values/path.ts';
import { SunFields } from './sun_fields.tsx';
import type { SkyPlace } from './sun_math.ts';
import { day_of, declination, hour_and_declination, kSolstices, sun_place } from './sun_math.ts';
import type { SunActions, SunState } from './sun_state.ts';
import { kNoLatitude, place_of, said_of, sun_state, with_place, with_time } from './sun_state.ts';

const kRadius = 100; // radius of the horizon in the picture
const kEdge = 122; // half of the picture's size
const kDeepest = -14; // degrees below the horizon that are still drawn
// Largest distance of a drag from the path of the day at which the day stays, degrees of declination
const kAcross = 1.2;
const kHourStep = { plain: 0.5, fine: 0.1, coarse: 2 };
const kDayStep = { plain: 7, fine: 1, coarse: 30 };
const kDegreeStep = { plain: 2, fine: 0.5, coarse: 15 };

export function SunDial(): ReactElement {
  const page = use_page();
  const { tree } = use_document();
  use_store(page.dragged);
  use_store(page.tool(TimeModel).state);
  const scene = value_now(page, 'scene', value_at(tree, 'scene'));
  const state = sun_state(scene);
  if (state.kind === 'none') {
    const give = (): void =>
      set_values(
        page,
        {
          'scene.sun': { day: kSolstices.summer, hour: 12 },
          ...(state.latitude === null ? { 'scene.latitude': kNoLatitude } : {}),
        },
        'Give the scene a sun',
      );
    return (
      <section className="sun-dial" aria-label="Sun">
        <p className="empty">The scene has no sun: light comes from the zenith.</p>
        <Button press={give}>Give it a sun</Button>
      </section>
    );
  }
  if (state.kind === 'other') return <p className="empty">The sun is given by expressions; its rows say how.</p>;
  return (
    <section className="sun-dial" aria-label="Sun">
      <Sky
        scene={scene}
        state={state}
        drag={(values) => drag_values(page, values)}
        commit={(values) => set_values(page, values, 'Move the sun')}
        cancel={() => page.stop_drag()}
      />
      <SunFields
        scene={scene}
        state={state}
        drag={(values) => drag_values(page, values)}
        commit={(values) => set_values(page, values, 'Move the sun')}
        cancel={() => page.stop_drag()}
      />
    </section>
  );
}

function Sky(props: SunActions): ReactElement {
  const { scene, state, drag, commit, cancel } = props;
  const picture = useRef<SVGSVGElement>(null);
  const held = use_held<{ values: Record<string, Json> | null; day: number }>();
  const latitude = state.latitude ?? kNoLatitude;
  const sun = place_of(state);
  const values_at = (place: SkyPlace, from: number): Record<string, Json> => {
    if (state.kind === 'fixed') return with_place(place);
    const found = hour_and_declination(latitude, place);
    // Near its path, the sun stays on it, so that only the hour changes.
    const stays = state.kind === 'season' || Math.abs(found.declination - declination(from)) < kAcross;
    return with_time(scene, state, stays ? from : day_of(found.declination, from), found.hour);
  };
  const pointed = (event: PointerEvent): SkyPlace => {
    const at = new DOMPoint(event.clientX, event.clientY).matrixTransform(picture.current?.getScreenCTM()?.inverse());
    return sky_place(at.x, at.y);
  };
  const down = (event: PointerEvent<SVGSVGElement>): void => {
    if (event.button !== 0) return;
    event.preventDefault();
    event.currentTarget.setPointerCapture(event.pointerId);
    picture.current?.querySelector<SVGElement>('.sun')?.focus();
    held.set({ values: null, day: state.day });
  };
  const move = (event: PointerEvent): void => {
    const hand = held.get();
    if (!hand) return;
    const values = values_at(pointed(event), hand.day);
    held.set({ ...hand, values });
    drag(values);
  };
  const let_go = (event: PointerEvent, commits: boolean): void => {
    const hand = held.get();
    held.set(null);
    if (!hand) return;
    if (!commits) cancel();
    else commit(hand.values ?? values_at(pointed(event), hand.day));
  };
  const key = (event: KeyboardEvent): void => {
    if (event.key === 'Escape' && held.get()) {
      held.set(null);
      cancel();
      event.stopPropagation();
      return;
    }
    const way = ({ ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] } as const)[event.key];
    if (!way) return;
    event.preventDefault();
    event.stopPropagation();
    const pace = event.shiftKey ? 'fine' : event.ctrlKey || event.metaKey ? 'coarse' : 'plain';
    if (state.place)
      commit(
        with_place({
          azimuth: state.place.azimuth + way[0] * kDegreeStep[pace],
          altitude: state.place.altitude + way[1] * kDegreeStep[pace],
        }),
      );
    else
      commit(
        with_time(
          scene,
          state,
          ((state.day + way[1] * kDayStep[pace] + 364) % 365) + 1,
          state.hour + way[0] * kHourStep[pace],
        ),
      );
  };
  const [x, y] = dial_point(sun);
  return (
    <svg
      ref={picture}
      className={`sky${held.shown ? ' held' : ''}`}
      viewBox={`${-kEdge} ${-kEdge} ${2 * kEdge} ${2 * kEdge}`}
      role="group"
      aria-label="The sky"
      onPointerDown={down}
      onPointerMove={move}
      onPointerUp={(event) => let_go(event, true)}
      onPointerCancel={(event) => let_go(event, false)}
    >
      <circle className="sky-dome" r={kRadius} />
      {[30, 60].map((altitude) => (
        <circle key={altitude} className="sky-ring" r={(kRadius * (90 - altitude)) / 90} />
      ))}
      {(['N', 'E', 'S', 'W'] as const).map((name, k) => (
        <text
          key={name}
          className="sky-name"
          x={(kRadius + 12) * Math.sin((k * Math.PI) / 2)}
          y={-(kRadius + 12) * Math.cos((k * Math.PI) / 2)}
        >
          {name}
        </text>
      ))}
      {state.kind !== 'fixed' && <Ways state={state} latitude={latitude} />}
      <g
        className={`sun${sun.altitude < 0 ? ' down' : ''}`}
        transform={`translate(${x.toFixed(1)} ${y.toFixed(1)})`}
        tabIndex={0}
        role="slider"
        aria-label="Sun"
        aria-valuemin={0}
        aria-valuemax={24}
        aria-valuenow={Number(state.hour.toFixed(2))}
        aria-valuetext={said_of(state, sun)}
        onKeyDown={key}
      >
        <circle className="reach" r="14" />
        <circle r="8" />
      </g>
    </svg>
  );
}

/// The paths of the sun: thin at the solstices and equinoxes, and with hours for the scene's day.
function Ways({ state, latitude }: { state: SunState; latitude: number }): ReactElement {
  const hours = Array.from({ length: 25 }, (_, hour) => hour);
  const season = state.days ? [...state.days] : [];
  return (
    <>
      {[kSolstices.summer, kSolstices.equinox, kSolstices.winter].map((day) => (
        <path key={day} className="sky-way" d={way_of(latitude, day)} />
      ))}
      {season.map((day) => (
        <path key={`of ${day}`} className="sky-way of-season" d={way_of(latitude, day)} />
      ))}
      <path className="sky-way of-day" d={way_of(latitude, state.day)} />
      {hours.map((hour) => {
        const place = sun_place(latitude, state.day, hour);
        if (place.altitude < 0) return null;
        const [x, y] = dial_point(place);
        return (
          <g key={hour}>
            <circle className="sky-hour" cx={x.toFixed(1)} cy={y.toFixed(1)} r={hour % 3 === 0 ? 2.5 : 1.5} />
            {hour % 3 === 0 && (
              <text className="sky-hour-name" x={x.toFixed(1)} y={(y + (latitude >= 0 ? 12 : -8)).toFixed(1)}>
                {hour}
              </text>
            )}
          </g>
        );
      })}
    </>
  );
}

function dial_point({ azimuth, altitude }: SkyPlace): [number, number] {
  const away = (kRadius * (90 - Math.max(kDeepest, altitude))) / 90;
  const angle = (azimuth * Math.PI) / 180;
  return [away * Math.sin(angle), -away * Math.cos(angle)];
}

function sky_place(x: number, y: number): SkyPlace {
  return {
    azimuth: ((Math.atan2(x, -y) * 180) / Math.PI + 360) % 360,
    altitude: Math.max(kDeepest, 90 - (90 * Math.hypot(x, y)) / kRadius),
  };
}

/// Returns the part of the path above the horizon.
function way_of(latitude: number, day: number): string {
  let path = '';
  let is_broken = true;
  for (let quarter = 0; quarter <= 96; quarter += 1) {
    const place = sun_place(latitude, day, quarter / 4);
    if (place.altitude >= 0) {
      const [x, y] = dial_point(place);
      path += `${is_broken ? 'M' : 'L'}${x.toFixed(1)} ${y.toFixed(1)}`;
    }
    is_broken = place.altitude < 0;
  }
  return path;
}
