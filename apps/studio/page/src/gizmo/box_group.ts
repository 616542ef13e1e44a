// SPDX-License-Identifier: Apache-2.0
// The grips of a box: it is moved as a whole, sized by its faces, and turned about its middle if its table has turns.

import type { Row } from '../tables/tables.ts';
import { rounded } from '../values/arithmetic.ts';
import type { Json } from '../values/json.ts';
import type { Frame3, Vec } from '../values/space_math.ts';
import { add, length, point_in, times, unit, vector_out } from '../values/space_math.ts';
import type { Amount, Grip, GripField, GripGroup, Values } from './grip.ts';
import { moved_vector } from './grip.ts';
import { move_grips } from './move_grips.ts';
import { turn_grips } from './pose_group.ts';
import type { Spot } from './spot.ts';
import { vec_of } from './spot.ts';

const kAxes = ['x', 'y', 'z'] as const;
const kSizes = ['width', 'height', 'depth'];
const kThinnest = 1e-3; // minimum size of a box, metres

/// `base` is the frame before the pose of the table.
export function box_group(spot: Spot, row: Row, base: Frame3): GripGroup | null {
  const said = spot.value[row.name];
  const [a, b] = Array.isArray(said) ? [vec_of(said[0]), vec_of(said[1])] : [null, null];
  if (!a || !b) return null;
  const path = spot.path_of(row.name);
  const { frame } = spot;
  const middle = times(add(a, b), 0.5);
  const corners = (one: Vec | number[], other: Vec | number[]): Values => ({ [path]: [[...one], [...other]] as Json });
  const move = ({ by, step }: Amount): Values => {
    const inside = vector_out(frame, by);
    return corners(moved_vector(a, inside, step), moved_vector(b, inside, step));
  };
  const at = point_in(frame, middle);
  const grips = [
    ...move_grips(at, base, middle.map((one) => one.toFixed(2)).join(', '), move),
    ...faces_of(a, b, frame, path),
    ...turn_grips(spot, middle, base),
  ];
  return {
    key: path,
    label: spot.title === row.name ? spot.title : `${spot.title}, ${row.name}`,
    at,
    grips,
    fields: fields_of(a, b, corners),
    lines: edges_of(a, b, frame),
  };
}

function faces_of(a: Vec, b: Vec, frame: Frame3, path: string): Grip[] {
  const grips: Grip[] = [];
  for (const axis of [0, 1, 2] as const) {
    for (const side of [-1, 1] as const) {
      // Corners may be in any order: the upper face moves the corner that is upper along this axis.
      const of_a = a[axis] >= b[axis] === side > 0;
      const [moved, other] = of_a ? [a, b] : [b, a];
      const centre = times(add(a, b), 0.5).map((one, k) => (k === axis ? moved[axis] : one)) as unknown as Vec;
      const way = unit(times(frame.axes[axis], side));
      const scale = length(frame.axes[axis]) || 1;
      grips.push({
        key: `${side < 0 ? 'lower' : 'upper'} ${kAxes[axis]}`,
        label: `${side < 0 ? 'Lower' : 'Upper'} side along ${kAxes[axis]}`,
        motion: 'line',
        look: 'face',
        at: point_in(frame, centre),
        way,
        said: `${moved[axis]} m`,
        now: moved[axis],
        values: ({ by, step }) => {
          const wanted = moved[axis] + (side * (by[0] * way[0] + by[1] * way[1] + by[2] * way[2])) / scale;
          const held = side > 0 ? Math.max(wanted, other[axis] + kThinnest) : Math.min(wanted, other[axis] - kThinnest);
          const made = moved.map((one, k) => (k === axis ? rounded(held, step) : one));
          return { [path]: (of_a ? [made, [...other]] : [[...other], made]) as Json };
        },
      });
    }
  }
  return grips;
}

function fields_of(a: Vec, b: Vec, corners: (one: number[], other: number[]) => Values): GripField[] {
  const middle = times(add(a, b), 0.5);
  return kAxes.flatMap((name, axis): GripField[] => {
    const size = Math.abs((b[axis] ?? 0) - (a[axis] ?? 0));
    const shift = (by: number): Values =>
      corners(
        a.map((one, k) => (k === axis ? rounded(one + by, 1e-6) : one)),
        b.map((one, k) => (k === axis ? rounded(one + by, 1e-6) : one)),
      );
    const sized = (to: number): Values => {
      const grow = (to - size) / 2;
      const up = (b[axis] ?? 0) >= (a[axis] ?? 0) ? 1 : -1;
      // The size grows upward from the lower side, so that a box stays on its ground.
      const [low, high] = axis === 1 ? [0, 2 * grow] : [-grow, grow];
      return corners(
        a.map((one, k) => (k === axis ? rounded(one + (up > 0 ? low : high), 1e-6) : one)),
        b.map((one, k) => (k === axis ? rounded(one + (up > 0 ? high : low), 1e-6) : one)),
      );
    };
    return [
      {
        label: name,
        unit: 'm',
        value: middle[axis] ?? 0,
        step: 0.05,
        limit: (one) => one,
        values: (one) => shift(one - (middle[axis] ?? 0)),
      },
      {
        label: kSizes[axis] ?? '',
        unit: 'm',
        value: size,
        step: 0.05,
        limit: (one) => Math.max(kThinnest, one),
        values: sized,
      },
    ];
  });
}

function edges_of(a: Vec, b: Vec, frame: Frame3): Vec[][] {
  const corner = (k: number): Vec => point_in(frame, [(k & 1 ? b : a)[0], (k & 2 ? b : a)[1], (k & 4 ? b : a)[2]]);
  const edges: Vec[][] = [];
  for (let k = 0; k < 8; k += 1)
    for (const bit of [1, 2, 4]) if ((k & bit) === 0) edges.push([corner(k), corner(k | bit)]);
  return edges;
}
