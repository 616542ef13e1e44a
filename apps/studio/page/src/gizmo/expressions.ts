// SPDX-License-Identifier: Apache-2.0
// Numbers of a document that are written as expressions, or as ranges over instances. Grips stand at their present
// values. A drag moves a variable that stands alone; other expressions block the grip.

import type { Variable } from '../server/protocol.ts';
import type { ParameterTable, Tables } from '../tables/tables.ts';
import { as_object } from '../tables/tables.ts';
import type { Json } from '../values/json.ts';
import { path_below, steps_of } from '../values/path.ts';
import { value_within, with_value, with_values } from '../values/put_values.ts';
import type { Values } from './grip.ts';
import { nested_objects } from './nested_objects.ts';

/// The path of a number in the document with an expression instead.
export interface Expressed {
  path: string;
  written: Json;
  value: number; // present value
  variable: Variable | null; // the variable, if it stands alone
}

/// Values as they can be written, and expressions that block some of them.
export interface MeantValues {
  values: Values;
  held: Expressed[];
}

const kNumbers: ReadonlySet<string> = new Set(['number', 'integer']);
const kVectors: ReadonlySet<string> = new Set(['vector', 'facing', 'box', 'positions', 'points']);
const kMax = 1000; // maximum number of expressions in one request
const kStill = 1e-9; // a smaller difference counts as no movement

/// Returns the expressions that an object has instead of numbers, by their paths.
export function expressions_in(
  tables: Tables,
  row_tables: readonly ParameterTable[],
  value: Json | undefined,
  path: string,
): Map<string, Json> {
  const found = new Map<string, Json>();
  const note = (one: Json | undefined, at: string): void => {
    if (one !== undefined && one !== null && typeof one !== 'number' && found.size < kMax) found.set(at, one);
  };
  const visit_vector = (one: readonly Json[], at: string): void => {
    for (const [k, element] of one.entries()) {
      if (Array.isArray(element)) visit_vector(element, path_below(at, k));
      else note(element, path_below(at, k));
    }
  };
  const visit = (table: ParameterTable, object: { [name: string]: Json }, path_of: (row: string) => string): void => {
    for (const row of table.rows) {
      const said = object[row.name];
      const at = path_of(row.name);
      if (kNumbers.has(row.kind)) note(said, at);
      if (kVectors.has(row.kind) && Array.isArray(said)) visit_vector(said, at);
      for (const nested of nested_objects(tables, row, said, at)) visit(nested.table, nested.value, nested.path_of);
    }
  };
  for (const table of row_tables) visit(table, as_object(table, value), (name) => path_below(path, name));
  return found;
}

/// Returns the expressions with their present values, except unknown ones. `value_of` returns a variable's present
/// value; `told` has the values from the server.
export function expressed(
  found: ReadonlyMap<string, Json>,
  told: Readonly<Record<string, number>>,
  variables: readonly Variable[],
  value_of: (variable: Variable) => number,
): Expressed[] {
  return [...found].flatMap(([path, written]): Expressed[] => {
    const variable = variables.find((one) => one.name === written && one.expression === null) ?? null;
    const value = variable ? value_of(variable) : told[path];
    return value === undefined ? [] : [{ path, written, value, variable }];
  });
}

/// Returns the object with numbers at these paths.
export function with_numbers(value: Json | undefined, path: string, all: readonly Expressed[]): Json | undefined {
  return with_values(value, steps_of(path), Object.fromEntries(all.map((one) => [one.path, one.value])));
}

/// Returns the values for the document. Numbers that have not moved stay as they are written, and variables move
/// instead of their names. `written_at` returns the document's value at a path.
export function meant_values(
  values: Values,
  all: readonly Expressed[],
  written_at: (path: string) => Json | undefined,
): MeantValues {
  const meant: MeantValues = { values: {}, held: [] };
  for (const [path, value] of Object.entries(values)) {
    const within = all.filter((one) => one.path === path || one.path.startsWith(`${path}[`));
    let written = value;
    for (const one of within) {
      const rest = steps_of(one.path).slice(steps_of(path).length);
      const number = value_within(written, rest);
      if (typeof number === 'number' && Math.abs(number - one.value) > kStill) move(one, number, meant);
      written = with_value(written, rest, one.written);
    }
    if (within.length === 0 || JSON.stringify(written) !== JSON.stringify(written_at(path)))
      meant.values[path] = written;
  }
  return meant;
}

/// A variable cannot have two values at once.
function move(one: Expressed, number: number, meant: MeantValues): void {
  const { variable } = one;
  const wanted =
    variable && Math.min(Math.max(variable.max, one.value), Math.max(Math.min(variable.min, one.value), number));
  if (variable && wanted !== null && (meant.values[variable.name] ?? wanted) === wanted)
    meant.values[variable.name] = wanted;
  else meant.held.push(one);
}

/// Returns the expressions that block a grip, as text.
export function said_of_held(held: readonly Expressed[]): string {
  const said = held.map(({ path, written }) => {
    const value = typeof written === 'string' ? `the expression “${written}”` : JSON.stringify(written);
    return `${path.slice(path.indexOf('.') + 1)} is ${value}`;
  });
  return `${said.slice(0, 2).join(', ')}${said.length > 2 ? `, and ${said.length - 2} more` : ''}`;
}
