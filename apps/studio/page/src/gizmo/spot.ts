// SPDX-License-Identifier: Apache-2.0
// An object of the document for which grips are made, and its pose. All groups of grips share it.
import type { ParameterTable } from '../tables/tables.ts';
import type { Json } from '../values/json.ts';
import type { Frame3, Vec } from '../values/space_math.ts';
import { times, turn_of } from '../values/space_math.ts';

export function vec_of(value: Json | undefined): Vec | null {
  if (!Array.isArray(value) || value.length !== 3 || !value.every((one) => typeof one === 'number')) return null;
  return value as unknown as Vec;
}

/// An object of the document with its table, in the frame of its rows.
export interface Spot {
  table: ParameterTable;
  value: { [name: string]: Json };
  path: string;
  title: string; // title of the object for users
  frame: Frame3;
  is_given: boolean; // true: the object is in the document, so that defaults of its rows count
  path_of: (row: string) => string;
}

/// Returns the frame of a pose: scale, then rotation, then translation.
export function pose_of(table: ParameterTable | null, value: { [name: string]: Json }): Frame3 {
  const of = (role: string): Vec | null => vec_of(value[table?.rows.find((row) => row.in_space === role)?.name ?? '']);
  const said = value['scale'];
  const scale: Vec = typeof said === 'number' ? [said, said, said] : (vec_of(said) ?? [1, 1, 1]);
  const turn = turn_of(of('turn') ?? [0, 0, 0]);
  return {
    axes: [times(turn[0], scale[0]), times(turn[1], scale[1]), times(turn[2], scale[2])],
    origin: of('shift') ?? [0, 0, 0],
  };
}
