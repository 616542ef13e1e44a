// SPDX-License-Identifier: Apache-2.0
// Finds the rows at a path of a document.
import type { Json, JsonNode } from '../values/json.ts';
import { member_of, path_below, path_of, steps_of, value_at } from '../values/path.ts';
import type { Row, RowGroup, Tables } from './tables.ts';
import { component_groups, document_groups, document_parts, link_groups, table_of } from './tables.ts';

/// Returns the groups of rows of a part that can be chosen: a component, a link, a part of the document, or "" for its
/// top level.
export function groups_at(tables: Tables, tree: JsonNode | null, path: string): RowGroup[] {
  const [head, second] = steps_of(path);
  if (head === 'components' && second !== undefined) return component_groups(tables, text_at(tree, path, 'type'));
  if (head === 'links' && second !== undefined) return link_groups(tables, link_kind(value_at(tree, path)));
  if (head === 'variables' && second !== undefined)
    return [
      { title: 'Handle', table: table_of(tables, tables.variable), rows: table_of(tables, tables.variable).rows },
    ];
  return document_groups(tables, typeof head === 'string' && document_parts(tables).includes(head) ? head : '');
}

/// Returns the part that is chosen with a value at this path: its component, its link, or its part of the document.
/// Returns null if there is no such part.
export function chosen_with(tables: Tables, path: string): string | null {
  const [head, second] = steps_of(path);
  if (head === 'components' || head === 'links') return second === undefined ? null : path_of([head, second]);
  return typeof head === 'string' && document_parts(tables).includes(head) ? head : null;
}

function text_at(tree: JsonNode | null, path: string, name: string): string {
  const value = member_of(value_at(tree, path), name);
  return typeof value === 'string' ? value : '';
}

/// Returns the kind of a link. Short links and links without a kind are child links.
export function link_kind(link: Json | undefined): string {
  const kind = member_of(link, 'kind');
  return typeof kind === 'string' ? kind : '';
}

/// Returns all rows that an object at this path may have, for completion. The path may lie below a part that can be
/// chosen.
export function rows_at(tables: Tables, tree: JsonNode | null, path: string): Row[] {
  const steps = steps_of(path);
  const head = steps[0];
  if (head === undefined) return table_of(tables, tables.document).rows;
  if (head === 'variables') return steps.length === 2 ? table_of(tables, tables.variable).rows : [];
  const is_listed = head === 'components' || head === 'links';
  if (is_listed && steps.length < 2) return [];
  const first = is_listed ? 2 : 1;
  let at = path_of(steps.slice(0, first));
  let rows = groups_at(tables, tree, at).flatMap((one) => one.rows);
  let map: Row[] | null = null; // rows of a map's elements, whose names are free
  for (const step of steps.slice(first)) {
    at = path_below(at, step);
    if (typeof step === 'number') continue;
    if (map) {
      rows = map;
      map = null;
      continue;
    }
    const row = rows.find((one) => one.name === step);
    const nested = row ? nested_rows(tables, row, value_at(tree, at)) : [];
    map = row?.kind === 'map' ? nested : null;
    rows = map ? [] : nested;
  }
  return rows;
}

/// Returns the rows of the table within a row. For lists with several kinds, returns the rows of the value's kind.
export function nested_rows(tables: Tables, row: Row, value: Json | undefined): Row[] {
  if (row.table !== undefined) return table_of(tables, row.table).rows;
  if (!row.kinds) return [];
  const kind = member_of(value, row.kinds.key);
  const name = typeof kind === 'string' ? row.kinds.tables[kind] : undefined;
  const names = name === undefined ? Object.values(row.kinds.tables) : [name];
  return names.flatMap((one) => table_of(tables, one).rows);
}

/// Returns the row of the parameter at a path, which may begin with the name of a component. Returns null if the row
/// does not exist.
export function row_at(tables: Tables, tree: JsonNode | null, path: string): Row | null {
  for (const whole of [path, `components.${path}`]) {
    const steps = steps_of(whole);
    const row = rows_at(tables, tree, path_of(steps.slice(0, -1))).find((one) => one.name === steps.at(-1));
    if (row) return row;
  }
  return null;
}
