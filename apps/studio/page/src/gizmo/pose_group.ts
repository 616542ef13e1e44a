// SPDX-License-Identifier: Apache-2.0
// Grips for the translation and the rotation of an object without a known form: arrows along the axes, and rings.
import { rounded } from '../values/arithmetic.ts';
import type { Json } from '../values/json.ts';
import type { Frame3, Vec } from '../values/space_math.ts';
import { minus, point_in, turned, turns_to, unit, vector_in, vector_out } from '../values/space_math.ts';
import type { Grip, GripField, GripGroup, Values } from './grip.ts';
import { moved_vector } from './grip.ts';
import { move_grips } from './move_grips.ts';
import type { Spot } from './spot.ts';
import { pose_of, vec_of } from './spot.ts';

const kAxes = ['x', 'y', 'z'] as const;
const kTurns = ['pitch', 'roll', 'yaw'] as const;
const kStill: Vec = [0, 0, 0];

function role_path(spot: Spot, role: string): { path: string; value: Vec | null } | null {
  const row = spot.table.rows.find((one) => one.in_space === role);
  // Some rows are allowed only beside others, like the pose of a file.
  const is_free =
    row !== undefined &&
    (spot.table.only_with ?? []).every(([name, other]) => name !== row.name || spot.value[other] !== undefined);
  if (!row || !is_free) return null;
  const said = spot.value[row.name];
  return { path: spot.path_of(row.name), value: said === undefined ? kStill : vec_of(said) };
}

/// Returns the group of a written pose, or null if it has expressions.
export function pose_group(spot: Spot): GripGroup | null {
  const shift = role_path(spot, 'shift');
  if (!shift?.value || !spot.is_given || Object.keys(spot.value).length === 0) return null;
  if (!poses_something(spot)) return null;
  const { frame } = spot;
  const from = shift.value;
  const at = point_in(frame, from);
  const grips = [
    ...move_grips(at, frame, from.map((one) => one.toFixed(2)).join(', '), ({ by, step }) => ({
      [shift.path]: moved_vector(from, vector_out(frame, by), step) as Json,
    })),
    ...turn_grips(spot, kStill, frame),
  ];
  return {
    key: shift.path,
    label: spot.title === 'frame' ? 'frame' : `${spot.title}, place`,
    at,
    grips,
    fields: [...fields_of(from, shift.path, kAxes, 'm', 0.05), ...turn_fields(spot)],
    lines: [],
  };
}

/// Returns true if the pose has an object. In tables that may name a file, the pose belongs to the file.
function poses_something({ table, value }: Spot): boolean {
  const file = table.rows.find((row) => row.kind === 'file');
  return !file || value[file.name] !== undefined;
}

function turn_fields(spot: Spot): GripField[] {
  const turn = role_path(spot, 'turn');
  return turn?.value ? fields_of(turn.value, turn.path, kTurns, '°', 1) : [];
}

export function fields_of(
  from: Vec,
  path: string,
  names: readonly string[],
  unit_name: string,
  step: number,
): GripField[] {
  return names.map((name, axis) => ({
    label: name,
    unit: unit_name,
    value: from[axis] ?? 0,
    step,
    limit: (one) => one,
    values: (one) => ({ [path]: from.map((old, k) => (k === axis ? one : old)) as Json }),
  }));
}

/// Returns rings about the axes of the frame around the pose. The point `middle`, in the frame of the object, stays in
/// place.
export function turn_grips(spot: Spot, middle: Vec, base: Frame3): Grip[] {
  const [turn, shift] = [role_path(spot, 'turn'), role_path(spot, 'shift')];
  if (!turn?.value || !shift?.value) return [];
  const pose = pose_of(spot.table, spot.value);
  const centre = point_in(base, point_in(pose, middle));
  const [from, origin] = [turn.value, shift.value];
  return kAxes.map((name, axis): Grip => {
    const about: Vec = [axis === 0 ? 1 : 0, axis === 1 ? 1 : 0, axis === 2 ? 1 : 0];
    const values = ({ degrees, step }: { degrees: number; step: number }): Values => {
      const axes = pose.axes.map((one) => turned(one, about, degrees)) as [Vec, Vec, Vec];
      // Angles that the rotation does not change keep their digits.
      const turns = turns_to(axes.map((one) => unit(one)) as [Vec, Vec, Vec]).map((one, k) =>
        Math.abs(one - (from[k] ?? 0)) < 1e-6 ? (from[k] ?? 0) : rounded(one, Math.min(step, 0.01)),
      );
      const kept = minus(point_in(pose, middle), vector_in({ axes, origin: kStill }, middle));
      const is_moved = kept.some((one, k) => Math.abs(one - (origin[k] ?? 0)) > 1e-9);
      return {
        [turn.path]: turns as Json,
        ...(is_moved ? { [shift.path]: kept.map((one) => rounded(one, 1e-4)) as Json } : {}),
      };
    };
    return {
      key: `turn ${name}`,
      label: `Turn about ${name}`,
      motion: 'ring',
      look: 'ring',
      at: centre,
      centre,
      way: unit(vector_in(base, about)),
      said: `${from[axis] ?? 0} degrees`,
      now: from[axis] ?? 0,
      values,
    };
  });
}
