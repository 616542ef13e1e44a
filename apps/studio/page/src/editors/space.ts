// SPDX-License-Identifier: Apache-2.0
// Points of space in two pictures side by side: from the front, with x to the right and y up, and from the right or
// from above.
import type { Vec } from '../base/vec.ts';
import { fitting_step, rounded } from '../values/arithmetic.ts';
import type { Json } from '../values/json.ts';
import type { Frame, Point, Range } from './shape.ts';

/// One of the pictures: the coordinates that point right and up in it, and whether they are mirrored.
export interface Side {
  name: string;
  across: 0 | 1 | 2;
  up: 0 | 1 | 2;
  signs: readonly [1 | -1, 1 | -1];
}

export const kSides: readonly [Side, Side, Side] = [
  { name: 'from the south', across: 0, up: 1, signs: [1, 1] },
  { name: 'from the east', across: 2, up: 1, signs: [-1, 1] },
  { name: 'from above', across: 0, up: 2, signs: [1, -1] },
];

const kWays = ['x', 'y', 'z'] as const;

/// Returns the names of a picture's directions. A coordinate that falls to the right has a minus sign.
export function names_of(side: Side): readonly [string, string] {
  const name = (axis: 0 | 1 | 2, sign: 1 | -1): string => `${sign < 0 ? '−' : ''}${kWays[axis]}`;
  return [name(side.across, side.signs[0]), name(side.up, side.signs[1])];
}

/// Returns the positions of a value, or null if it has expressions.
export function places_of(value: Json | undefined): Vec[] | null {
  if (!Array.isArray(value)) return null;
  const places = value.filter(
    (one): one is [number, number, number] =>
      Array.isArray(one) && one.length === 3 && one.every((number) => typeof number === 'number'),
  );
  return places.length === value.length ? places : null;
}

export function seen_from(side: Side, place: Vec): Point {
  return [side.signs[0] * place[side.across], side.signs[1] * place[side.up]];
}

/// Returns a position moved to a point of the picture. The coordinate that the picture does not show stays.
export function moved_in(side: Side, place: Vec, [across, up]: Point, digits: number): Vec {
  const made: [number, number, number] = [place[0], place[1], place[2]];
  made[side.across] = rounded(side.signs[0] * across, digits);
  made[side.up] = rounded(side.signs[1] * up, digits);
  return made;
}

/// Returns the legal values of the two coordinates of a picture, if each coordinate has the range `range`.
export function limits_from({ signs }: Side, { low, high }: Range): Frame {
  const way = (sign: 1 | -1): Range => (sign > 0 ? { low, high } : { low: -high, high: -low });
  return { x: way(signs[0]), y: way(signs[1]) };
}

/// Returns a frame of the picture. All pictures show as much space, so that distances look equal in them.
export function frame_from(side: Side, places: readonly Vec[]): Frame {
  const extents = [0, 1, 2].map((axis) => range_of(places.map((one) => one[axis] ?? 0)));
  const widest = Math.max(...extents.map((one) => one.high - one.low), 1e-6);
  const around = (axis: number, sign: number): Range => {
    const { low, high } = extents[axis] ?? { low: 0, high: 1 };
    const middle = (sign * (low + high)) / 2;
    return { low: middle - 0.58 * widest, high: middle + 0.58 * widest };
  };
  return { x: around(side.across, side.signs[0]), y: around(side.up, side.signs[1]) };
}

function range_of(numbers: readonly number[]): Range {
  const [low, high] = [Math.min(0, ...numbers), Math.max(0, ...numbers)];
  return high > low ? { low, high } : { low: low - 0.5, high: high + 0.5 };
}

/// Returns the step of arrow keys: about a hundredth of the extent of all positions.
export function step_of(places: readonly Vec[]): number {
  const { x } = frame_from(kSides[0], places);
  return fitting_step(x.low, x.high, 100);
}
