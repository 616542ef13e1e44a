// SPDX-License-Identifier: Apache-2.0
// The plan of a component's trees: its operations in their order, or their acts year by year. The chosen one is shown
// on the tree.
import type { ReactElement } from 'react';
import { useState } from 'react';

import { use_store } from '../base/store.ts';
import { Button, IconButton, Segments } from '../controls/button.tsx';
import { use_document, use_page } from '../page/use_page.ts';
import { path_below, value_at } from '../values/path.ts';
import { OperationList } from './operation_list.tsx';
import type { PlanYear } from './operation_text.ts';
import { counted_act, index_in, what_of, years_of } from './operation_text.ts';
import { list_path, Pruning, trained_path } from './pruning.ts';
import { use_plan_component } from './use_plan_component.ts';

export function PlanPanel(): ReactElement {
  const page = use_page();
  const component = use_plan_component();
  const [order, set_order] = useState<'list' | 'years'>('list');
  if (component === null) {
    return (
      <section className="panel plan-panel" aria-label="Plan">
        <p className="empty">
          No component of this document takes operations. Trees of the type organize do: their shoots can be cut, bent
          and tied.
        </p>
        <Button kind="quiet" press={() => page.shell.merge({ side: 'inspector' })}>
          Show the inspector
        </Button>
      </section>
    );
  }
  const all = page.tool(Pruning).components();
  return (
    <section className="panel plan-panel" aria-label="Plan">
      {all.length > 1 && (
        <select
          className="select"
          aria-label="Component whose plan is shown"
          value={component}
          onChange={(event) => page.choose(path_below('components', event.target.value))}
        >
          {all.map((one) => (
            <option key={one}>{one}</option>
          ))}
        </select>
      )}
      <div className="plan-head">
        <Segments
          label="Order of the plan"
          value={order}
          choices={[
            ['list', 'In order'],
            ['years', 'By year'],
          ]}
          choose={set_order}
        />
        <span className="stretch" />
        <BeforeButton component={component} />
        <IconButton
          icon="stem"
          label="Take hold of a shoot; keys then go along the tree"
          press={() => void page.tool(Pruning).walk.begin()}
        />
      </div>
      {order === 'list' ? <OperationList component={component} /> : <Years component={component} />}
    </section>
  );
}

/// While it is on, shows the trees before the operations of the last year.
function BeforeButton({ component }: { component: string }): ReactElement | null {
  const page = use_page();
  const { tree } = use_document();
  const plan = path_below(path_below('components', component), 'plan');
  const is_on = use_store(page.dragged)[plan] === true;
  const has_operations =
    page.tool(Pruning).operations_of(component).length > 0 ||
    value_at(tree, path_below(path_below('components', component), 'training')) !== undefined;
  if (!has_operations) return null;
  return (
    <Button
      is_open={is_on}
      tip="The tree before the cuts of its last year, which are only planned; Escape goes back"
      press={() => (is_on ? page.stop_drag() : page.drag({ [plan]: true }))}
    >
      {is_on ? 'After the last cuts' : 'Before the last cuts'}
    </Button>
  );
}

function Years({ component }: { component: string }): ReactElement {
  const page = use_page();
  use_document();
  const pruning = page.tool(Pruning);
  const told = use_store(pruning.told);
  const looked_at = use_store(pruning.looked_at);
  const list = list_path(component);
  const operations = pruning.operations_of(component);
  const years = told?.component === component ? years_of(told.operations.acts, operations, list) : [];
  if (years.length === 0) return <p className="empty">Nothing has been done to the trees up to the year on show.</p>;
  const name_of = (path: string): string => {
    const operation = operations[index_in(list, path)];
    if (operation !== undefined) return what_of(operation);
    const trained = told?.operations.training?.[index_in(trained_path(component), path)];
    return trained === undefined ? 'training' : `training: ${what_of(trained)}`;
  };
  const entry = ({ path, act, count }: PlanYear['seasons'][number]['entries'][number], year: number): ReactElement => (
    <li key={`${path} ${act}`}>
      <button
        type="button"
        className="plan-entry"
        aria-pressed={looked_at?.path === path && looked_at.iteration === year}
        onClick={() => pruning.look_at(path, year)}
      >
        <span className={`act-dot of-${act}`} aria-hidden="true" />
        <span className="plan-count">{counted_act(count, act)}</span>
        <span className="plan-name" data-tip={name_of(path)}>
          {name_of(path)}
        </span>
      </button>
    </li>
  );
  return (
    <ol className="plan-years" aria-label="Years in which operations acted">
      {years.map(({ year, seasons }) => (
        <li key={year}>
          <h3>Year {year}</h3>
          {seasons.map(({ season, entries }) => (
            <div key={season} className="plan-season">
              <h4>{season}</h4>
              <ul>{entries.map((one) => entry(one, year))}</ul>
            </div>
          ))}
        </li>
      ))}
    </ol>
  );
}
