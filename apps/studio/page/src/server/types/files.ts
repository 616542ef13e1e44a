// SPDX-License-Identifier: Apache-2.0
// Messages about files below the root, shipped models and parts of documents.
// `meristem_studio_protocol` writes this file from apps/studio/protocol.
import type { Json } from '../../values/json.ts';
import type { ImpliedLink, Reading } from './document.ts';

/// Lists a folder.
export interface FilesRequest {
  /// Path below the root. Empty: the root.
  folder: string;
}

/// A file or folder in a list.
export interface ListedFile {
  /// Name without its folder.
  name: string;
  /// True: a folder.
  folder: boolean;
  /// Size of a file.
  bytes: number;
}

/// The content of a folder.
export interface FilesAnswer {
  /// Path below the root.
  folder: string;
  /// By name. Hidden files are left out.
  files: ListedFile[];
}

/// Saves the document. Refused with `changed` if the file on the disk is not as expected, and with `stale` if the
/// server has another text. A refused `save` leaves the file as it was.
export interface SaveRequest {
  /// Path below the root.
  path: string;
  /// Hash of the text of the page. The server saves no other text.
  hash: string;
  /// Hash that the page expects on the disk. Null: a new file.
  saved?: string | null;
  /// True: replaces the file even if its hash is not `saved`.
  over?: boolean | null;
}

/// A file that was not copied.
export interface OmittedFile {
  /// Path of the file in the document.
  file: string;
  /// Why it was not copied.
  reason: string;
}

/// The files that the document names by relative paths.
export interface CopiedFiles {
  /// Files that were missing beside the new path, and were copied to there.
  copied: string[];
  /// Files that were not copied. A file with another content is never replaced.
  omitted: OmittedFile[];
}

/// A saved document. If the path has changed, the files that the document names are searched beside it, and the text is
/// read again.
export interface SaveAnswer extends Partial<CopiedFiles>, Partial<Reading> {
  /// Path below the root.
  path: string;
  /// Name for a title.
  name: string;
  /// Hash of the file on the disk.
  saved: string;
}

/// A shipped model.
export interface ShippedModel {
  /// Name in requests.
  name: string;
  /// Name for users.
  title: string;
  /// Description.
  description: string;
  /// True: `pictures/NAME.jpg` exists.
  picture: boolean;
}

/// The shipped models.
export interface ModelsAnswer {
  /// By name.
  models: ShippedModel[];
}

/// Lists the components of a shipped model.
export interface PartsRequest {
  /// Name of the model.
  model: string;
}

/// The components of a model.
export interface PartsAnswer {
  /// The document as plain JSON.
  tree: Json;
  /// Links that are not in it.
  implied: ImpliedLink[];
}

/// Cuts a part out of a model, of a text, or of the document.
export interface PartRequest {
  /// Name of a shipped model.
  model?: string | null;
  /// Text of a document.
  text?: string | null;
  /// Ids of components. Missing: all but cameras.
  components?: readonly string[] | null;
}

/// A part of a document.
export interface PartAnswer {
  /// A document with these components, the links among them and the variables that they name, as they are written.
  text: string;
  /// Ids of its components.
  components: string[];
  /// Components to which no other component of the part links.
  roots: string[];
}

/// Makes a small version of a picture.
export interface PictureRequest {
  /// Path of the picture as the document writes it.
  file: string;
  /// Pixels along the longer side.
  size?: number | null;
}

/// A small picture.
export interface Thumbnail {
  /// A PNG in base 64.
  picture: string;
  /// Width of the whole picture, pixels.
  width: number;
  /// Height of the whole picture, pixels.
  height: number;
}

/// A small version of a picture.
export interface PictureAnswer {
  /// The small picture.
  thumbnail: Thumbnail;
}

/// The number of other pages that have the file open. It comes when the number changes.
export interface Elsewhere {
  is: 'elsewhere';
  /// Path of the file.
  path: string;
  /// Number of other pages, also of other programs of the same user.
  count: number;
}
