// SPDX-License-Identifier: Apache-2.0
// Finds the grips of a part of the document, by the geometric roles of its rows in the parameter tables.

import type { ParameterTable, Row, Tables } from '../tables/tables.ts';
import { table_of } from '../tables/tables.ts';
import type { Json } from '../values/json.ts';
import { is_object } from '../values/json.ts';
import { path_below } from '../values/path.ts';
import type { Frame3 } from '../values/space_math.ts';
import { framed, point_in } from '../values/space_math.ts';
import { box_group } from './box_group.ts';
import type { GripGroup, Sight } from './grip.ts';
import { nested_objects } from './nested_objects.ts';
import { place_groups } from './place_group.ts';
import { points_groups, profile_group } from './points_groups.ts';
import { pose_group } from './pose_group.ts';
import type { Spot } from './spot.ts';
import { pose_of, vec_of } from './spot.ts';

const kMaxGroups = 200;
const kDeepest = 12; // levels of tables below the chosen one

interface Walk {
  tables: Tables;
  sight: Sight;
  groups: GripGroup[];
}

/// Returns the groups of all rows of an object. `frame` is the frame of the rows; for a component it is the frame of
/// its site.
export function groups_of_object(
  tables: Tables,
  row_tables: readonly ParameterTable[],
  value: Json | undefined,
  path: string,
  title: string,
  frame: Frame3,
  sight: Sight,
): GripGroup[] {
  const walk: Walk = { tables, sight, groups: [] };
  const object = is_object(value) ? value : {};
  const own = framed(frame, own_frame(tables, row_tables, object));
  for (const table of row_tables) {
    const spot: Spot = {
      table,
      value: object,
      path,
      title,
      frame: own,
      is_given: false,
      path_of: (row) => path_below(path, row),
    };
    visit(walk, spot, frame, 0);
  }
  return walk.groups.slice(0, kMaxGroups);
}

/// Returns the frame that a nested table with a translation and a rotation, such as the `frame` of components, gives to
/// all other rows.
function own_frame(tables: Tables, row_tables: readonly ParameterTable[], object: { [name: string]: Json }): Frame3 {
  const row = row_tables.flatMap(({ rows }) => rows).find((one) => one.name === 'frame' && one.table !== undefined);
  const said = row ? object[row.name] : undefined;
  return pose_of(row?.table === undefined ? null : table_of(tables, row.table), is_object(said) ? said : {});
}

/// `base` is the frame before the object's own pose.
function visit(walk: Walk, spot: Spot, base: Frame3, depth: number): void {
  if (walk.groups.length >= kMaxGroups || depth > kDeepest) return;
  const { table, value, frame } = spot;
  const has_pose = table.rows.some((row) => row.in_space === 'shift');
  const posed: Spot = has_pose ? { ...spot, frame: framed(frame, pose_of(table, value)) } : spot;
  const box = table.rows.find((row) => row.kind === 'box' && value[row.name] !== undefined);
  const box_made = box ? box_group(posed, box, frame) : null;
  if (box_made) walk.groups.push(box_made);
  else if (has_pose) push(walk, pose_group(spot));
  walk.groups.push(...place_groups(spot, walk.sight));
  for (const row of table.rows) {
    if (row.kind === 'positions') walk.groups.push(...points_groups(spot, row));
    if (row.in_space === 'profile') push(walk, profile_group(below_root(spot), row, walk.sight));
  }
  for (const row of table.rows) visit_nested(walk, row, spot, base, depth);
}

function push(walk: Walk, group: GripGroup | null): void {
  if (group) walk.groups.push(group);
}

/// Returns the frame at the first root, if the enclosing table has roots. Nested tables are relative to it.
function below_root(spot: Spot): Spot {
  const roots = spot.value['roots'] ?? spot.table.rows.find((row) => row.name === 'roots')?.default;
  const first = Array.isArray(roots) ? vec_of(roots[0]) : null;
  return first ? { ...spot, frame: { ...spot.frame, origin: point_in(spot.frame, first) } } : spot;
}

function visit_nested(walk: Walk, row: Row, around: Spot, base: Frame3, depth: number): void {
  const is_own_frame = depth === 0 && row.name === 'frame';
  const frame = is_own_frame ? base : below_root(around).frame;
  const own = row.name.replaceAll('_', ' ');
  const label = depth === 0 ? own : `${around.title}, ${own}`;
  for (const { table, value, path, step, path_of } of nested_objects(
    walk.tables,
    row,
    around.value[row.name],
    around.path_of(row.name),
  )) {
    const title = step === null ? label : `${singular(label)} ${typeof step === 'number' ? step + 1 : step}`;
    visit(walk, { table, value, path, title, frame, is_given: true, path_of }, frame, depth + 1);
  }
}

function singular(label: string): string {
  return label.endsWith('s') ? label.slice(0, -1) : label;
}
