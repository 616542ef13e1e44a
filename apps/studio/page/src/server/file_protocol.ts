// SPDX-License-Identifier: Apache-2.0
// What the server tells of files below its folder.
import type { Reading } from './protocol.ts';

export interface ListedFile {
  name: string;
  folder: boolean;
  bytes: number;
}

/// The answer to `save`. The reading and the files are there if the path is another one than before.
export interface Saved extends Partial<Reading> {
  path: string;
  name: string;
  saved: string;
  copied?: string[]; // files that the document names, copied to its new place
  omitted?: { file: string; reason: string }[]; // and those that were not copied
}
