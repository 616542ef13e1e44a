// SPDX-License-Identifier: Apache-2.0
import type { Json } from '../document/json.ts';

/// Where one more position of a list stands: as far behind the last as that is behind the one before it. The second of
/// a list stands a metre beside the first, and the first a metre up.
export function next_position(positions: readonly Json[]): Json {
  const [before, last] = [numbers_of(positions.at(-2)), numbers_of(positions.at(-1))];
  if (!last) return [0, 1, 0];
  const step = before ? last.map((one, axis) => one - (before[axis] ?? 0)) : [1, 0, 0];
  const stands = step.every((one) => one === 0);
  return last.map((one, axis) => Number((one + (stands && axis === 0 ? 1 : (step[axis] ?? 0))).toPrecision(9)));
}

/// Null where an expression stands in place of a number.
function numbers_of(position: Json | undefined): number[] | null {
  const numbers = Array.isArray(position) ? position.filter((one) => typeof one === 'number') : [];
  return numbers.length === 3 ? numbers : null;
}
