// SPDX-License-Identifier: Apache-2.0
// Grips of the view: their movement by the pointer or the arrow keys, and the resulting values of the document.
import { rounded } from '../values/arithmetic.ts';
import type { Json } from '../values/json.ts';
import type { Ray, Vec } from '../values/space_math.ts';
import { add, along_line, angle_about, minus, on_plane, times } from '../values/space_math.ts';

/// Values by their paths.
export type Values = Record<string, Json>;

/// The movement of a grip.
export interface Amount {
  by: Vec; // metres in the world
  degrees: number; // turn of a ring
  step: number; // step to which values are rounded: metres or degrees
}

export interface Grip {
  key: string; // key within its group
  label: string;
  motion: 'line' | 'plane' | 'ring' | 'free'; // free: perpendicular to the line of sight
  look: 'arrow' | 'square' | 'ring' | 'dot' | 'face';
  at: Vec; // position in the world
  way: Vec; // unit vector: the line, the normal of the plane, or the axis of the ring
  centre?: Vec; // centre of a ring
  said: string; // value as text
  now: number; // value as one number
  values: (amount: Amount) => Values;
}

/// A field for a number beside the view.
export interface GripField {
  label: string;
  unit: string;
  value: number;
  step: number;
  limit: (value: number) => number;
  values: (value: number) => Values;
}

/// The grips of one object: of a box, a lamp, a point of a wire.
export interface GripGroup {
  key: string; // path of its first row
  label: string;
  at: Vec;
  grips: Grip[];
  fields: GripField[];
  lines: Vec[][]; // outline in the world
}

/// The camera's directions, for grips that move perpendicular to the line of sight.
export interface Sight {
  right: Vec; // to the right of the screen, level
  toward: Vec; // toward the camera
  reach: number; // distance from the middle of a group to its outer grips, metres
}

export interface Hold {
  grip: Grip;
  start: Ray;
}

/// Returns the movement of a grip that was grabbed at `hold.start`, or null if it is undefined.
export function amount_of({ grip, start }: Hold, now: Ray, toward: Vec, step: number): Amount | null {
  const still: Amount = { by: [0, 0, 0], degrees: 0, step };
  if (grip.motion === 'line') {
    const [from, to] = [along_line(start, grip.at, grip.way), along_line(now, grip.at, grip.way)];
    return from === null || to === null ? null : { ...still, by: times(grip.way, to - from) };
  }
  if (grip.motion === 'ring') {
    const centre = grip.centre ?? grip.at;
    const [from, to] = [on_plane(start, centre, grip.way), on_plane(now, centre, grip.way)];
    if (!from || !to) return null;
    const turn = angle_about(grip.way, centre, to) - angle_about(grip.way, centre, from);
    return { ...still, degrees: ((turn + 540) % 360) - 180 };
  }
  const normal = grip.motion === 'free' ? toward : grip.way;
  const [from, to] = [on_plane(start, grip.at, normal), on_plane(now, grip.at, normal)];
  return from && to ? { ...still, by: minus(to, from) } : null;
}

/// Returns the movement by an arrow key: along the grip's line, about its ring, or to the right and up in its plane.
export function amount_of_key(grip: Grip, [right, up]: readonly [number, number], sight: Sight, step: number): Amount {
  const still: Amount = { by: [0, 0, 0], degrees: 0, step };
  if (grip.motion === 'line') return { ...still, by: times(grip.way, (right + up) * step) };
  if (grip.motion === 'ring') return { ...still, degrees: (right + up) * step };
  const level = Math.abs(grip.way[1]) > 0.9 && grip.motion === 'plane';
  const across = grip.motion === 'plane' ? across_of(grip.way, sight.right) : sight.right;
  const upward: Vec = level ? [-sight.toward[0], 0, -sight.toward[2]] : [0, 1, 0];
  const long = Math.hypot(...upward) || 1;
  return { ...still, by: add(times(across, right * step), times(upward, (up * step) / long)) };
}

/// Returns the direction within a plane that points most to the right.
function across_of(normal: Vec, right: Vec): Vec {
  const away = right[0] * normal[0] + right[1] * normal[1] + right[2] * normal[2];
  const within = minus(right, times(normal, away));
  const long = Math.hypot(...within);
  return long > 1e-6 ? times(within, 1 / long) : right;
}

/// Returns a list of numbers, moved and rounded where they have moved.
export function moved_vector(from: Vec, by: Vec, step: number): number[] {
  return from.map((one, axis) => (Math.abs(by[axis] ?? 0) > 1e-12 ? rounded(one + (by[axis] ?? 0), step) : one));
}
