// SPDX-License-Identifier: Apache-2.0
// Measures over one handle. The plant is grown at values over the handle's range, and all of its measures are taken;
// any of them can be plotted. A click on a point sets its value.
import type { ReactElement } from 'react';
import { useState } from 'react';

import { use_store } from '../base/store.ts';
import { Button, IconButton } from '../controls/button.tsx';
import { step_of } from '../find/handle_step.ts';
import { use_document, use_page } from '../page/use_page.ts';
import type { MeasureRow, Variable } from '../server/protocol.ts';
import { rounded } from '../values/arithmetic.ts';
import { kFacts } from './facts.ts';
import { shown_measure } from './measure_groups.ts';
import type { SweepState } from './measure_model.ts';
import { MeasureModel } from './measure_model.ts';
import { Plot } from './plot.tsx';

const kCount = 9; // number of values over the range
const kUsual = ['height', 'crown_width', 'stem_diameter', 'leaf_area'];

/// Returns values over the range of a handle, without duplicates.
export function values_of(variable: Variable, count = kCount): number[] {
  const { min, max } = variable;
  return [
    ...new Set(
      Array.from({ length: count }, (_, k) => rounded(min + ((max - min) * k) / (count - 1), step_of(variable))),
    ),
  ];
}

export function SweepPart(): ReactElement | null {
  const page = use_page();
  const model = page.tool(MeasureModel);
  const { variables } = use_document();
  const { rows } = use_store(model.state);
  const sweep = use_store(model.sweep);
  const handles = variables.filter((one) => !one.private && one.max > one.min);
  const [wanted, want] = useState('');
  const [drawn, draw] = useState<readonly string[]>(['height']);
  const handle =
    handles.find((one) => one.name === wanted) ?? handles.find((one) => one.name === sweep.variable) ?? handles[0];
  if (!handle) return null;
  const measure = (): void => void model.measure_over(handle.name, values_of(handle));
  return (
    <div className="sweep row-group" aria-busy={sweep.is_working}>
      <h3>Over a handle</h3>
      <div className="sweep-choice">
        <select
          className="select"
          aria-label="Handle over which is measured"
          value={handle.name}
          onChange={(event) => want(event.target.value)}
        >
          {handles.map((one) => (
            <option key={one.name} value={one.name}>
              {one.name.replaceAll('_', ' ')}
            </option>
          ))}
        </select>
        <Button is_off={sweep.is_working} press={measure}>
          {sweep.is_working ? 'Measuring…' : 'Measure'}
        </Button>
        {sweep.is_working && (
          <IconButton is_small icon="stop" label="Stop measuring" press={() => model.stop_sweep()} />
        )}
      </div>
      {sweep.is_working && <SweepProgress />}
      {sweep.fault !== '' && <p className="fault-line">{sweep.fault}</p>}
      {sweep.points.length > 0 && <Plots sweep={sweep} rows={rows} drawn={drawn} draw={draw} />}
    </div>
  );
}

function SweepProgress(): ReactElement {
  const { working } = use_store(use_page().growth);
  const is_own = working?.job === 'sweep';
  return (
    <p className="record-progress" role="status">
      <progress max={1} value={is_own ? working.share : undefined} aria-label="Progress of measuring" />
      <span className="quiet">{is_own ? working.stage : ''}</span>
    </p>
  );
}

interface PlotsProps {
  sweep: SweepState;
  rows: readonly MeasureRow[];
  drawn: readonly string[];
  draw: (names: readonly string[]) => void;
}

function Plots({ sweep, rows, drawn, draw }: PlotsProps): ReactElement {
  const page = use_page();
  const { variables } = use_document();
  const variable = variables.find((one) => one.name === sweep.variable);
  const has_numbers = (row: MeasureRow): boolean =>
    sweep.points.some((one) => typeof one.measures?.[row.name] === 'number');
  const choices = rows.filter(has_numbers);
  const shown = drawn.filter((one) => choices.some((row) => row.name === one));
  const faulty = sweep.points.filter((one) => one.faults !== undefined);
  const next = [...kUsual, ...choices.map((row) => row.name)].find(
    (one) => !shown.includes(one) && choices.some((row) => row.name === one),
  );
  const title = sweep.variable.replaceAll('_', ' ');
  return (
    <>
      {shown.map((name, k) => {
        const row = choices.find((one) => one.name === name);
        const points = sweep.points.flatMap(({ value, measures }) =>
          typeof measures?.[name] === 'number' ? [[value, measures[name]] as const] : [],
        );
        return (
          <div key={name} className="plot-block" data-plot={name}>
            <div className="plot-head">
              <select
                className="select"
                aria-label={`Measure of plot ${k + 1}`}
                value={name}
                onChange={(event) => draw(shown.map((one) => (one === name ? event.target.value : one)))}
              >
                {choices.map((one) => (
                  <option key={one.name} value={one.name} disabled={one.name !== name && shown.includes(one.name)}>
                    {one.name.replaceAll('_', ' ')}
                  </option>
                ))}
              </select>
              <span className="quiet">{row?.unit}</span>
              <IconButton
                is_small
                icon="close"
                label={`Close the plot of ${name.replaceAll('_', ' ')}`}
                press={() => draw(shown.filter((one) => one !== name))}
              />
            </div>
            <Plot
              label={`${name.replaceAll('_', ' ')} over ${title}`}
              points={points}
              now={variable?.value ?? null}
              band={kFacts[name]?.[0] ?? null}
              text={([at, value]) => `${title} ${at}: ${shown_measure(value)} ${row?.unit ?? ''}`.trim()}
              take={(value) => page.set_value(sweep.variable, value, `Set ${title}`)}
            />
          </div>
        );
      })}
      {next !== undefined && (
        <Button kind="quiet" press={() => draw([...shown, next])}>
          Draw another measure
        </Button>
      )}
      {faulty.length > 0 && (
        <p className="fault-line">
          {`${faulty.length} of ${sweep.points.length} values have faults: `}
          {faulty[0]?.faults?.[0]?.message}
        </p>
      )}
    </>
  );
}
