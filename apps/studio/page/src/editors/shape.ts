// SPDX-License-Identifier: Apache-2.0
// Curves and outlines in documents: their course between points, and how their points move.
import { rounded } from '../values/arithmetic.ts';
import type { Json } from '../values/json.ts';
import { is_object } from '../values/json.ts';

export type Point = readonly [number, number];
export type Joining = 'spline' | 'linear';

export interface Range {
  low: number;
  high: number;
}

/// How points are joined. A function has rising x, and a line any points. The last point of a polygon is joined to the
/// first. A silhouette is one half of a form that is symmetric about x = 0. A profile is a spline of radius over rising
/// height, revolved about x = 0.
export type Form = 'function' | 'line' | 'polygon' | 'silhouette' | 'profile';

export interface Shape {
  points: Point[];
  joining: Joining;
  form: Form;
}

/// Returns the shape of a value, or null for other forms such as expressions. `together` is the form in the row's
/// table.
export function shape_of(value: Json | undefined, together: Form = 'line'): Shape | null {
  const is_function = is_object(value);
  const points = points_of(is_function ? value['curve'] : value);
  if (!points) return null;
  const joining = !is_function || value['kind'] === 'linear' ? 'linear' : 'spline';
  return { points, joining, form: is_function ? 'function' : together };
}

/// Returns the minimum number of points of a shape.
export function min_points({ form }: Shape): number {
  return { function: 1, line: 2, polygon: 3, silhouette: 2, profile: 2 }[form];
}

function points_of(list: Json | undefined): Point[] | null {
  if (!Array.isArray(list) || list.length === 0) return null;
  const points = list.filter(
    (one): one is [number, number] =>
      Array.isArray(one) && one.length === 2 && one.every((number) => typeof number === 'number'),
  );
  return points.length === list.length ? points : null;
}

/// Returns the value with the points of a shape. The other members of a curve stay.
export function with_points(value: Json | undefined, shape: Shape): Json {
  const points: Json = shape.points.map(([x, y]) => [x, y]);
  if (shape.form !== 'function') return points;
  const kept = is_object(value) ? value : {};
  const says_joining = kept['kind'] !== undefined || shape.joining === 'linear';
  return { ...kept, curve: points, ...(says_joining ? { kind: shape.joining } : {}) };
}

/// Returns the second derivatives of the natural cubic spline at its points.
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

/// Returns the points of a line that draws the shape.
export function line_of(shape: Shape, steps = 12): Point[] {
  const { points, joining, form } = shape;
  if (form === 'profile' && rises(points))
    return line_of(over_height(shape), steps).map(([height, radius]) => [Math.max(0, radius), height]);
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

/// Returns a profile as a function of height.
function over_height({ points }: Shape): Shape {
  return { points: points.map(([radius, height]) => [height, radius]), joining: 'spline', form: 'function' };
}

/// Returns true if heights rise, as in a valid profile.
function rises(points: readonly Point[]): boolean {
  return points.every(([, height], k) => k === 0 || height > (points[k - 1]?.[1] ?? height));
}

/// Returns true if both sides of the shape are shown.
export function is_two_sided({ form }: Shape): boolean {
  return form === 'silhouette' || form === 'profile';
}

/// Returns the points on the other side of x = 0.
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

/// Returns the frame around a shape. For a function it covers x from 0 to 1 and includes 0, with space above. For a
/// silhouette it covers both sides.
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

/// Returns a frame that also includes further points.
export function with_room_for({ x, y }: Frame, points: readonly Point[]): Frame {
  const [xs, ys] = [points.map(([one]) => one), points.map(([, one]) => one)];
  return {
    x: { low: Math.min(x.low, ...xs), high: Math.max(x.high, ...xs) },
    y: { low: Math.min(y.low, ...ys), high: Math.max(y.high, ...ys) },
  };
}

const kMinGap = 0.001; // between the points of a function, as a share of its range

/// Returns the shape with one point moved. Points of functions and profiles keep their order and stay in their range.
export function with_point_at(shape: Shape, index: number, [x, y]: Point, frame: Frame, digits: number): Shape {
  if (shape.form === 'profile') {
    const min = kMinGap * (frame.y.high - frame.y.low);
    const [below, above] = [
      (shape.points[index - 1]?.[1] ?? -Infinity) + min,
      (shape.points[index + 1]?.[1] ?? Infinity) - min,
    ];
    const made: Point = [Math.max(0, rounded(x, digits)), Math.min(above, Math.max(below, rounded(y, digits)))];
    return { ...shape, points: shape.points.map((one, k) => (k === index ? made : one)) };
  }
  const gap = kMinGap * (frame.x.high - frame.x.low);
  const low = index > 0 ? (shape.points[index - 1]?.[0] ?? 0) + gap : frame.x.low;
  const high = index + 1 < shape.points.length ? (shape.points[index + 1]?.[0] ?? 1) - gap : frame.x.high;
  const held = shape.form === 'function' ? Math.min(Math.max(x, low), high) : x;
  const moved: Point = [rounded(held, digits), rounded(y, digits)];
  return { ...shape, points: shape.points.map((one, k) => (k === index ? moved : one)) };
}

/// Returns the shape with one more point, and the index of that point. Returns null if there is no space.
export function with_point(shape: Shape, [x, y]: Point, digits: number): { shape: Shape; index: number } | null {
  const { points } = shape;
  if (shape.form === 'profile') return with_point_of_profile(shape, [x, y], digits);
  const index =
    shape.form === 'function'
      ? points.filter(([one]) => one < x).length
      : nearest_piece(points, [x, y], shape.form === 'polygon') + 1;
  const made: Point = [rounded(x, digits), rounded(y, digits)];
  if (shape.form === 'function' && points.some(([one]) => Math.abs(one - made[0]) < 1e-9)) return null;
  return { shape: { ...shape, points: [...points.slice(0, index), made, ...points.slice(index)] }, index };
}

function with_point_of_profile(
  shape: Shape,
  [radius, height]: Point,
  digits: number,
): { shape: Shape; index: number } | null {
  const made = rounded(height, digits);
  if (shape.points.some(([, one]) => Math.abs(one - made) < 1e-9)) return null;
  return insert(shape, shape.points.filter(([, one]) => one < made).length, [Math.max(0, radius), made], digits);
}

/// Returns the shape with a point in the middle of the piece after a point, or of the piece before the last point.
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

/// Returns the index of the first point of the nearest piece.
function nearest_piece(points: readonly Point[], [x, y]: Point, is_ring: boolean): number {
  let [best, min] = [points.length - 1, Infinity];
  for (let k = 0; k + (is_ring ? 0 : 1) < points.length; k += 1) {
    const [[x0, y0], [x1, y1]] = [points[k] ?? [0, 0], points[(k + 1) % points.length] ?? [0, 0]];
    const [dx, dy] = [x1 - x0, y1 - y0];
    const along = Math.min(1, Math.max(0, ((x - x0) * dx + (y - y0) * dy) / (dx * dx + dy * dy || 1)));
    const away = (x0 + along * dx - x) ** 2 + (y0 + along * dy - y) ** 2;
    if (away < min) [best, min] = [k, away];
  }
  return best;
}
