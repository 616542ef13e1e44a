// SPDX-License-Identifier: Apache-2.0
// One row of a table: its name with its sentence, an editor for its kind, its menu, and its faults.
import type { ReactElement } from 'react';
import { memo } from 'react';

import { use_part } from '../base/store.ts';
import { IconButton } from '../controls/button.tsx';
import { Faults } from '../controls/faults.tsx';
import type { MenuItem } from '../controls/menu.tsx';
import { Menu } from '../controls/menu.tsx';
import { Strip } from '../find/strip.tsx';
import { strip_states } from '../find/strip_states.ts';
import { use_page } from '../page/use_page.ts';
import type { ParameterTable, Row } from '../tables/tables.ts';
import { first_value } from '../tables/tables.ts';
import { can_have_keys, RowKeyButton } from '../time/key_button.tsx';
import { commit_keys, use_keyed } from '../time/use_keyed.ts';
import type { Json } from '../values/json.ts';
import { write_json } from '../values/json.ts';
import { path_below } from '../values/path.ts';
import { excluded_by } from './exclusion.ts';
import type { NumberForm } from './number_form.ts';
import { form_of, in_form } from './number_form.ts';
import { WrittenRow } from './plain_rows.tsx';
import { names_plant, PlantRow } from './plant_row.tsx';
import type { RowActions } from './row_actions.ts';
import { use_faults, use_row_actions, use_shown_value } from './row_actions.ts';
import { use_row_kinds } from './row_kinds.ts';

interface RowViewProps {
  table: ParameterTable; // table of the row
  row: Row;
  parent: string; // path of the object that contains the row
  parent_value: Json | undefined;
  value: Json | undefined;
}

/// The row is rendered again only if its object, its faults, or its temporary or keyed value change.
export const RowView = memo(function RowView({ table, row, parent, parent_value, value }: RowViewProps): ReactElement {
  const path = path_below(parent, row.name);
  const rivals = excluded_by(table, row.name, parent_value).map((name) => path_below(parent, name));
  const actions = use_row_actions(path, row.name, rivals);
  const shown = use_shown_value(path, value);
  const kinds = use_row_kinds();
  const Nested = kinds.nested[row.kind];
  const kind = kinds.editors[row.kind];
  const faults = use_faults(path, !Nested);
  const page = use_page();
  const has_strip = use_part(page.strip, (shown_at) => shown_at === path);
  const is_plant = use_part(page.document.state, ({ tree }) => names_plant(page.tables, tree, row, path));
  const keyed = use_keyed(path);
  const is_faulty = faults.some((fault) => fault.severity === 'error');
  if (Nested) return <Nested row={row} path={path} value={value} rivals={rivals} />;
  const Editor = is_plant ? PlantRow : (kind?.editor ?? WrittenRow);
  const is_tall = kind?.is_tall === true || (row.kind === 'number' && form_of(shown) !== 'number');
  const label = row.name.replaceAll('_', ' ');
  const states = strip_states(row, shown);
  const items = menu_of(row, value, actions, () => first_value(page.tables, row));
  if (keyed)
    items.push({
      text: 'Remove its keys',
      act: () => commit_keys(page, keyed.track.name, [], `Remove the keys of ${label}`),
    });
  const enlarge = kind?.can_be_large?.(row) ? (): void => page.enlarged.set(path) : null;
  return (
    <div
      className={`row${is_tall ? ' tall' : ''}${value === undefined ? ' unset' : ''}`}
      data-path={path}
      data-kind={row.kind}
    >
      {can_have_keys(row, path) && <RowKeyButton row={row} path={path} value={shown} />}
      <span className="row-name" data-tip={tip_of(row)} tabIndex={-1}>
        {label}
        {row.required && <span aria-hidden="true"> *</span>}
      </span>
      <div className="row-control">
        <Editor row={row} label={label} path={path} value={shown} actions={actions} is_faulty={is_faulty} />
      </div>
      <Menu label={`More for ${label}`} items={items} />
      {states.length > 1 && (
        <span className="row-extra">
          <IconButton
            is_small
            icon="strip"
            label={`Plants over ${label}`}
            is_on={has_strip}
            press={() => page.strip.set(has_strip ? null : path)}
          />
        </span>
      )}
      {enlarge && (
        <span className="row-extra">
          <IconButton is_small icon="enlarge" label={`Enlarge ${label}`} press={enlarge} />
        </span>
      )}
      <Faults faults={faults} />
      {has_strip && (
        <Strip label={label} path={path} value={shown ?? row.default} states={states} take={actions.commit} />
      )}
    </div>
  );
});

/// Returns the tooltip of a row: its sentence and its facts.
export function tip_of(row: Row): string {
  const facts: string[] = [];
  if (row.min !== undefined) facts.push(`at least ${row.min}`);
  if (row.above !== undefined) facts.push(`above ${row.above}`);
  if (row.max !== undefined) facts.push(`at most ${row.max}`);
  if (row.default !== undefined) facts.push(`default ${write_json(row.default)}`);
  if (row.required) facts.push('must be given');
  return `${row.doc}${facts.length > 0 ? `\n${facts.join(', ')}${row.unit ? ` (${row.unit})` : ''}` : ''}`;
}

const kForms: [NumberForm, string][] = [
  ['number', 'Number'],
  ['range', 'Range'],
  ['expression', 'Expression'],
  ['both', 'Range and expression'],
];

function menu_of(row: Row, value: Json | undefined, actions: RowActions, first: () => Json): MenuItem[] {
  const items: MenuItem[] = [];
  if (row.kind === 'number' || row.kind === 'integer') {
    const number = typeof value === 'number' ? value : typeof row.default === 'number' ? row.default : Number(first());
    for (const [form, text] of kForms) {
      // A number that is equal for all instances accepts an expression, but no range.
      if (row.varies === undefined && (form === 'range' || form === 'both')) continue;
      items.push({
        text,
        is_on: value !== undefined && form_of(value) === form,
        act: () => actions.commit(in_form(form, value, number)),
      });
    }
  }
  if (value === undefined) items.push({ text: 'Set', act: () => actions.commit(first()) });
  else {
    if (row.default !== undefined)
      items.push({ text: 'Set to default', act: () => actions.commit(row.default ?? null) });
    if (!row.required) items.push({ text: 'Unset', act: actions.unset });
  }
  return items;
}
