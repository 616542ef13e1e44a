// SPDX-License-Identifier: Apache-2.0
import type { Json } from '../values/json.ts';

/// Returns the position for a new element of a list. It continues the step between the last two positions. The second
/// element stands a metre beside the first, and the first a metre up.
export function next_position(positions: readonly Json[]): Json {
  const [before, last] = [numbers_of(positions.at(-2)), numbers_of(positions.at(-1))];
  if (!last) return [0, 1, 0];
  const step = before ? last.map((one, axis) => one - (before[axis] ?? 0)) : [1, 0, 0];
  const stands = step.every((one) => one === 0);
  return last.map((one, axis) => Number((one + (stands && axis === 0 ? 1 : (step[axis] ?? 0))).toPrecision(9)));
}

/// Returns the numbers of a position, or null if one of them is an expression.
function numbers_of(position: Json | undefined): number[] | null {
  const numbers = Array.isArray(position) ? position.filter((one) => typeof one === 'number') : [];
  return numbers.length === 3 ? numbers : null;
}
