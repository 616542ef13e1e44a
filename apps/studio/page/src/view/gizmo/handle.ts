// SPDX-License-Identifier: Apache-2.0
// Handles of the view: what a hand or the arrow keys move, and which values of the document that means.
import { rounded } from '../../document/arithmetic.ts';
import type { Json } from '../../document/json.ts';
import type { Ray, Vec } from './space_math.ts';
import { add, along_line, angle_about, minus, on_plane, times } from './space_math.ts';

/// Values by their paths.
export type Values = Record<string, Json>;

/// How far a handle was moved.
export interface Amount {
  by: Vec; // metres in the world
  degrees: number; // of a ring
  step: number; // to which values are rounded: metres or degrees
}

export interface Handle {
  key: string; // within its group
  label: string;
  motion: 'line' | 'plane' | 'ring' | 'free'; // free: across the line of sight
  look: 'arrow' | 'square' | 'ring' | 'dot' | 'face';
  at: Vec; // in the world
  way: Vec; // unit: of the line, the normal of the plane, the axis of the ring
  centre?: Vec; // of a ring
  said: string; // its value in words
  now: number; // its value as one number
  values: (amount: Amount) => Values;
}

/// A number beside the view.
export interface HandleField {
  label: string;
  unit: string;
  value: number;
  step: number;
  limit: (value: number) => number;
  values: (value: number) => Values;
}

/// The handles of one thing: of a box, a lamp, a point of a wire.
export interface HandleGroup {
  key: string; // path of its first row
  label: string;
  at: Vec;
  handles: Handle[];
  fields: HandleField[];
  lines: Vec[][]; // its outline in the world
}

/// What the view looks like, for handles that lie across the line of sight.
export interface Sight {
  right: Vec; // of the screen, level
  toward: Vec; // the eye
  reach: number; // metres from the middle of a group to its outer handles
}

export interface Grip {
  handle: Handle;
  start: Ray;
}

/// How far the hand has moved a handle that it took hold of at `grip.start`; null where that cannot be told.
export function amount_of({ handle, start }: Grip, now: Ray, toward: Vec, step: number): Amount | null {
  const still: Amount = { by: [0, 0, 0], degrees: 0, step };
  if (handle.motion === 'line') {
    const [from, to] = [along_line(start, handle.at, handle.way), along_line(now, handle.at, handle.way)];
    return from === null || to === null ? null : { ...still, by: times(handle.way, to - from) };
  }
  if (handle.motion === 'ring') {
    const centre = handle.centre ?? handle.at;
    const [from, to] = [on_plane(start, centre, handle.way), on_plane(now, centre, handle.way)];
    if (!from || !to) return null;
    const turn = angle_about(handle.way, centre, to) - angle_about(handle.way, centre, from);
    return { ...still, degrees: ((turn + 540) % 360) - 180 };
  }
  const normal = handle.motion === 'free' ? toward : handle.way;
  const [from, to] = [on_plane(start, handle.at, normal), on_plane(now, handle.at, normal)];
  return from && to ? { ...still, by: minus(to, from) } : null;
}

/// What an arrow key moves: along its line, about its ring, or to the right and up on its plane.
export function amount_of_key(handle: Handle, [right, up]: readonly [number, number], sight: Sight, step: number): Amount {
  const still: Amount = { by: [0, 0, 0], degrees: 0, step };
  if (handle.motion === 'line') return { ...still, by: times(handle.way, (right + up) * step) };
  if (handle.motion === 'ring') return { ...still, degrees: (right + up) * step };
  const level = Math.abs(handle.way[1]) > 0.9 && handle.motion === 'plane';
  const across = handle.motion === 'plane' ? across_of(handle.way, sight.right) : sight.right;
  const upward: Vec = level ? [-sight.toward[0], 0, -sight.toward[2]] : [0, 1, 0];
  const long = Math.hypot(...upward) || 1;
  return { ...still, by: add(times(across, right * step), times(upward, (up * step) / long)) };
}

/// The way within a plane that runs most to the right.
function across_of(normal: Vec, right: Vec): Vec {
  const away = right[0] * normal[0] + right[1] * normal[1] + right[2] * normal[2];
  const within = minus(right, times(normal, away));
  const long = Math.hypot(...within);
  return long > 1e-6 ? times(within, 1 / long) : right;
}

/// A list of numbers, moved and rounded where they were moved.
export function moved_vector(from: Vec, by: Vec, step: number): number[] {
  return from.map((one, axis) => (Math.abs(by[axis] ?? 0) > 1e-12 ? rounded(one + (by[axis] ?? 0), step) : one));
}
