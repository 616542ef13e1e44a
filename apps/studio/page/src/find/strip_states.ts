// SPDX-License-Identifier: Apache-2.0
// The values of a row for which a strip shows plants, and random values.

import type { Variable } from '../server/protocol.ts';
import type { Row } from '../tables/tables.ts';
import { within_hard_range } from '../tables/tables.ts';
import { fitting_step, rounded } from '../values/arithmetic.ts';
import type { Json } from '../values/json.ts';
import { is_object } from '../values/json.ts';

export interface StripState {
  value: Json;
  text: string;
  tip?: string; // effect of the choice, if it is more than another number
}

const kCount = 5;
const kMaxChoices = 8;

/// Returns five values over a range, including its ends. Returns fewer if whole numbers leave no space for five.
export function values_over(low: number, high: number, is_whole: boolean): number[] {
  if (!(high > low)) return [];
  const step = fitting_step(low, high, 100);
  const values = Array.from({ length: kCount }, (_, k) => low + ((high - low) * k) / (kCount - 1));
  return [...new Set(values.map((one) => (is_whole ? Math.round(one) : rounded(one, step))))];
}

/// Returns the states of a strip. Returns an empty list if the row is neither a number nor a choice, or has no usual
/// range. A range keeps its width while its middle moves. An expression is replaced by a number.
export function strip_states(row: Row, value: Json | undefined): StripState[] {
  if (row.kind === 'boolean') return [false, true].map((one) => ({ value: one, text: one ? 'yes' : 'no' }));
  if (row.kind === 'choice')
    return (row.choices ?? []).length <= kMaxChoices ? (row.choices ?? []).map(plain_state) : [];
  if ((row.kind !== 'number' && row.kind !== 'integer') || !row.usual) return [];
  const middles = values_over(row.usual[0], row.usual[1], row.kind === 'integer');
  const ends = ends_of(value);
  if (ends) return distinct(middles.map((middle) => moved_range(row, ends, middle, value)));
  const states = distinct(middles.map((one) => plain_state(within_hard_range(row, one))));
  const written = expression_in(value);
  return written === null
    ? states
    : states.map((one) => ({ ...one, tip: `${one.text}, a number in place of ${written}` }));
}

function plain_state(one: Json): StripState {
  return { value: one, text: typeof one === 'string' ? one.replaceAll('_', ' ') : String(one) };
}

function distinct(states: StripState[]): StripState[] {
  return states.filter((one, k) => states.findIndex((other) => other.text === one.text) === k);
}

/// Returns the two numbers of a range, including a range with an expression.
function ends_of(value: Json | undefined): [number, number] | null {
  const range = is_object(value) ? value['range'] : value;
  if (!Array.isArray(range) || range.length !== 2) return null;
  const [first, last] = range;
  return typeof first === 'number' && typeof last === 'number' ? [first, last] : null;
}

/// Returns an expression as text, or null for plain numbers and missing values.
function expression_in(value: Json | undefined): string | null {
  if (value === undefined || value === null || typeof value === 'number') return null;
  return typeof value === 'string' ? `the expression ${value}` : 'the range with expressions';
}

/// Returns the range with another middle, within the limits of the row.
function moved_range(row: Row, [first, last]: [number, number], middle: number, value: Json | undefined): StripState {
  const half = (last - first) / 2;
  const [low, high] = [middle - Math.abs(half), middle + Math.abs(half)];
  const shift = within_hard_range(row, low) - low || within_hard_range(row, high) - high;
  const is_whole = row.kind === 'integer';
  const step = Math.min(
    fitting_step(row.usual?.[0] ?? 0, row.usual?.[1] ?? 1, 100),
    half === 0 ? Infinity : fitting_step(0, 2 * Math.abs(half), 100),
  );
  const end = (one: number): number => within_hard_range(row, is_whole ? Math.round(one) : rounded(one, step));
  const range = [end(middle + shift - half), end(middle + shift + half)];
  const text = `${range[0]}…${range[1]}`;
  return {
    value: is_object(value) ? { ...value, range } : range,
    text,
    tip: `${range[0]} to ${range[1]}: the middle moves, the width stays`,
  };
}

/// Returns the states of a variable over the range that its author gave.
export function variable_states(variable: Variable, step: number): StripState[] {
  const states = values_over(variable.min, variable.max, step === 1).map((value) => ({ value, text: String(value) }));
  return variable.expression === null
    ? states
    : states.map((one) => ({ ...one, tip: `${one.text}, a number in place of the expression ${variable.expression}` }));
}

/// Returns random values for variables, each within its range. `random` returns numbers from 0 to 1.
export function values_by_chance(
  variables: readonly Variable[],
  step_of: (variable: Variable) => number,
  random: () => number,
): Record<string, number> {
  return Object.fromEntries(
    variables.map((one) => [one.name, rounded(one.min + random() * (one.max - one.min), step_of(one))]),
  );
}
