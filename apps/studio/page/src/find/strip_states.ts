// SPDX-License-Identifier: Apache-2.0
// The few values of a row that a strip shows plants for, and values by chance.
import { fitting_step, rounded } from '../document/arithmetic.ts';
import type { Json } from '../document/json.ts';
import type { Variable } from '../server/protocol.ts';
import type { Row } from '../tables/tables.ts';
import { within_hard_range } from '../tables/tables.ts';

export interface StripState {
  value: Json;
  text: string;
}

const kCount = 5;
const kMostChoices = 8;

/// Five values over a range, its ends included; fewer where whole numbers have no room for five.
export function values_over(low: number, high: number, is_whole: boolean): number[] {
  if (!(high > low)) return [];
  const step = fitting_step(low, high, 100);
  const values = Array.from({ length: kCount }, (_, k) => low + ((high - low) * k) / (kCount - 1));
  return [...new Set(values.map((one) => (is_whole ? Math.round(one) : rounded(one, step))))];
}

/// Nothing where the value is no plain one, or the row has no range.
export function strip_states(row: Row, value: Json | undefined): StripState[] {
  const state = (one: Json): StripState => ({ value: one, text: typeof one === 'string' ? one.replaceAll('_', ' ') : String(one) });
  if (row.kind === 'boolean') return [false, true].map((one) => ({ value: one, text: one ? 'yes' : 'no' }));
  if (row.kind === 'choice') return (row.choices ?? []).length <= kMostChoices ? (row.choices ?? []).map(state) : [];
  if ((row.kind !== 'number' && row.kind !== 'integer') || !row.usual) return [];
  if (value !== undefined && value !== null && typeof value !== 'number') return [];
  return [...new Set(values_over(row.usual[0], row.usual[1], row.kind === 'integer').map((one) => within_hard_range(row, one)))].map(state);
}

/// The same for a variable, over the range that its author gave.
export function variable_states(variable: Variable, step: number): StripState[] {
  return values_over(variable.min, variable.max, step === 1).map((value) => ({ value, text: String(value) }));
}

/// Random values for variables, each within its range. `random` gives numbers from 0 to 1.
export function values_by_chance(variables: readonly Variable[], step_of: (variable: Variable) => number, random: () => number): Record<string, number> {
  return Object.fromEntries(variables.map((one) => [one.name, rounded(one.min + random() * (one.max - one.min), step_of(one))]));
}
