// SPDX-License-Identifier: Apache-2.0
// The numbers of the sun beside its dial: latitude, day and hour, or azimuth and altitude.
import type { ReactElement } from 'react';

import { use_store } from '../base/store.ts';
import { NumberField } from '../controls/number_field.tsx';
import { Slider } from '../controls/slider.tsx';
import { use_page } from '../page/use_page.ts';
import type { Json } from '../values/json.ts';
import { day_text, hour_text } from './sun_math.ts';
import type { SunActions } from './sun_state.ts';
import { kNoLatitude, place_of, said_of, with_place, with_time } from './sun_state.ts';

export function SunFields(props: SunActions): ReactElement {
  const { scene, state } = props;
  const page = use_page();
  const { is_sunlit } = use_store(page.view_state);
  const sun = place_of(state);
  return (
    <div className="sun-fields">
      {state.place ? (
        <>
          <SunField
            {...props}
            label="Azimuth"
            unit="°"
            value={state.place.azimuth}
            low={0}
            high={360}
            step={1}
            values={(azimuth) => with_place({ azimuth, altitude: sun.altitude })}
          />
          <SunField
            {...props}
            label="Altitude"
            unit="°"
            value={state.place.altitude}
            low={-10}
            high={90}
            step={1}
            values={(altitude) => with_place({ azimuth: sun.azimuth, altitude })}
          />
        </>
      ) : (
        <>
          <SunField
            {...props}
            label="Latitude"
            unit="°"
            value={state.latitude ?? kNoLatitude}
            low={-90}
            high={90}
            step={0.5}
            values={(latitude) => ({ 'scene.latitude': latitude })}
          />
          {state.kind !== 'season' && (
            <SunField
              {...props}
              label="Day"
              said={day_text(state.day)}
              value={state.day}
              low={1}
              high={365}
              step={1}
              values={(day) => with_time(scene, state, day, state.hour)}
            />
          )}
          <SunField
            {...props}
            label={state.kind === 'clock' ? 'Time' : 'Hour'}
            said={hour_text(state.hour)}
            value={state.hour}
            low={0}
            high={24}
            step={0.25}
            values={(hour) => with_time(scene, state, state.day, hour)}
          />
        </>
      )}
      <p className="quiet" aria-live="off">
        {said_of(state, sun)}
        {state.every_hours !== null &&
          `; for growth all day${state.days ? `, from ${day_text(state.days[0])} to ${day_text(state.days[1])}` : ''}`}
      </p>
      <label className="check-line">
        <input
          type="checkbox"
          checked={is_sunlit}
          onChange={(event) => page.change_view({ is_sunlit: event.target.checked })}
        />
        Light the view by this sun
      </label>
    </div>
  );
}

interface SunFieldProps extends SunActions {
  label: string;
  unit?: string;
  said?: string;
  value: number;
  low: number;
  high: number;
  step: number;
  values: (value: number) => Record<string, Json>;
}

function SunField({
  label,
  unit,
  said,
  value,
  low,
  high,
  step,
  values,
  drag,
  commit,
  cancel,
}: SunFieldProps): ReactElement {
  const limit = (one: number): number => Math.min(high, Math.max(low, one));
  const acts = {
    drag: (one: number) => drag(values(limit(one))),
    commit: (one: number) => commit(values(limit(one))),
    cancel,
  };
  return (
    <div className="sun-field">
      <span className="sun-field-name">{label}</span>
      <Slider {...acts} label={`${label} of the sun, slider`} value={value} low={low} high={high} step={step} />
      <NumberField {...acts} label={`${label} of the sun`} value={value} step={step} unit={unit} limit={limit} />
      {said !== undefined && <span className="quiet">{said}</span>}
    </div>
  );
}
