// SPDX-License-Identifier: Apache-2.0
// Questions about the grown plant: derivations, overlays, places and values of components.
// `meristem_studio_protocol` writes this file from apps/studio/protocol.
/// Derives the grammar of a component. Refused if the text has faults, and with `faults` beyond limits.
export interface GrammarRequest {
  /// Id of the component.
  component: string;
  /// Steps of the derivation. Null: the steps of the component.
  step?: number | null;
  /// Key of an instance. Missing, or without an instance: by `number`.
  instance?: string | null;
  /// Number of the instance.
  number?: number | null;
  /// True: the word after the rules of interpretation.
  drawn?: boolean | null;
  /// Index of the first module of the answer.
  first?: number | null;
  /// Maximum number of modules of the answer.
  count?: number | null;
}

/// The instance whose grammar was derived.
export interface DerivedInstance {
  /// Number among the instances of the component.
  number: number;
  /// Number of instances of the component.
  of: number;
  /// Key of the instance.
  key: string;
}

/// The derivation of a grammar.
export interface Derivation {
  /// Text of the grammar. Null: the component has no instance or no grammar, and the other members are missing.
  text: string | null;
  /// The instance whose grammar was derived.
  instance: DerivedInstance;
  /// Number of steps of the component.
  steps: number;
  /// Number of steps of this word.
  step: number;
  /// True: the grammar has rules of interpretation.
  interpreted: boolean;
  /// Number of modules of the word.
  count: number;
  /// Number of modules by symbol.
  counts: [symbol: string, count: number][];
  /// Index of the first module of the answer.
  first: number;
  /// Texts of the modules.
  modules: string[];
  /// Seven numbers for each drawn module of the answer: its index, its beginning and its end. Empty if this word is not
  /// drawn.
  places: number[];
}

/// A derivation.
export interface GrammarAnswer {
  /// The derivation.
  derivation: Derivation;
}

/// Requests overlays on the last grown plant. Overlays with `recorded` need recorded growth.
export interface OverlaysRequest {
  /// Names of `overlays` of `hello`.
  parts: readonly string[];
}

/// Points with colours.
export interface ColouredPoints {
  /// Three f32 for each point.
  positions: [at: number, count: number];
  /// Four u8 for each point: sRGB and opacity.
  colours: [at: number, count: number];
}

/// A text at a point.
export interface OverlayLabel {
  /// Position.
  at: [x: number, y: number, z: number];
  /// The text.
  text: string;
}

/// The meaning of a colour.
export interface OverlayKey {
  /// sRGB.
  colour: [x: number, y: number, z: number];
  /// The meaning.
  text: string;
}

/// One overlay.
export interface PackedLayer {
  /// Name of the overlay.
  part: string;
  /// Single points.
  points: ColouredPoints;
  /// Two points for each line.
  lines: ColouredPoints;
  /// Two points for each arrow.
  arrows: ColouredPoints;
  /// Texts in space.
  labels: OverlayLabel[];
  /// Meanings of the colours.
  legend: OverlayKey[];
}

/// Overlays on the last grown plant.
export interface OverlayLayers {
  /// Growth step of the layers.
  step: number;
  /// The overlays.
  layers: PackedLayer[];
}

/// Overlays. The answer is a packet with their arrays.
export interface OverlaysAnswer {
  /// The overlays.
  overlays: OverlayLayers;
}

/// Requests the place of the first instance of a component.
export interface StandRequest {
  /// Id of the component.
  component: string;
}

/// The place of a component.
export interface StandAnswer {
  /// Frame of the site of the first instance, before the `frame` of the component: three rows of a 3x4 matrix. Null:
  /// the component has no instance.
  stand: number[] | null;
}

/// Computes values of expressions in the last grown plant.
export interface WorkedOutRequest {
  /// Component whose first instance gives the values that differ among instances. Missing: only the variables.
  component?: string | null;
  /// Expressions by their full paths in the document.
  expressions: Record<string, string>;
}

/// Values of expressions.
export interface WorkedOutAnswer {
  /// Values by the same paths. Unknown values are missing.
  numbers: Record<string, number>;
}

/// Requests the curves from which a grass leaf is drawn.
export interface CurvesRequest {
  /// Id of the component.
  component: string;
  /// Rank of the leaf. Missing: any.
  rank?: number | null;
  /// Number of the leaf within its rank. Missing: any.
  leaf?: number | null;
}

/// A leaf of the source of a grass leaf.
export interface LeafName {
  /// Rank. Null: the source has no ranks.
  rank: number | null;
  /// Number within the rank.
  leaf: number | null;
}

/// The curves from which a grass leaf is drawn.
export interface LeafCurves {
  /// Leaves of the source.
  leaves: LeafName[];
  /// The leaf of these curves.
  leaf: LeafName;
  /// Measured points: away from the stem and up along it, in the unit of the source.
  midrib_points: [x: number, y: number][];
  /// Fitted midrib.
  midrib: [x: number, y: number][];
  /// Distance of the points from the fitted midrib.
  distance: number;
  /// Measured widths: share of the length, and share of the largest width.
  width_points: [x: number, y: number][];
  /// Fitted widths.
  widths: [x: number, y: number][];
  /// True: the midrib comes from a file.
  midrib_file: boolean;
  /// True: the widths come from a file.
  width_file: boolean;
  /// Measured length. 0: no file gives it.
  length: number;
  /// Measured width. 0: no file gives it.
  width: number;
}

/// The curves of a grass leaf.
export interface CurvesAnswer {
  /// The curves. Null: the component is no grass leaf.
  curves: LeafCurves | null;
}

/// Requests the attraction points of a crown.
export interface CloudRequest {
  /// Id of the component.
  component: string;
}

/// The attraction points with which the first instance begins.
export interface CrownCloud {
  /// Three f32 for each point, relative to the root. More than 4,000 points are reduced to an even choice.
  positions: [at: number, count: number];
  /// Number of all points.
  count: number;
}

/// The attraction points of a crown. The answer is a packet with their array.
export interface CloudAnswer {
  /// The points. Null: the component fills no crown with points.
  cloud: CrownCloud | null;
}

/// Requests the clocks that have begun up to a time.
export interface ClocksRequest {
  /// Time of the document up to which clocks begin.
  up_to: number;
}

/// The clocks that instances of a component have begun, each once.
export interface BegunClocks {
  /// Id of the component, a `sequence`.
  component: string;
  /// Number of clocks.
  count: number;
  /// The time of the document at which each clock shows 0, and its seconds per second of the document. More than 400
  /// clocks are reduced to an even choice.
  blocks: [start: number, speed: number][];
}

/// The clocks of the plant.
export interface ClocksAnswer {
  /// By component.
  clocks: BegunClocks[];
}
