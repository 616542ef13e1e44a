// SPDX-License-Identifier: Apache-2.0
// Questions about visible instances, their shoots, and the effects of operations on trees.
// `meristem_studio_protocol` writes this file from apps/studio/protocol.
import type { Json } from '../../values/json.ts';

/// Finds the instance that made a visible part.
export interface InstanceRequest {
  /// Id of the component.
  component: string;
  /// Frame of the visible part, three rows of a 3x4 matrix. For stems: `[1,0,0,0, 0,1,0,0, 0,0,1,0]`.
  frame: readonly number[];
  /// Position on its surface, in the world.
  position: readonly [x: number, y: number, z: number];
}

/// A parameter that differs from instance to instance.
export interface InstanceValue {
  /// Path in the component.
  path: string;
  /// Value at this instance.
  value: number;
}

/// An instance of a component.
export interface FoundInstance {
  /// Id of the component.
  component: string;
  /// 16 hexadecimal digits that identify the instance among all instances.
  key: string;
  /// Number among its siblings, from 0.
  i: number;
  /// Number of siblings.
  n: number;
  /// Position among the siblings or along the stem, 0 to 1.
  u: number;
  /// Branching order.
  order: number;
  /// Depth of recursion.
  depth: number;
  /// Position in the world.
  position: [x: number, y: number, z: number];
  /// Parameters that differ from instance to instance.
  values: InstanceValue[];
  /// Label of its axis within the stem of the component. Null: an organ.
  shoot: string | null;
  /// Number of the stem among the stems of the component. Given with a label.
  stem?: number;
  /// Number of the root of the shoot among the roots of the stem. Given with a label.
  tree?: number;
  /// Metamer at the nearer end of the visible segment, counted from the base of the axis. Given with a label.
  metamer?: number;
  /// Three numbers for each node of the axis, the node from which it springs first. Given with a label.
  course?: number[];
  /// Number of the metamer that ends at each of these nodes. Given with a label.
  metamers?: number[];
  /// Iteration after which operations on the tree would act. Null: the component has no operations.
  iteration: number | null;
}

/// An instance.
export interface InstanceAnswer {
  /// The instance. Null: unknown, as in plants of other documents.
  instance: FoundInstance | null;
}

/// The name of a shoot, and a metamer on it.
export interface ShootName {
  /// Number of the stem among the component's stems.
  stem: number;
  /// Number of its root among the roots of the stem.
  tree: number;
  /// Label of the axis.
  shoot: string;
  /// Metamer, counted from the base of the axis.
  metamer: number;
}

/// Finds a shoot by its name, or a neighbouring shoot.
export interface ShootRequest {
  /// Id of the component.
  component: string;
  /// The shoot. Missing: the first shoot of the component.
  of?: ShootName | null;
  /// Step to a neighbour. `child`: the first shoot at or above the metamer, or else the last. `next`, `previous`: among
  /// the shoots of the parent, or among all stems, round and round. Missing: the shoot itself.
  go?: 'parent' | 'child' | 'next' | 'previous' | null;
}

/// Lists the effects of operations on trees.
export interface OperationsRequest {
  /// Id of the component.
  component: string;
  /// Path of an operation whose places are listed.
  operation?: string | null;
  /// Iteration after which it acted. Missing: any.
  iteration?: number | null;
}

/// One act of an operation.
export interface OperationPlace {
  /// Kind of the act.
  act: string;
  /// Iteration after which it acted.
  iteration: number;
  /// Number of the tree.
  tree: number;
  /// Label of the shoot.
  shoot: string;
  /// Metamer on the shoot.
  metamer: number;
  /// Position in the world.
  position: [x: number, y: number, z: number];
  /// Number of removed metamers.
  metamers: number;
  /// Positions of the shoot in its present state.
  course: [x: number, y: number, z: number][];
}

/// The effects of operations on the trees that have grown last.
export interface OperationEffects {
  /// Iteration after which further operations would act. Null: the component has no operations.
  iteration: number | null;
  /// Operations of a training, whose paths end in `.training.operations[K]`. Null: no training.
  training: Json[] | null;
  /// Number of acts of each operation, after each iteration.
  acts: [path: string, iteration: number, act: string, count: number][];
  /// Acts of the requested operation, at most 2,000.
  places: OperationPlace[];
  /// Number of acts that are left out.
  left: number;
}

/// The effects of operations.
export interface OperationsAnswer {
  /// The effects. Null: there is no such component.
  operations: OperationEffects | null;
}
