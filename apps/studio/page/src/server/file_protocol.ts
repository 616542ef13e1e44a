// SPDX-License-Identifier: Apache-2.0
// Messages about files below the server's folder.
import type { Reading } from './protocol.ts';

export interface ListedFile {
  name: string;
  folder: boolean;
  bytes: number;
}

/// The answer to `save`. It has the reading and the files only if the path has changed.
export interface Saved extends Partial<Reading> {
  path: string;
  name: string;
  saved: string;
  copied?: string[]; // files that the document names and that were copied to its new place
  omitted?: { file: string; reason: string }[]; // files that were not copied
}
