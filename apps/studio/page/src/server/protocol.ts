// SPDX-License-Identifier: Apache-2.0
// The messages between page and server, as apps/studio/protocol.md defines them.
import type { Json } from '../values/json.ts';
import type { PlainPatch } from '../values/patch.ts';
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

/// A link that is not in the text: a component places another one itself.
export interface ImpliedLink {
  from: string;
  to: string;
}

/// The facts that reading a text gives.
export interface Reading {
  good: boolean;
  faults: Fault[];
  tree: Json;
  variables: Variable[];
  implied: ImpliedLink[]; // links of the last text without errors
  notes: Record<string, string>; // comments of the document, by component
  superseded?: boolean; // true: a newer text came, so the text was not read and the other members are missing
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

/// The members of an `open` request.
export interface OpenWish {
  path?: string | null;
  model?: string;
  text?: string;
}

export interface Opened extends Reading {
  path: string | null;
  model: string | null; // name of the shipped model
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

/// The components of a document from which parts can be copied.
export interface ReadParts {
  tree: Json;
  implied: ImpliedLink[];
}

/// An instance of a component, with the values that differ from instance to instance.
export interface FoundInstance {
  component: string;
  key: string; // identifies the instance among all others
  i: number;
  n: number;
  u: number;
  order: number;
  depth: number;
  position: [number, number, number];
  values: { path: string; value: number }[];
  shoot: string | null; // label of the axis that was pointed at
  stem?: number; // number of its stem among the component's stems
  tree?: number; // number of its tree among that stem's trees
  metamer?: number; // metamer at the position that was pointed at, counted from the axis's base
  course?: number[]; // three numbers for each node of the axis, including the node from which it branches off
  metamers?: number[]; // number of the metamer that ends at each of these nodes
  iteration: number | null; // growth iteration after which operations on it would act; null if none can
}

/// Clocks that instances of a component have begun: the start and the speed of each.
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
  frames?: { from: number; to: number; step: number }; // frames of a film, or of pictures of several times
}

/// A small picture of a state of the document. A state with faults has no picture.
export interface Still {
  picture?: string; // base 64 of a PNG
  faults?: Fault[];
}

/// The derivation of a grammar. If the component has no instance, there is only `text`, and it is null.
export interface Derivation {
  text: string | null;
  instance?: { number: number; of: number; key: string }; // the instance among the component's instances
  steps: number; // number of steps of the component
  step: number; // requested step
  interpreted: boolean; // true: rules of interpretation are applied before drawing
  count: number; // number of modules of the word
  counts: [string, number][]; // number of modules by symbol
  first: number; // index of the first module in the answer
  modules: string[];
  places: number[]; // seven numbers for each drawn module: its index, its beginning and its end
}

export interface MadeFile {
  name: string;
  bytes: number;
  address: string;
  holds: string[]; // names of the files in an archive
}

export interface Hello {
  is: 'hello';
  protocol: number;
  version: string;
  root: string;
  root_key: string; // identifies the folder among folders of its name
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
  step: number; // growth step that is shown
  steps: number | null; // number of steps of the plants that the step is for; null if growth is not recorded
  growing: Record<string, number> | null; // number of steps of each component's plants
}

export interface Failed {
  is: 'failed';
  job: string;
  hash: string;
  faults: Fault[];
  message: string;
  limit?: string;
  continues?: boolean; // true: the work reached its time limit, and `continue` continues it
}

/// The number of other tabs and programs that have the file open.
export interface Elsewhere {
  is: 'elsewhere';
  path: string;
  count: number;
}

export type News = Hello | Working | Grown | Failed | Elsewhere;

/// The reason why the server refused a request.
export class Refusal extends Error {
  constructor(
    message: string,
    readonly facts: { stale?: boolean; changed?: boolean; cancelled?: boolean; limit?: string; faults?: Fault[] },
  ) {
    super(message);
  }

  /// The faults of the text, or else the message as a fault. There is always at least one.
  get reasons(): Fault[] {
    const own: Fault = {
      severity: 'error',
      message: this.message,
      path: '',
      line: null,
      column: null,
      offset: null,
      text: this.message,
    };
    return this.facts.faults?.length ? this.facts.faults : [own];
  }
}
