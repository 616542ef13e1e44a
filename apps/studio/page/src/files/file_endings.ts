// SPDX-License-Identifier: Apache-2.0
// The endings of files for a row. The row's sentence in the tables names the formats.
import type { Row } from '../tables/tables.ts';

const kEndings: Record<string, string[]> = {
  OBJ: ['.obj'],
  PLY: ['.ply'],
  GLB: ['.glb'],
  CSV: ['.csv'],
  PNG: ['.png'],
  JPEG: ['.jpg', '.jpeg'],
  text: ['.txt', '.xyz', '.lpy', '.l'],
};

/// Returns true if a row names a picture.
export function names_pictures(row: Row): boolean {
  return row.kind === 'file' && endings_in(row.doc).includes('.png');
}

/// Returns the endings of the formats that a sentence names. Returns an empty list if it names no format; any file is
/// then accepted.
export function endings_in(sentence: string): string[] {
  return Object.entries(kEndings).flatMap(([word, endings]) =>
    new RegExp(`\\b${word}\\b`).test(sentence) ? endings : [],
  );
}
