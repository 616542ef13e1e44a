// SPDX-License-Identifier: Apache-2.0
// Curves and outlines as documents write them: how they run between their points, and how points move.
import { rounded } from '../document/arithmetic.ts';
import type { Json } from '../document/json.ts';
import { is_object } from '../document/json.ts';

export type Point = readonly [number, number];
export type Joining = 'spline' | 'linear';

export interface Range {
  low: number;
  high: number;
}

/// What points are together: a function of x, whose points rise in it; a line; a ring, whose last point is joined to the
/// first; one side of something that is alike on both sides of x = 0; or the profile of what is turned about x = 0, a
/// spline of radius over height, whose points rise.
export type Form = 'function' | 'line' | 'polygon' | 'silhouette' | 'profile';

export interface Shape {
  points: Point[];
  joining: Joining;
  form: Form;
}

/// Nothing where it is written otherwise, as with expressions. `together` is what the row's table says of its points.
export function shape_of(value: Json | undefined, together: Form = 'line'): Shape | null {
  const is_function = is_object(value);
  const points = points_of(is_function ? value['curve'] : value);
  if (!points) return null;
  const joining = !is_function || value['kind'] === 'linear' ? 'linear' : 'spline';
  return { points, joining, form: is_function ? 'function' : together };
}

/// The fewest points that a shape may have.
export function least_points({ form }: Shape): number {
  return { function: 1, line: 2, polygon: 3, silhouette: 2, profile: 2 }[form];
}

function points_of(list: Json | undefined): Point[] | null {
  if (!Array.isArray(list) || list.length === 0) return null;
  const points = list.filter((one): one is [number, number] => Array.isArray(one) && one.length === 2 && one.every((number) => typeof number === 'number'));
  return points.length === list.length ? points : null;
}

/// As it is written; of a curve the rest of its object stays.
export function with_points(value: Json | undefined, shape: Shape): Json {
  const points: Json = shape.points.map(([x, y]) => [x, y]);
  if (shape.form !== 'function') return points;
  const kept = is_object(value) ? value : {};
  const says_joining = kept['kind'] !== undefined || shape.joining === 'linear';
  return { ...kept, curve: points, ...(says_joining ? { kind: shape.joining } : {}) };
}

/// Second derivatives of the natural cubic spline at its points.
function bends_of(points: readonly Point[]): number[] {
  const count = points.length;
  const bends = new Array<number>(count).fill(0);
  const factors = new Array<number>(count).fill(0);
  const at = (k: number): Point => points[k] ?? [0, 0];
  for (let k = 1; k + 1 < count; k += 1) {
    const [[x0, y0], [x1, y1], [x2, y2]] = [at(k - 1), at(k), at(k + 1)];
    const share = (x1 - x0) / (x2 - x0);
    const pivot = share * (factors[k - 1] ?? 0) + 2;
    factors[k] = (share - 1) / pivot;
    const turn = (y2 - y1) / (x2 - x1) - (y1 - y0) / (x1 - x0);
    bends[k] = ((6 * turn) / (x2 - x0) - share * (bends[k - 1] ?? 0)) / pivot;
  }
  for (let k = count - 2; k > 0; k -= 1) bends[k] = (factors[k] ?? 0) * (bends[k + 1] ?? 0) + (bends[k] ?? 0);
  return bends;
}

/// The points of a line that shows the shape.
export function line_of(shape: Shape, steps = 12): Point[] {
  const { points, joining, form } = shape;
  if (form === 'profile' && rises(points)) return line_of(over_height(shape), steps).map(([height, radius]) => [Math.max(0, radius), height]);
  if (form === 'polygon' && points[0]) return [...points, points[0]];
  if (form !== 'function' || joining === 'linear' || points.length < 3) return points;
  const bends = bends_of(points);
  const line: Point[] = [];
  for (let k = 0; k + 1 < points.length; k += 1) {
    const [[x0, y0], [x1, y1]] = [points[k] ?? [0, 0], points[k + 1] ?? [0, 0]];
    const wide = x1 - x0;
    for (let step = 0; step < steps; step += 1) {
      const b = step / steps;
      const a = 1 - b;
      const bow = ((a ** 3 - a) * (bends[k] ?? 0) + (b ** 3 - b) * (bends[k + 1] ?? 0)) * (wide ** 2 / 6);
      line.push([x0 + b * wide, a * y0 + b * y1 + bow]);
    }
  }
  line.push(points[points.length - 1] ?? [0, 0]);
  return line;
}

/// A profile as the function that it is.
function over_height({ points }: Shape): Shape {
  return { points: points.map(([radius, height]) => [height, radius]), joining: 'spline', form: 'function' };
}

/// Whether heights rise, as those of a profile that is no fault do.
function rises(points: readonly Point[]): boolean {
  return points.every(([, height], k) => k === 0 || height > (points[k - 1]?.[1] ?? height));
}

/// Whether both sides of it are shown.
export function is_two_sided({ form }: Shape): boolean {
  return form === 'silhouette' || form === 'profile';
}

/// On the other side of x = 0.
export function mirrored(points: readonly Point[]): Point[] {
  return points.map(([x, y]) => [-x, y]);
}

function range_of(numbers: number[], also: number[]): Range {
  const all = [...numbers, ...also];
  const [low, high] = [Math.min(...all), Math.max(...all)];
  return high > low ? { low, high } : { low: low - 0.5, high: high + 0.5 };
}

export interface Frame {
  x: Range;
  y: Range;
}

/// What is shown around a shape: of a function 0 to 1 and 0 at least, with room above to pull points into; of a
/// silhouette both sides.
export function frame_of(shape: Shape): Frame {
  const line = line_of(shape);
  const [xs, ys] = [line.map(([x]) => x), line.map(([, y]) => y)];
  if (shape.form === 'function') {
    const y = range_of(ys, [0]);
    const room = 0.15 * (y.high - y.low);
    return { x: range_of(xs, [0, 1]), y: { low: y.low < 0 ? y.low - room : 0, high: y.high > 0 ? y.high + room : 0 } };
  }
  const both = is_two_sided(shape) ? [0, ...xs.map((one) => -one)] : [];
  const [x, y] = [range_of(xs, both), range_of(ys, [])];
  const around = 0.08 * Math.max(x.high - x.low, y.high - y.low);
  return { x: { low: x.low - around, high: x.high + around }, y: { low: y.low - around, high: y.high + around } };
}

/// A frame that shows further points, too.
export function with_room_for({ x, y }: Frame, points: readonly Point[]): Frame {
  const [xs, ys] = [points.map(([one]) => one), points.map(([, one]) => one)];
  return { x: { low: Math.min(x.low, ...xs), high: Math.max(x.high, ...xs) }, y: { low: Math.min(y.low, ...ys), high: Math.max(y.high, ...ys) } };
}

const kLeastGap = 0.001; // between the points of a function, as a share of its range

/// The shape with one point elsewhere; those of a function stay in their order and range, and those of a profile in
/// theirs.
export function with_point_at(shape: Shape, index: number, [x, y]: Point, frame: Frame, digits: number): Shape {
  if (shape.form === 'profile') {
    const least = kLeastGap * (frame.y.high - frame.y.low);
    const [below, above] = [(shape.points[index - 1]?.[1] ?? -Infinity) + least, (shape.points[index + 1]?.[1] ?? Infinity) - least];
    const made: Point = [Math.max(0, rounded(x, digits)), Math.min(above, Math.max(below, rounded(y, digits)))];
    return { ...shape, points: shape.points.map((one, k) => (k === index ? made : one)) };
  }
  const gap = kLeastGap * (frame.x.high - frame.x.low);
  const low = index > 0 ? (shape.points[index - 1]?.[0] ?? 0) + gap : frame.x.low;
  const high = index + 1 < shape.points.length ? (shape.points[index + 1]?.[0] ?? 1) - gap : frame.x.high;
  const held = shape.form === 'function' ? Math.min(Math.max(x, low), high) : x;
  const moved: Point = [rounded(held, digits), rounded(y, digits)];
  return { ...shape, points: shape.points.map((one, k) => (k === index ? moved : one)) };
}

/// The shape with one point more, and where it stands in the list; nothing where there is no room for it.
export function with_point(shape: Shape, [x, y]: Point, digits: number): { shape: Shape; index: number } | null {
  const { points } = shape;
  if (shape.form === 'profile') return with_point_of_profile(shape, [x, y], digits);
  const index = shape.form === 'function' ? points.filter(([one]) => one < x).length : nearest_piece(points, [x, y], shape.form === 'polygon') + 1;
  const made: Point = [rounded(x, digits), rounded(y, digits)];
  if (shape.form === 'function' && points.some(([one]) => Math.abs(one - made[0]) < 1e-9)) return null;
  return { shape: { ...shape, points: [...points.slice(0, index), made, ...points.slice(index)] }, index };
}

function with_point_of_profile(shape: Shape, [radius, height]: Point, digits: number): { shape: Shape; index: number } | null {
  const made = rounded(height, digits);
  if (shape.points.some(([, one]) => Math.abs(one - made) < 1e-9)) return null;
  return insert(shape, shape.points.filter(([, one]) => one < made).length, [Math.max(0, radius), made], digits);
}

/// In the middle of the piece behind a point; behind the last one before it.
export function with_point_after(shape: Shape, index: number, digits: number): { shape: Shape; index: number } | null {
  const { points } = shape;
  const is_ring = shape.form === 'polygon';
  const first = is_ring ? index : Math.max(0, Math.min(index, points.length - 2));
  const [a, b] = [points[first], points[is_ring ? (first + 1) % points.length : first + 1]];
  if (!a) return null;
  if (!b) return with_point(shape, [a[0] < 0.5 ? 1 : 0, a[1]], digits);
  const middle: Point = [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2];
  const is_spline = shape.form === 'profile' || (shape.form === 'function' && shape.joining === 'spline');
  if (!is_spline || points.length < 3) return insert(shape, first + 1, middle, digits);
  const line = line_of({ ...shape }, 2);
  return insert(shape, first + 1, line[2 * first + 1] ?? middle, digits);
}

function insert(shape: Shape, index: number, [x, y]: Point, digits: number): { shape: Shape; index: number } {
  const made: Point = [rounded(x, digits), rounded(y, digits)];
  return { shape: { ...shape, points: [...shape.points.slice(0, index), made, ...shape.points.slice(index)] }, index };
}

export function without_point(shape: Shape, index: number): Shape {
  return { ...shape, points: shape.points.filter((_, k) => k !== index) };
}

/// The index of the first point of the piece that is nearest.
function nearest_piece(points: readonly Point[], [x, y]: Point, is_ring: boolean): number {
  let [best, least] = [points.length - 1, Infinity];
  for (let k = 0; k + (is_ring ? 0 : 1) < points.length; k += 1) {
    const [[x0, y0], [x1, y1]] = [points[k] ?? [0, 0], points[(k + 1) % points.length] ?? [0, 0]];
    const [dx, dy] = [x1 - x0, y1 - y0];
    const along = Math.min(1, Math.max(0, ((x - x0) * dx + (y - y0) * dy) / (dx * dx + dy * dy || 1)));
    const away = (x0 + along * dx - x) ** 2 + (y0 + along * dy - y) ** 2;
    if (away < least) [best, least] = [k, away];
  }
  return best;
}
