// SPDX-License-Identifier: Apache-2.0
// The objects that a row of a table holds: one object, a list, or several by name.

import type { ParameterTable, Row, Tables } from '../tables/tables.ts';
import { as_object, table_of } from '../tables/tables.ts';
import type { Json } from '../values/json.ts';
import { is_object } from '../values/json.ts';
import { path_below } from '../values/path.ts';

export interface NestedObject {
  table: ParameterTable;
  value: { [name: string]: Json };
  path: string;
  step: string | number | null; // index or name in a list or a map
  path_of: (row: string) => string;
}

export function nested_objects(tables: Tables, row: Row, said: Json | undefined, path: string): NestedObject[] {
  if (said === undefined || said === null) return [];
  if (row.kind === 'object') return nested_object(tables, row, said, path, null);
  if (row.kind === 'list' && Array.isArray(said))
    return said.flatMap((one, k) => nested_object(tables, row, one, path_below(path, k), k));
  if (row.kind === 'map' && is_object(said))
    return Object.entries(said).flatMap(([name, one]) => nested_object(tables, row, one, path_below(path, name), name));
  return [];
}

function nested_object(
  tables: Tables,
  row: Row,
  value: Json,
  path: string,
  step: string | number | null,
): NestedObject[] {
  const table = nested_table(tables, row, value);
  const is_short = !is_object(value);
  return table
    ? [
        {
          table,
          value: as_object(table, value),
          path,
          step,
          path_of: (name) => (is_short ? path : path_below(path, name)),
        },
      ]
    : [];
}

function nested_table(tables: Tables, row: Row, value: Json): ParameterTable | null {
  const kind = row.kinds && is_object(value) ? value[row.kinds.key] : undefined;
  const name = row.kinds ? (typeof kind === 'string' ? row.kinds.tables[kind] : undefined) : row.table;
  return name === undefined ? null : table_of(tables, name);
}
