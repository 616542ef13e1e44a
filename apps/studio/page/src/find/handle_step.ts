// SPDX-License-Identifier: Apache-2.0

import type { Variable } from '../server/protocol.ts';
import { fitting_step } from '../values/arithmetic.ts';

/// Returns the step of a handle. Whole numbers are used if the range and the value are whole and the range is long
/// enough.
export function step_of(variable: Variable): number {
  const { min, max, value } = variable;
  const is_whole = [min, max, value].every(Number.isInteger) && max - min >= 5;
  return is_whole ? 1 : fitting_step(min, max, 200);
}
