// SPDX-License-Identifier: Apache-2.0
// The tables say in a row's sentence which formats its files may have; here is how files of such formats end.
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

/// Whether a row names a picture.
export function names_pictures(row: Row): boolean {
  return row.kind === 'file' && endings_in(row.doc).includes('.png');
}

/// Endings of the formats that a sentence names; none where it names none, and any file may do.
export function endings_in(sentence: string): string[] {
  return Object.entries(kEndings).flatMap(([word, endings]) => (new RegExp(`\\b${word}\\b`).test(sentence) ? endings : []));
}
