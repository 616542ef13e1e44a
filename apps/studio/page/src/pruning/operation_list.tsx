// SPDX-License-Identifier: Apache-2.0
// The operations of a component in their order, each with its buttons. The chosen operation shows its rows.
import type { ReactElement } from 'react';

import { use_store } from '../base/store.ts';
import { IconButton } from '../controls/button.tsx';
import { Faults } from '../controls/faults.tsx';
import { PinList } from '../find/pins.ts';
import { use_document, use_page } from '../page/use_page.ts';
import { use_faults } from '../rows/row_actions.ts';
import { TableRows } from '../rows/table_rows.tsx';
import { groups_at } from '../tables/resolve.ts';
import type { ParameterTable } from '../tables/tables.ts';
import { table_of } from '../tables/tables.ts';
import type { Json } from '../values/json.ts';
import { member_of, path_below } from '../values/path.ts';
import { is_off, times_of, what_of, when_of } from './operation_text.ts';
import { list_path, Pruning, trained_path } from './pruning.ts';

export function OperationList({ component }: { component: string }): ReactElement {
  const page = use_page();
  use_document();
  const operations = page.tool(Pruning).operations_of(component);
  return (
    <>
      <TrainedList component={component} />
      {operations.length === 0 && (
        <p className="empty">
          No operations of its own yet. Click a shoot of {component} in the view, or press Enter there, to cut, bend,
          tie or mark it.
        </p>
      )}
      {operations.length > 0 && (
        <ol className="plan-list" aria-label={`Operations of ${component}`}>
          {operations.map((operation, index) => (
            <OperationItem
              key={index}
              component={component}
              operation={operation}
              index={index}
              count={operations.length}
            />
          ))}
        </ol>
      )}
    </>
  );
}

/// The operations that the component's training stands for. The training's rows in the inspector change them.
function TrainedList({ component }: { component: string }): ReactElement | null {
  const pruning = use_page().tool(Pruning);
  const told = use_store(pruning.told);
  const looked_at = use_store(pruning.looked_at);
  const operations = told?.component === component ? (told.operations.training ?? []) : [];
  if (operations.length === 0) return null;
  return (
    <>
      <h3 data-tip="The rows of the training in the inspector change these operations">Of its training</h3>
      <ol className="plan-list" aria-label={`Operations of the training of ${component}`}>
        {operations.map((operation, index) => {
          const path = path_below(trained_path(component), index);
          const times = times_of(told?.operations.acts ?? [], path);
          return (
            <li key={index} className={`plan-item${looked_at?.path === path ? ' chosen' : ''}`}>
              <OperationChoice operation={operation} path={path} state={times > 0 ? counted_times(times) : ''} />
            </li>
          );
        })}
      </ol>
      <h3>Its own</h3>
    </>
  );
}

/// An operation as text. A click shows it in the view and, if `opens`, its rows.
function OperationChoice({
  operation,
  path,
  state,
  opens = false,
}: {
  operation: Json;
  path: string;
  state: string;
  opens?: boolean;
}): ReactElement {
  const pruning = use_page().tool(Pruning);
  const is_chosen = use_store(pruning.looked_at)?.path === path;
  return (
    <button
      type="button"
      className="plan-choice"
      {...(opens ? { 'aria-expanded': is_chosen } : { 'aria-pressed': is_chosen })}
      onClick={() => pruning.look_at(path, null)}
    >
      <span className="plan-name">{what_of(operation)}</span>
      <span className="quiet">
        {when_of(operation)}
        {state !== '' && `; ${state}`}
      </span>
    </button>
  );
}

function counted_times(times: number): string {
  return `acted ${times} time${times === 1 ? '' : 's'}`;
}

interface OperationItemProps {
  component: string;
  operation: Json;
  index: number;
  count: number;
}

function OperationItem({ component, operation, index, count }: OperationItemProps): ReactElement {
  const page = use_page();
  const pruning = page.tool(Pruning);
  const pins = page.tool(PinList);
  const told = use_store(pruning.told);
  const pinned = use_store(pins.shown);
  const path = path_below(list_path(component), index);
  const looked_at = use_store(pruning.looked_at);
  const is_chosen = looked_at?.path === path;
  const is_dim = is_off(operation);
  const times = told?.component === component ? times_of(told.operations.acts, path) : null;
  const faults = use_faults(path);
  const name = `operation ${index + 1}`;
  return (
    <li className={`plan-item${is_chosen ? ' chosen' : ''}${is_dim ? ' off' : ''}`}>
      <div className="plan-line">
        <OperationChoice
          operation={operation}
          path={path}
          state={is_dim ? 'off' : times === null ? '' : times === 0 ? 'has not acted' : counted_times(times)}
          opens
        />
        <span className="plan-buttons">
          <IconButton
            is_small
            icon="up"
            label={`Move ${name} up`}
            is_off={index === 0}
            press={() => pruning.move(component, index, index - 1)}
          />
          <IconButton
            is_small
            icon="down"
            label={`Move ${name} down`}
            is_off={index === count - 1}
            press={() => pruning.move(component, index, index + 1)}
          />
          <IconButton
            is_small
            icon={is_dim ? 'eye_off' : 'eye'}
            label={`Let ${name} act`}
            is_on={!is_dim}
            press={() => pruning.switch_off(path, !is_dim)}
          />
          <IconButton
            is_small
            icon="pin"
            label={`Pin the state without ${name} beside the view`}
            is_off={is_dim || pinned.length >= 2}
            press={() => pruning.pin_without(path)}
          />
          <IconButton is_small icon="bin" label={`Remove ${name}`} press={() => pruning.remove(path)} />
        </span>
      </div>
      <Faults faults={faults} />
      {is_chosen && <OperationRows component={component} operation={operation} path={path} />}
    </li>
  );
}

function OperationRows({
  component,
  operation,
  path,
}: {
  component: string;
  operation: Json;
  path: string;
}): ReactElement | null {
  const page = use_page();
  const { tree } = use_document();
  const row = groups_at(page.tables, tree, path_below('components', component))
    .flatMap(({ rows }) => rows)
    .find((one) => one.name === 'operations');
  const kind = row?.kinds && member_of(operation, row.kinds.key);
  const table: ParameterTable | null =
    row?.kinds && typeof kind === 'string' ? table_of(page.tables, row.kinds.tables[kind] ?? '') : null;
  return (
    table && (
      <div className="plan-rows inspector">
        <TableRows table={table} path={path} value={operation} without={row?.kinds?.key ?? ''} />
      </div>
    )
  );
}
