// SPDX-License-Identifier: Apache-2.0
// Messages about exported files and small pictures of the document.
// `meristem_studio_protocol` writes this file from apps/studio/protocol.
import type { Json } from '../../values/json.ts';
import type { Fault } from './document.ts';

/// The camera of a picture.
export interface ExportCamera {
  /// Position of the camera.
  position: readonly [x: number, y: number, z: number];
  /// Point in the middle of the picture.
  target: readonly [x: number, y: number, z: number];
  /// Vertical angle of view. A larger angle shows more.
  field_of_view: number;
}

/// The times of pictures.
export interface ExportFrames {
  /// Time of the first picture.
  from: number;
  /// Time that no picture exceeds.
  to: number;
  /// Time between pictures. A larger step makes fewer pictures.
  step: number;
}

/// Options of an export.
export interface ExportOptions {
  /// Number of coarser levels that are written too.
  lod?: number | null;
  /// How instances are stored. Only for formats that can store them.
  instances?: 'automatic' | 'rows' | 'nodes' | null;
  /// Seed instead of the seed of the document.
  seed?: number | null;
  /// Time of the document.
  time?: number | null;
  /// Width of pictures, pixels. Missing: the document's own.
  width?: number | null;
  /// Height of pictures, pixels. Missing: the document's own.
  height?: number | null;
  /// Rays per pixel of pictures. More rays make smoother pictures and take longer.
  samples?: number | null;
  /// True: pictures have no background.
  transparent?: boolean | null;
  /// Camera of pictures. Missing: the document's own.
  camera?: ExportCamera | null;
  /// Times of a film, or of several pictures. Missing: a film of the whole animation, or one picture.
  frames?: ExportFrames | null;
}

/// Makes a file of the document for a download.
export interface ExportRequest {
  /// An ending of `formats`.
  format: string;
  /// Name of the file, without an ending. Null: the name of the document.
  name?: string | null;
  /// Options of the export.
  options?: ExportOptions | null;
}

/// A file that can be downloaded.
export interface MadeFile {
  /// Name of the file.
  name: string;
  /// Size of the file.
  bytes: number;
  /// Address below the token: `downloads/3/oak.glb`.
  address: string;
  /// Names of the files in a zip archive. Empty: the file is no archive.
  holds: string[];
}

/// An exported file.
export interface ExportAnswer {
  /// The file. Several files come as a zip archive.
  file: MadeFile;
}

/// Names the command line that exports the same files.
export interface CommandRequest {
  /// An ending of `formats`.
  format: string;
  /// Name of the file, without an ending. Null: the name of the document.
  name?: string | null;
  /// Options of the export.
  options?: ExportOptions | null;
}

/// A command line.
export interface CommandAnswer {
  /// The command that exports the same files.
  command: string;
}

/// Makes small pictures of the document with other values. The document and the view do not change.
export interface StillsRequest {
  /// Values of each picture, by their paths as in `drag`. Empty: cancels the previous request.
  states: readonly Record<string, Json>[];
  /// Width of each picture, pixels.
  width?: number | null;
  /// Height of each picture, pixels.
  height?: number | null;
  /// Camera of each picture.
  camera?: ExportCamera | null;
  /// True: moves the camera back until it shows the whole of the largest plant.
  fit?: boolean | null;
}

/// A small picture of a state of the document.
export interface Still {
  /// A PNG in base 64 without a background.
  picture?: string;
  /// Faults of the state, which then has no picture.
  faults?: Fault[];
}

/// Small pictures.
export interface StillsAnswer {
  /// A picture for each state.
  stills: Still[];
}
