// SPDX-License-Identifier: Apache-2.0
// Grips of the positions of a list, each moved separately, and of the profile of a crown, whose points lie in a plane
// facing the view.

import { line_of, shape_of } from '../editors/shape.ts';
import type { Row } from '../tables/tables.ts';
import { rounded } from '../values/arithmetic.ts';
import type { Json } from '../values/json.ts';
import type { Vec } from '../values/space_math.ts';
import { add, cross, dot, length, point_in, times, unit, vector_in, vector_out } from '../values/space_math.ts';
import type { Grip, GripGroup, Sight } from './grip.ts';
import { moved_vector } from './grip.ts';
import { move_grips } from './move_grips.ts';
import { fields_of } from './pose_group.ts';
import type { Spot } from './spot.ts';
import { vec_of } from './spot.ts';

const kAxes = ['x', 'y', 'z'] as const;
const kMaxPoints = 64; // points of a list; longer lists are edited in their rows
const kMinRise = 1e-3; // minimum height between points of a profile, metres

export function points_groups(spot: Spot, row: Row): GripGroup[] {
  const said = spot.value[row.name];
  if (!Array.isArray(said) || said.length > kMaxPoints) return [];
  const points = said.map(vec_of);
  const path = spot.path_of(row.name);
  const shown = points.map((point) => point && point_in(spot.frame, point));
  const line = row.together === 'line' ? shown.filter((one) => one !== null) : [];
  const name = spot.is_given ? spot.title : row.name.replaceAll('_', ' ');
  return points.flatMap((point, k): GripGroup[] => {
    const at = shown[k];
    if (!point || !at) return [];
    const put = (made: number[]): Json => said.map((old, index) => (index === k ? made : old));
    const fields = fields_of(point, path, kAxes, 'm', 0.05).map((field) => ({
      ...field,
      values: (one: number) => ({ [path]: put((field.values(one)[path] as number[]) ?? []) }),
    }));
    const grips = move_grips(at, spot.frame, point.join(', '), ({ by, step }) => ({
      [path]: put(moved_vector(point, vector_out(spot.frame, by), step)),
    }));
    return [
      {
        key: `${path}[${k}]`,
        label: points.length > 1 ? `${name}, point ${k + 1}` : name,
        at,
        grips,
        fields,
        lines: line.length > 1 ? [line] : [],
      },
    ];
  });
}

/// `spot` is at the root.
export function profile_group(spot: Spot, row: Row, sight: Sight): GripGroup | null {
  const shape = shape_of(spot.value[row.name], 'profile');
  if (!shape) return null;
  const path = spot.path_of(row.name);
  const up = unit(vector_in(spot.frame, [0, 1, 0]));
  const across = unit(cross(up, cross(sight.right, up)), [1, 0, 0]);
  const normal = unit(cross(across, up));
  const scale = length(vector_in(spot.frame, [0, 1, 0])) || 1;
  const place = (radius: number, height: number): Vec =>
    add(spot.frame.origin, add(times(across, radius * scale), times(up, height * scale)));
  // The spline runs over the height through all points, on both sides of the vertical.
  const spline = line_of(shape);
  const half = (side: number): Vec[] => spline.map(([radius, height]) => place(side * radius, height));
  const rings = shape.points.map(([radius, height]) => circle(place(0, height), across, normal, radius * scale));
  const grips = shape.points.map(([radius, height], k): Grip => {
    const [below, above] = [shape.points[k - 1]?.[1] ?? -Infinity, shape.points[k + 1]?.[1] ?? Infinity];
    const moved = (by: Vec, step: number): Json => {
      const made = [
        Math.max(0, rounded(radius + dot(by, across) / scale, step)),
        Math.min(above - kMinRise, Math.max(below + kMinRise, rounded(height + dot(by, up) / scale, step))),
      ];
      return shape.points.map((old, index) => (index === k ? made : [...old]));
    };
    return {
      key: `point ${k + 1}`,
      label: `Point ${k + 1} of ${shape.points.length}`,
      motion: 'plane',
      look: 'dot',
      at: place(radius, height),
      way: normal,
      said: `radius ${radius} m, height ${height} m`,
      now: radius,
      values: ({ by, step }) => ({ [path]: moved(by, step) }),
    };
  });
  const top = shape.points.at(-1) ?? [0, 0];
  return {
    key: path,
    label: spot.title === row.name ? spot.title : `${spot.title}, ${row.name}`,
    at: place(0, top[1]),
    grips,
    fields: [],
    lines: [half(1), half(-1), ...rings],
  };
}

function circle(centre: Vec, one: Vec, other: Vec, radius: number): Vec[] {
  return Array.from({ length: 49 }, (_, k) =>
    add(
      centre,
      add(times(one, radius * Math.cos((Math.PI * k) / 24)), times(other, radius * Math.sin((Math.PI * k) / 24))),
    ),
  );
}
