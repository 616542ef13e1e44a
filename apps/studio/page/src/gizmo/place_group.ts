// SPDX-License-Identifier: Apache-2.0
// Grips of an object at a position, with its direction and size from its table: a lamp, a ball, a cone, the axis of a
// vortex, a control point.

import type { Row } from '../tables/tables.ts';
import { within_hard_range } from '../tables/tables.ts';
import { rounded } from '../values/arithmetic.ts';
import type { Json } from '../values/json.ts';
import type { Vec } from '../values/space_math.ts';
import {
  add,
  beside,
  cross,
  dot,
  length,
  minus,
  point_in,
  times,
  unit,
  vector_in,
  vector_out,
} from '../values/space_math.ts';
import type { Grip, GripField, GripGroup, Sight } from './grip.ts';
import { moved_vector } from './grip.ts';
import { move_grips } from './move_grips.ts';
import { fields_of } from './pose_group.ts';
import type { Spot } from './spot.ts';
import { vec_of } from './spot.ts';

const kAxes = ['x', 'y', 'z'] as const;
const kRoundness = 48; // number of pieces of a circle

interface Parts {
  lines: Vec[][];
  grips: Grip[];
  fields: GripField[];
}

/// Returns the groups of an object's positions. Returns an empty list if its table has no position, or if there are
/// expressions. Defaults are used for objects that are written. Directions and sizes belong to the first position.
export function place_groups(spot: Spot, sight: Sight): GripGroup[] {
  const rows = spot.table.rows.filter((row) => row.in_space !== undefined);
  const value_of = (row: Row): Json | undefined => spot.value[row.name] ?? (spot.is_given ? row.default : undefined);
  const positions = rows.filter((row) => row.in_space === 'position' && vec_of(value_of(row)));
  const direction = rows.find((row) => row.in_space === 'direction' && length(vec_of(value_of(row)) ?? [0, 0, 0]) > 0);
  const first = place_group(spot, rows, positions[0], direction, value_of, sight);
  const others = positions.slice(1).map((row) => place_group(spot, [], row, undefined, value_of, sight));
  return [first, ...others].filter((group) => group !== null);
}

function place_group(
  spot: Spot,
  rows: readonly Row[],
  position: Row | undefined,
  direction: Row | undefined,
  value_of: (row: Row) => Json | undefined,
  sight: Sight,
): GripGroup | null {
  if (!position && !direction) return null;
  const place = (position && vec_of(value_of(position))) ?? [0, 0, 0];
  const at = point_in(spot.frame, place);
  const parts: Parts = { lines: [], grips: [], fields: [] };
  if (position) {
    const path = spot.path_of(position.name);
    parts.grips.push(
      ...move_grips(at, spot.frame, place.join(', '), ({ by, step }) => ({
        [path]: moved_vector(place, vector_out(spot.frame, by), step) as Json,
      })),
    );
    parts.fields.push(...fields_of(place, path, kAxes, 'm', 0.05));
  }
  const way = (direction && vec_of(value_of(direction))) ?? null;
  if (direction && way) add_direction(parts, spot, spot.path_of(direction.name), at, way, sight);
  const axis = unit(way ? vector_in(spot.frame, way) : vector_in(spot.frame, [0, 1, 0]));
  for (const row of rows) add_size(parts, spot, row, value_of(row), place, axis);
  const first = position ?? direction;
  // Rows of a component itself are labelled with their own names.
  const label = spot.is_given && rows.length > 0 ? spot.title : (first?.name ?? spot.title).replaceAll('_', ' ');
  return { key: spot.path_of(first?.name ?? ''), label, at, ...parts };
}

/// Adds a grip at the tip of an arrow with the reach of grips. The length of the written vector stays.
function add_direction(parts: Parts, spot: Spot, path: string, at: Vec, way: Vec, sight: Sight): void {
  const long = length(way);
  const shown = unit(vector_in(spot.frame, way));
  const tip = add(at, times(shown, sight.reach));
  parts.lines.push([at, tip]);
  parts.grips.push({
    key: 'direction',
    label: 'Point in a direction',
    motion: 'free',
    look: 'dot',
    at: tip,
    way: sight.toward,
    said: way.join(', '),
    now: 0,
    values: ({ by }) => ({
      [path]: times(unit(vector_out(spot.frame, minus(add(tip, by), at)), unit(way)), long).map((one) =>
        rounded(one, 0.001),
      ) as Json,
    }),
  });
  parts.fields.push(...fields_of(way, path, ['Toward x', 'Toward y', 'Toward z'], '', 0.05));
}

function add_size(parts: Parts, spot: Spot, row: Row, value: Json | undefined, place: Vec, axis: Vec): void {
  const at = point_in(spot.frame, place);
  const path = spot.path_of(row.name);
  if (row.in_space === 'radii') {
    const radii = vec_of(value);
    if (!radii) return;
    const circle = (one: number, other: number): Vec[] =>
      ring_points((c, s) =>
        point_in(
          spot.frame,
          add(
            place,
            [0, 1, 2].map((k) =>
              k === one ? c * (radii[k] ?? 0) : k === other ? s * (radii[k] ?? 0) : 0,
            ) as unknown as Vec,
          ),
        ),
      );
    parts.lines.push(circle(0, 1), circle(1, 2), circle(2, 0));
    for (const k of [0, 1, 2] as const) {
      const set = (one: number, step: number): Json =>
        radii.map((old, other) => (other === k ? rounded(within_hard_range(row, one), step) : old)) as Json;
      push_length(
        parts,
        `radius ${kAxes[k]}`,
        at,
        spot.frame.axes[k],
        radii[k],
        1,
        (one, step) => ({ [path]: set(one, step) }),
        row,
      );
    }
    return;
  }
  if (typeof value !== 'number') return;
  const set = (one: number, step: number): Record<string, Json> => ({
    [path]: rounded(within_hard_range(row, one), step),
  });
  const level = unit(vector_in(spot.frame, [1, 0, 0]));
  if (row.in_space === 'radius') {
    const side = Math.abs(dot(axis, level)) > 0.9 ? beside(axis) : level;
    const across = cross(axis, side);
    parts.lines.push(ring_points((c, s) => add(at, add(times(side, c * value), times(across, s * value)))));
    push_length(parts, row.name, at, side, value, 1, set, row);
  }
  if (row.in_space === 'height') {
    const up = vector_in(spot.frame, [0, 1, 0]);
    parts.lines.push([at, add(at, times(unit(up), value * length(up)))]);
    push_length(parts, row.name, at, up, value, 1, set, row);
  }
  if (row.in_space === 'width') {
    const half = value / 2;
    const corners: Vec[] = [
      [-half, 0, -half],
      [half, 0, -half],
      [half, 0, half],
      [-half, 0, half],
      [-half, 0, -half],
    ];
    parts.lines.push(corners.map((one) => point_in(spot.frame, add(place, one))));
    push_length(parts, row.name, at, spot.frame.axes[0], value, 0.5, set, row);
  }
}

/// Adds a grip at `share` of a length away from a position. `way` has the length of a metre of the document.
function push_length(
  parts: Parts,
  name: string,
  at: Vec,
  way: Vec,
  value: number,
  share: number,
  set: (value: number, step: number) => Record<string, Json>,
  row: Row,
): void {
  const [along, scale] = [unit(way), length(way) || 1];
  const label = `${name.charAt(0).toUpperCase()}${name.slice(1)}`.replaceAll('_', ' ');
  parts.grips.push({
    key: name,
    label,
    motion: 'line',
    look: 'face',
    at: add(at, times(along, value * share * scale)),
    way: along,
    said: `${value} m`,
    now: value,
    values: ({ by, step }) => set(value + dot(by, along) / (share * scale), step),
  });
  parts.fields.push({
    label,
    unit: 'm',
    value,
    step: 0.05,
    limit: (one) => within_hard_range(row, one),
    values: (one) => set(one, 1e-6),
  });
}

/// Returns a closed line through the points that `of` computes from cosines and sines.
function ring_points(of: (cosine: number, sine: number) => Vec): Vec[] {
  return Array.from({ length: kRoundness + 1 }, (_, k) =>
    of(Math.cos((2 * Math.PI * k) / kRoundness), Math.sin((2 * Math.PI * k) / kRoundness)),
  );
}
