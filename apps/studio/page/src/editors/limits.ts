// SPDX-License-Identifier: Apache-2.0
// The area in which the range of a row allows points.
import { ranges_of_points } from '../tables/legal.ts';
import type { Row } from '../tables/tables.ts';
import { hard_range } from '../tables/tables.ts';
import type { Form, Frame, Point, Range, Shape } from './shape.ts';
import { is_two_sided } from './shape.ts';

/// The legal values of points in both directions. An infinite end means that there is no limit.
export type Limits = Frame;

/// Returns the limits of a row for the points of a form.
export function limits_of(row: Partial<Row>, form: Form): Limits {
  const kind = form === 'function' ? 'curve' : 'points';
  const [first, second] = ranges_of_points({ ...row, kind });
  const [x, y] = [hard_range(first), hard_range(second)];
  return { x: form === 'silhouette' || form === 'profile' ? { low: Math.max(0, x.low), high: x.high } : x, y };
}

/// Returns the limits as drawn. A form with two sides has limits on both.
export function drawn_limits(limits: Limits, shape: Shape): Limits {
  return is_two_sided(shape) ? { ...limits, x: { low: -limits.x.high, high: limits.x.high } } : limits;
}

export function within_range(value: number, { low, high }: Range): number {
  return Math.min(high, Math.max(low, value));
}

/// Returns the shape with one point moved to a legal position.
export function with_legal_point(shape: Shape, index: number, limits: Limits): Shape {
  const legal = ([x, y]: Point): Point => [within_range(x, limits.x), within_range(y, limits.y)];
  return { ...shape, points: shape.points.map((one, k) => (k === index ? legal(one) : one)) };
}

const kRoomBeyond = 0.06; // share of the frame beyond a limit that stays visible

/// Returns a frame that also shows the limits, if they are near its content.
export function with_limits({ x, y }: Frame, limits: Limits, form: Form): Frame {
  const wider = (range: Range, limit: Range): Range => {
    const room = kRoomBeyond * (range.high - range.low);
    const is_near = (end: number): boolean =>
      Number.isFinite(end) && end > range.low - 10 * room && end < range.high + 10 * room;
    return {
      low: is_near(limit.low) ? Math.min(range.low, limit.low - room) : range.low,
      high: is_near(limit.high) ? Math.max(range.high, limit.high + room) : range.high,
    };
  };
  // The frame of a function does not extend beyond the function.
  return { x: form === 'function' ? x : wider(x, limits.x), y: wider(y, limits.y) };
}
