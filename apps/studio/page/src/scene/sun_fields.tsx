// SPDX-License-Identifier: Apache-2.0
// The numbers of the sun beside its dial: latitude, day and hour, or azimuth and altitude. Each number stays within the
// range of its row, which is shown below its slider.
import type { ReactElement } from 'react';

import { use_store } from '../base/store.ts';
import { NumberField } from '../controls/number_field.tsx';
import { Slider } from '../controls/slider.tsx';
import { use_document, use_page } from '../page/use_page.ts';
import { row_at } from '../tables/resolve.ts';
import type { Row } from '../tables/tables.ts';
import { hard_range, slider_range, within_hard_range } from '../tables/tables.ts';
import type { Json } from '../values/json.ts';
import { day_text, days_of_year, hour_text } from './sun_math.ts';
import type { SunActions } from './sun_state.ts';
import { kNoLatitude, place_of, said_of, with_place, with_time, year_of } from './sun_state.ts';

const kDusk = -10; // degrees: a sun below the horizon is no usual value of the row

export function SunFields(props: SunActions): ReactElement {
  const { scene, state } = props;
  const page = use_page();
  const { is_sunlit } = use_store(page.view_state);
  const sun = place_of(state);
  const year = year_of(scene);
  return (
    <div className="sun-fields">
      {state.place ? (
        <>
          <SunField
            {...props}
            path="scene.sun.azimuth"
            label="Azimuth"
            unit="°"
            value={state.place.azimuth}
            step={1}
            values={(azimuth) => with_place({ azimuth, altitude: sun.altitude })}
          />
          <SunField
            {...props}
            path="scene.sun.altitude"
            low={kDusk}
            label="Altitude"
            unit="°"
            value={state.place.altitude}
            step={1}
            values={(altitude) => with_place({ azimuth: sun.azimuth, altitude })}
          />
        </>
      ) : (
        <>
          <SunField
            {...props}
            path="scene.latitude"
            label="Latitude"
            unit="°"
            value={state.latitude ?? kNoLatitude}
            step={0.5}
            values={(latitude) => ({ 'scene.latitude': latitude })}
          />
          {state.kind !== 'season' && (
            <SunField
              {...props}
              path="scene.sun.day"
              {...(year === null ? {} : { max: days_of_year(year) })}
              label="Day"
              said={day_text(state.day)}
              value={state.day}
              step={1}
              values={(day) => with_time(scene, state, day, state.hour)}
            />
          )}
          <SunField
            {...props}
            path={state.kind === 'clock' ? 'scene.sun.time' : 'scene.sun.hour'}
            label={state.kind === 'clock' ? 'Time' : 'Hour'}
            said={hour_text(state.hour)}
            value={state.hour}
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
  path: string; // of the row in the document
  max?: number; // a maximum that is lower than the row's
  low?: number; // the slider's lowest value, if it is lower than usual values
  value: number;
  step: number;
  values: (value: number) => Record<string, Json>;
}

function SunField({
  label,
  unit,
  said,
  path,
  max,
  low,
  value,
  step,
  values,
  drag,
  commit,
  cancel,
}: SunFieldProps): ReactElement {
  const page = use_page();
  const { tree } = use_document();
  const row: Row = row_at(page.tables, tree, path) ?? { name: label, kind: 'number', doc: '' };
  const legal = max === undefined ? row : { ...row, max };
  const limit = (one: number): number => within_hard_range(legal, one);
  const acts = {
    drag: (one: number) => drag(values(limit(one))),
    commit: (one: number) => commit(values(limit(one))),
    cancel,
  };
  const [usual_low, high] = slider_range(legal, value);
  const ends = hard_range(legal);
  return (
    <div className="sun-field">
      <span className="sun-field-name">{label}</span>
      <div className="sun-slider">
        <Slider
          {...acts}
          label={`${label} of the sun, slider`}
          value={value}
          low={Math.min(low ?? usual_low, usual_low)}
          high={high}
          step={step}
        />
        <span className="sun-ends" data-limits={`${ends.low} ${ends.high}`}>
          {ends.low} to {ends.high}
        </span>
      </div>
      <NumberField
        {...acts}
        label={`${label} of the sun`}
        value={value}
        step={step}
        unit={unit}
        limit={limit}
        description={`${row.doc} From ${ends.low} to ${ends.high}.`}
      />
      {said !== undefined && <span className="quiet">{said}</span>}
    </div>
  );
}
