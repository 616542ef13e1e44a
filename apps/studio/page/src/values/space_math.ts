// SPDX-License-Identifier: Apache-2.0
// Positions and frames of the world, and intersections with lines of sight. Rotations are as in documents: roll about
// y, then pitch about x, then yaw about z, in degrees.

import type { Vec } from '../base/vec.ts';

export type { Vec };

/// A frame: its axes x, y and z, which may be scaled, and its origin.
export interface Frame3 {
  axes: readonly [Vec, Vec, Vec];
  origin: Vec;
}

export interface Ray {
  origin: Vec;
  way: Vec; // unit vector
}

export const kWorld: Frame3 = {
  axes: [
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
  ],
  origin: [0, 0, 0],
};

export const add = (a: Vec, b: Vec): Vec => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
export const minus = (a: Vec, b: Vec): Vec => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const times = (a: Vec, by: number): Vec => [a[0] * by, a[1] * by, a[2] * by];
export const dot = (a: Vec, b: Vec): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross = (a: Vec, b: Vec): Vec => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];
export const length = (a: Vec): number => Math.hypot(...a);

export function unit(a: Vec, otherwise: Vec = [0, 1, 0]): Vec {
  const long = length(a);
  return long > 1e-12 ? times(a, 1 / long) : otherwise;
}

/// Returns a unit vector perpendicular to another one, horizontal if possible.
export function beside(way: Vec): Vec {
  return Math.hypot(way[0], way[2]) < 1e-6 * length(way) ? [1, 0, 0] : unit(cross(way, [0, 1, 0]));
}

export function vector_in({ axes }: Frame3, v: Vec): Vec {
  return add(add(times(axes[0], v[0]), times(axes[1], v[1])), times(axes[2], v[2]));
}

export function point_in(frame: Frame3, point: Vec): Vec {
  return add(frame.origin, vector_in(frame, point));
}

/// Returns a vector of the world as a vector of a frame.
export function vector_out({ axes }: Frame3, v: Vec): Vec {
  const [x, y, z] = axes;
  const volume = dot(x, cross(y, z)) || 1;
  return [dot(v, cross(y, z)) / volume, dot(v, cross(z, x)) / volume, dot(v, cross(x, y)) / volume];
}

export function framed(outer: Frame3, inner: Frame3): Frame3 {
  return {
    axes: [vector_in(outer, inner.axes[0]), vector_in(outer, inner.axes[1]), vector_in(outer, inner.axes[2])],
    origin: point_in(outer, inner.origin),
  };
}

/// Returns the frame of twelve numbers, three rows of [axes, origin].
export function frame_of_rows(rows: readonly number[]): Frame3 {
  const at = (row: number, column: number): number => rows[4 * row + column] ?? 0;
  const column = (k: number): Vec => [at(0, k), at(1, k), at(2, k)];
  return { axes: [column(0), column(1), column(2)], origin: column(3) };
}

const sine = (degrees: number): number => Math.sin((degrees * Math.PI) / 180);
const cosine = (degrees: number): number => Math.cos((degrees * Math.PI) / 180);

/// Returns a vector rotated about an axis through the origin, counter-clockwise seen against the axis.
export function turned(v: Vec, axis: Vec, degrees: number): Vec {
  const [c, s] = [cosine(degrees), sine(degrees)];
  return add(add(times(v, c), times(cross(axis, v), s)), times(axis, dot(axis, v) * (1 - c)));
}

/// Returns the axes x, y and z after the rotations of a document.
export function turn_of([pitch, roll, yaw]: Vec): [Vec, Vec, Vec] {
  const of = (v: Vec): Vec => turned(turned(turned(v, [0, 1, 0], roll), [1, 0, 0], pitch), [0, 0, 1], yaw);
  return [of([1, 0, 0]), of([0, 1, 0]), of([0, 0, 1])];
}

/// Returns the rotations of a document that turn x, y and z to these axes.
export function turns_to([x, y, z]: readonly [Vec, Vec, Vec]): Vec {
  const degrees = 180 / Math.PI;
  const pitch = Math.asin(Math.min(1, Math.max(-1, y[2])));
  // At a pitch of straight up or down, roll and yaw turn about one axis; all of it is then a yaw.
  if (Math.abs(y[2]) > 1 - 1e-9) return [pitch * degrees, 0, Math.atan2(x[1], x[0]) * degrees];
  return [pitch * degrees, Math.atan2(-x[2], z[2]) * degrees, Math.atan2(-y[0], y[1]) * degrees];
}

/// Returns the distance along a line to its nearest point to a line of sight. Returns null if both are nearly parallel.
export function along_line(ray: Ray, at: Vec, way: Vec): number | null {
  const cosine_between = dot(ray.way, way);
  const apart = 1 - cosine_between * cosine_between;
  if (apart < 1e-4) return null;
  const between = minus(at, ray.origin);
  return (cosine_between * dot(ray.way, between) - dot(way, between)) / apart;
}

/// Returns the point where a line of sight meets a plane. Returns null behind the camera, or if both are nearly
/// parallel.
export function on_plane(ray: Ray, at: Vec, normal: Vec): Vec | null {
  const falls = dot(ray.way, normal);
  if (Math.abs(falls) < 0.02) return null;
  const distance = dot(minus(at, ray.origin), normal) / falls;
  return distance > 0 ? add(ray.origin, times(ray.way, distance)) : null;
}

/// Returns the angle of a point about an axis, degrees from the axis's own zero.
export function angle_about(axis: Vec, centre: Vec, point: Vec): number {
  const zero = beside(axis);
  const side = cross(axis, zero);
  const way = minus(point, centre);
  return (Math.atan2(dot(way, side), dot(way, zero)) * 180) / Math.PI;
}
