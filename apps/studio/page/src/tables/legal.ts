// SPDX-License-Identifier: Apache-2.0
// The values that a row allows, and the nearest allowed value to another one.
import type { Json, JsonNode } from '../values/json.ts';
import { is_object } from '../values/json.ts';
import { path_of, steps_of } from '../values/path.ts';
import { row_at } from './resolve.ts';
import type { NumberRange, Row, Tables } from './tables.ts';
import { table_of, within_hard_range } from './tables.ts';

const kAlong: NumberRange = { min: 0, max: 1 }; // range of the first numbers of a curve

/// Returns the ranges of the two numbers of each point of a row.
export function ranges_of_points(
  row: Pick<Row, 'kind' | 'min' | 'above' | 'max' | 'second'>,
): readonly [NumberRange, NumberRange] {
  return row.kind === 'curve' ? [kAlong, row] : [row, row.second ?? row];
}

/// Returns the value with each number moved into its range. Texts, such as expressions, are not changed.
export function legal_value(row: Row, value: Json): Json {
  if (row.kind !== 'points' && row.kind !== 'curve') return within(row, value);
  const [first, second] = ranges_of_points(row);
  const points = (list: Json): Json =>
    Array.isArray(list)
      ? list.map((one) => (Array.isArray(one) ? one.map((number, k) => within(k === 0 ? first : second, number)) : one))
      : list;
  return is_object(value) ? { ...value, curve: points(value['curve'] ?? []) } : points(value);
}

/// Applies the range to all numbers of lists, and to ranges with an expression.
function within(range: NumberRange, value: Json): Json {
  if (typeof value === 'number') return within_hard_range(range, value);
  if (Array.isArray(value)) return value.map((one) => within(range, one));
  return is_object(value) && Array.isArray(value['range']) ? { ...value, range: within(range, value['range']) } : value;
}

/// Returns values by their paths, each as its row allows it. Values without a row, such as variables, are not changed.
export function legal_values(
  tables: Tables,
  tree: JsonNode | null,
  values: Readonly<Record<string, Json>>,
): Record<string, Json> {
  const legal = (path: string, value: Json): Json => {
    const row = row_of_value(tables, tree, path, value);
    return row ? legal_value(row, value) : value;
  };
  return Object.fromEntries(Object.entries(values).map(([path, value]) => [path, legal(path, value)]));
}

/// Returns the row with the rules for a value. A plain value at an object's path belongs to the shorthand of its table.
export function row_of_value(tables: Tables, tree: JsonNode | null, path: string, value: Json): Row | null {
  const own = row_at(tables, tree, path);
  // Row of the list or the map that contains the element
  const holder = own ?? row_at(tables, tree, path_of(steps_of(path).slice(0, -1)));
  if (holder?.table === undefined) return holder;
  if (is_object(value)) return own;
  const table = table_of(tables, holder.table);
  return table.rows.find((row) => row.name === table.shorthand) ?? null;
}
