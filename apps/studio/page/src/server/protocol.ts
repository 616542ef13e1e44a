// SPDX-License-Identifier: Apache-2.0
// What the page and the server tell each other, as apps/studio/protocol.md defines it.
import type { Json } from '../document/json.ts';
import type { PlainPatch } from '../document/patch.ts';
import type { OverlayPart } from './growth_protocol.ts';

export interface Fault {
  severity: 'error' | 'warning';
  message: string;
  expected?: string | null;
  nearest?: string | null;
  path: string;
  line: number | null;
  column: number | null;
  offset: number | null;
  text: string;
}

export interface Variable {
  name: string;
  value: number;
  min: number;
  max: number;
  unit: string;
  doc: string;
  expression: string | null;
  private: boolean;
}

/// A link that stands in no text: a component places another one itself.
export interface ImpliedLink {
  from: string;
  to: string;
}

/// What reading a text says of it.
export interface Reading {
  good: boolean;
  faults: Fault[];
  tree: Json;
  variables: Variable[];
  implied: ImpliedLink[]; // of the last text without errors
  notes: Record<string, string>; // comments of the document, by component
  superseded?: boolean; // the text was not read, since a newer one had come: nothing of the above is there
}

export type Edit =
  | { set: string; value: Json }
  | { unset: string }
  | { insert: string; value: Json; index?: number }
  | { remove: string }
  | { rename: string; name: string }
  | { move: string; index: number }
  | { note: string; text: string }
  | { paste: string; names: Record<string, string>; index: number; link_index?: number };

/// What a page asks for with `open`.
export interface OpenWish {
  path?: string | null;
  model?: string;
  text?: string;
}

export interface Opened extends Reading {
  path: string | null;
  model: string | null; // the shipped one's name
  name: string;
  text: string;
  hash: string;
  saved: string | null;
}

export interface Edited extends Reading {
  patch: PlainPatch;
  inverse: PlainPatch;
  hash: string;
}

/// The components of a document that parts can be taken from.
export interface ReadParts {
  tree: Json;
  implied: ImpliedLink[];
}

/// An instance of a component, with the values that differ from instance to instance.
export interface FoundInstance {
  component: string;
  key: string; // tells it from all others
  i: number;
  n: number;
  u: number;
  order: number;
  depth: number;
  position: [number, number, number];
  values: { path: string; value: number }[];
  shoot: string | null; // label of the axis that was pointed at
  stem?: number; // whose axis it is, among the stems of the component
  tree?: number; // and among the trees of that stem
  metamer?: number; // at the place that was pointed at, counted from the axis's base
  course?: number[]; // three numbers for each node of the axis, with the one that it springs from
  metamers?: number[]; // number of the metamer that ends at each of these nodes
  iteration: number | null; // of growth, after which operations on it would act; null where none could
}

/// Clocks that instances of a component have begun: when each starts, and how fast it runs.
export interface BegunClocks {
  component: string;
  count: number;
  blocks: [number, number][];
}

export interface ShippedModel {
  name: string;
  title: string;
  description: string;
  picture: boolean;
}

export interface Format {
  ending: string;
  doc: string;
  levels: boolean;
  instances: boolean;
}

export interface ExportOptions {
  lod?: number;
  instances?: string;
  seed?: number;
  time?: number;
  width?: number;
  height?: number;
  samples?: number;
  transparent?: boolean;
  camera?: { position: number[]; target: number[]; field_of_view: number };
  frames?: { from: number; to: number; step: number }; // of a film, or of pictures of several times
}

/// A small picture of a state of the document; without one where the state has faults.
export interface Still {
  picture?: string; // base 64 of a PNG
  faults?: Fault[];
}

/// What a grammar has derived; `text` alone, and null, where the component has no instance.
export interface Derivation {
  text: string | null;
  instance?: { number: number; of: number; key: string }; // which of the component's instances it is
  steps: number; // of the component
  step: number; // that was asked for
  interpreted: boolean; // whether rules of interpretation are applied before drawing
  count: number; // of the word's modules
  counts: [string, number][]; // of modules by symbol
  first: number; // index of the first module told
  modules: string[];
  places: number[]; // seven for each module that was drawn: its index, from where, to where
}

export interface MadeFile {
  name: string;
  bytes: number;
  address: string;
  holds: string[]; // of an archive
}

export interface Hello {
  is: 'hello';
  protocol: number;
  version: string;
  root: string;
  root_key: string; // tells the folder from others of its name
  document: string | null;
  model: string | null;
  formats: Format[];
  overlays: OverlayPart[];
  limits: Record<string, number>;
}

export interface Working {
  is: 'working';
  job: 'grow' | 'export' | 'measure' | 'sweep' | 'stills' | 'grammar' | 'picture' | 'question';
  re?: number;
  stage: string | null;
  share: number;
}

export interface Grown {
  is: 'grown';
  hash: string;
  dragged: boolean;
  stages: { name: string; ms: number }[];
  reuse: { what: string; made: number; reused: number }[];
  nodes: number;
  instances: number;
  /// Null while a coarser level is shown.
  triangles: number | null;
  components: Record<string, { instances: number; triangles: number }> | null;
  /// Instances of each component; null in a drag.
  placed: Record<string, number> | null;
  step: number; // of growth, that is shown
  steps: number | null; // that growth took, of the plants that the step is for; null where it is not recorded
  growing: Record<string, number> | null; // steps that the plants of each component take
}

export interface Failed {
  is: 'failed';
  job: string;
  hash: string;
  faults: Fault[];
  message: string;
  limit?: string;
  continues?: boolean; // the work reached its time limit, and `continue` goes on with it
}

/// How many other tabs and programs have the file open.
export interface Elsewhere {
  is: 'elsewhere';
  path: string;
  count: number;
}

export type News = Hello | Working | Grown | Failed | Elsewhere;

/// Why the server would not do it.
export class Refusal extends Error {
  constructor(
    message: string,
    readonly facts: { stale?: boolean; changed?: boolean; cancelled?: boolean; limit?: string; faults?: Fault[] },
  ) {
    super(message);
  }

  /// Faults of the text, or the message as one: what was refused always has a reason.
  get reasons(): Fault[] {
    const own: Fault = { severity: 'error', message: this.message, path: '', line: null, column: null, offset: null, text: this.message };
    return this.facts.faults?.length ? this.facts.faults : [own];
  }
}
