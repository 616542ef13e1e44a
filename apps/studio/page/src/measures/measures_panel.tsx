// SPDX-License-Identifier: Apache-2.0
// The panel of measures: values of the plant, published values of real plants, and measures over the values of a
// handle.
import type { ReactElement } from 'react';
import { useEffect, useState } from 'react';

import { use_store } from '../base/store.ts';
import { Icon } from '../controls/icon.tsx';
import { use_page } from '../page/use_page.ts';
import type { MeasureRow } from '../server/protocol.ts';
import type { Json } from '../values/json.ts';
import { Bars, Layers } from './bars.tsx';
import type { Fact } from './facts.ts';
import { kFacts } from './facts.ts';
import { groups_of, shown_measure } from './measure_groups.ts';
import { MeasureModel } from './measure_model.ts';
import { SweepPart } from './sweep_part.tsx';

export function MeasuresPanel(): ReactElement {
  const page = use_page();
  const model = page.tool(MeasureModel);
  const { rows, told, with_light, is_working, fault } = use_store(model.state);
  const [words, set_words] = useState('');
  useEffect(() => model.look(), [model]);
  const is_wanted = (row: MeasureRow): boolean =>
    words === '' || `${row.name.replaceAll('_', ' ')} ${row.doc}`.toLowerCase().includes(words.toLowerCase());
  return (
    <section className="panel measures-panel" aria-label="Measures">
      <div className="inspector-tools">
        <label className="search">
          <Icon name="search" />
          <input
            type="search"
            aria-label="Find a measure"
            placeholder="Find a measure"
            value={words}
            onChange={(event) => set_words(event.target.value)}
          />
        </label>
      </div>
      <label
        className="check-line"
        data-tip="Rays from every leaf to every light of the scene; this takes longer than all else"
      >
        <input type="checkbox" checked={with_light} onChange={(event) => model.set_light(event.target.checked)} />
        Light on the leaves
      </label>
      {fault !== '' && <p className="fault-line">{fault}</p>}
      <SweepPart />
      <div aria-busy={is_working} className={is_working ? 'measured old' : 'measured'}>
        {groups_of(rows.filter(is_wanted)).map((group) => (
          <div key={group.title} className="row-group">
            <h3>{group.title}</h3>
            <dl>
              {group.rows.map((row) => (
                <Measure key={row.name} row={row} value={told?.[row.name]} />
              ))}
            </dl>
          </div>
        ))}
        {told?.['layers'] !== undefined && <Layers layers={told['layers']} />}
      </div>
    </section>
  );
}

function Measure({ row, value }: { row: MeasureRow; value: Json | undefined }): ReactElement {
  const facts = kFacts[row.name] ?? [];
  const label = row.name.replaceAll('_', ' ');
  return (
    <div className="measure" data-measure={row.name}>
      <dt data-tip={row.doc} tabIndex={-1}>
        {label}
      </dt>
      <dd>
        {Array.isArray(value) && value.length > 1 ? (
          <Bars label={label} values={value} />
        ) : (
          <>
            {shown_measure(value)}
            {typeof value === 'number' && row.unit !== '' && <span className="quiet"> {row.unit}</span>}
          </>
        )}
      </dd>
      {typeof value === 'number' &&
        facts.map((fact) => (
          <dd key={fact.of} className="of-real">
            <Band fact={fact} value={value} />
          </dd>
        ))}
    </div>
  );
}

/// The position of a value relative to a published range.
function Band({ fact, value }: { fact: Fact; value: number }): ReactElement {
  const { low, high } = fact;
  // The range covers the middle of the bar; values far outside are drawn at the ends.
  const share = Math.min(1, Math.max(0, 0.25 + (0.5 * (value - low)) / (high - low)));
  const is_within = value >= low && value <= high;
  return (
    <div
      className={`band${is_within ? '' : ' beyond'}`}
      data-tip={`${low} to ${high}: ${fact.of}\n${fact.source}`}
      tabIndex={0}
      role="img"
      aria-label={`${is_within ? 'within' : 'beyond'} ${low} to ${high}, ${fact.of}`}
    >
      <span className="band-range" />
      <span className="band-mark" style={{ left: `${100 * share}%` }} />
      <span className="quiet">
        {low}–{high}, {fact.of}
      </span>
    </div>
  );
}
