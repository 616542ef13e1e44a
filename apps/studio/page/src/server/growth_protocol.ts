// SPDX-License-Identifier: Apache-2.0
// What the server tells of growth: shoots, what operations have done, and what is shown over the plant.
import type { Json } from '../document/json.ts';
import type { ArrayPlace } from './packet.ts';
import type { FoundInstance } from './protocol.ts';

/// A shoot by its name, and the metamer at a place on it.
export interface ShootName {
  stem: number;
  tree: number;
  shoot: string;
  metamer: number;
}

/// From one shoot to another along the tree.
export type ShootWay = 'parent' | 'child' | 'next' | 'previous';

/// A shoot that operations could act on.
export type FoundShoot = FoundInstance & ShootName & { course: number[]; metamers: number[]; iteration: number };

/// Path of an operation, iteration after which it acted, what it did, how often.
export type OperationAct = [string, number, string, number];

/// One thing that an operation did.
export interface OperationPlace {
  act: string;
  iteration: number;
  tree: number;
  shoot: string;
  metamer: number;
  position: [number, number, number];
  metamers: number; // that it took away
  course: [number, number, number][]; // of the shoot as it stands now
}

/// What operations have done to the trees of a component.
export interface ToldOperations {
  iteration: number | null;
  training: Json[] | null; // operations that a training stands for
  acts: OperationAct[];
  places: OperationPlace[]; // of the operation that was asked for
  left: number; // places that are not told
}

/// What may be shown over the plant.
export interface OverlayPart {
  name: string;
  title: string;
  doc: string;
  recorded: boolean; // growth must be recorded for it
}

/// Positions (three floats each) and colours (four bytes each) in the answer's arrays.
export interface ToldPlaces {
  positions: ArrayPlace;
  colours: ArrayPlace;
}

/// One overlay; lines and arrows have two places each.
export interface ToldLayer {
  part: string;
  points: ToldPlaces;
  lines: ToldPlaces;
  arrows: ToldPlaces;
  labels: { at: [number, number, number]; text: string }[];
  legend: { colour: [number, number, number]; text: string }[];
}

export interface OverlayLayers {
  step: number; // of growth, that they belong to
  layers: ToldLayer[];
}
