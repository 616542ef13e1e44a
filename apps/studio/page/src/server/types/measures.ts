// SPDX-License-Identifier: Apache-2.0
// Messages about measures of the document.
// `meristem_studio_protocol` writes this file from apps/studio/protocol.
import type { Json } from '../../values/json.ts';
import type { Fault } from './document.ts';

/// Measures the document.
export interface MeasuresRequest {
  /// True: also measures the light on organs.
  light?: boolean | null;
  /// Height of the layers for leaf area by height. 0: no layers.
  layer_height?: number | null;
}

/// Measures of the document.
export interface MeasuresAnswer {
  /// Measures by name, as `meristem measure --json` prints them.
  measures: Record<string, Json>;
}

/// A measure.
export interface MeasureRow {
  /// Name in `measures`.
  name: string;
  /// Unit, or an empty text.
  unit: string;
  /// Description.
  doc: string;
}

/// All measures.
export interface MeasureRowsAnswer {
  /// In their order.
  rows: MeasureRow[];
}

/// Measures the document with each of several values. Each value has `job_seconds`.
export interface SweepRequest {
  /// Path of a variable or a number.
  path: string;
  /// The values.
  values: readonly number[];
  /// True: also measures the light on organs.
  light?: boolean | null;
}

/// The document with one of the values.
export interface SweepPoint {
  /// The value.
  value: number;
  /// Measures by name.
  measures?: Record<string, Json>;
  /// Faults with this value, instead of measures.
  faults?: Fault[];
}

/// Measures for each value.
export interface SweepAnswer {
  /// In the order of the values.
  sweep: SweepPoint[];
}
