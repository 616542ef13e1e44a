// SPDX-License-Identifier: Apache-2.0
// Messages about growth: shoots, acts of operations, and overlays.
import type { Json } from '../values/json.ts';
import type { ArrayPlace } from './packet.ts';

/// A shoot by its name, and the metamer at a position on it.
export interface ShootName {
  stem: number;
  tree: number;
  shoot: string;
  metamer: number;
}

/// A step from one shoot to another along the tree.
export type ShootWay = 'parent' | 'child' | 'next' | 'previous';

/// Path of an operation, iteration after which it acted, kind of the act, and count.
export type OperationAct = [string, number, string, number];

/// One act of an operation.
export interface OperationPlace {
  act: string;
  iteration: number;
  tree: number;
  shoot: string;
  metamer: number;
  position: [number, number, number];
  metamers: number; // number of metamers that were removed
  course: [number, number, number][]; // course of the shoot in its present state
}

/// The effects of operations on the trees of a component.
export interface ToldOperations {
  iteration: number | null;
  training: Json[] | null; // operations of a training
  acts: OperationAct[];
  places: OperationPlace[]; // positions of the requested operation
  left: number; // number of positions that were left out
}

/// An overlay that can be shown on the plant.
export interface OverlayPart {
  name: string;
  title: string;
  doc: string;
  recorded: boolean; // true: needs recorded growth
}

/// Positions (three floats each) and colours (four bytes each) in the answer's arrays.
export interface ToldPlaces {
  positions: ArrayPlace;
  colours: ArrayPlace;
}

/// One overlay. Lines and arrows have two positions each.
export interface ToldLayer {
  part: string;
  points: ToldPlaces;
  lines: ToldPlaces;
  arrows: ToldPlaces;
  labels: { at: [number, number, number]; text: string }[];
  legend: { colour: [number, number, number]; text: string }[];
}

export interface OverlayLayers {
  step: number; // growth step of the layers
  layers: ToldLayer[];
}
