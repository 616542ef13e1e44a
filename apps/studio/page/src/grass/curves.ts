// SPDX-License-Identifier: Apache-2.0
// The midrib and the width of a grass leaf: measured points, the curves fitted to them, and edits that replace files by
// editable curves.

import type { Point } from '../editors/shape.ts';
import type { Edit, LeafCurves, LeafName } from '../server/protocol.ts';
import { rounded } from '../values/arithmetic.ts';
import type { Json } from '../values/json.ts';
import { is_object } from '../values/json.ts';
import { path_below } from '../values/path.ts';
import type { Vec } from '../values/space_math.ts';

const kDrawn = 8; // pieces between the points of an editable curve that is made from a fitted one

export function name_of({ rank, leaf }: LeafName): string {
  const parts = [rank === null ? '' : `rank ${rank}`, leaf === null ? '' : `leaf ${leaf}`].filter((one) => one !== '');
  return parts.length > 0 ? parts.join(', ') : 'all leaves';
}

/// Returns a few points of a line, including its ends, rounded to a thousandth of its extent.
export function drawn_points(line: readonly Point[]): Point[] {
  const extent = Math.max(1e-9, ...line.map(([x, y]) => Math.max(Math.abs(x), Math.abs(y))));
  const step = 10 ** Math.floor(Math.log10(extent / 500));
  const indices = Array.from({ length: kDrawn + 1 }, (_, k) => Math.round((k * (line.length - 1)) / kDrawn));
  return [...new Set(indices)].map((k): Point => [rounded(line[k]?.[0] ?? 0, step), rounded(line[k]?.[1] ?? 0, step)]);
}

/// Parameters that only files need. They are removed with the last file.
const kOfFiles = ['rank', 'leaf', 'unit'];

/// Returns the edits that replace the midrib's file by points of the document. The blade keeps its length.
export function draw_midrib(path: string, said: Json | undefined, curves: LeafCurves): Edit[] {
  return draw(
    path,
    said,
    'midrib',
    'midrib_points',
    drawn_points(curves.midrib).map((one) => [...one]),
    'length',
    curves.length,
    'widths',
  );
}

/// Returns the edits that replace the file of widths by a profile of the document.
export function draw_widths(path: string, said: Json | undefined, curves: LeafCurves): Edit[] {
  const points = drawn_points(curves.widths).map(([place, share]) => [place, Math.max(0, share)]);
  return draw(path, said, 'widths', 'profile', { curve: points, kind: 'spline' }, 'width', curves.width, 'midrib');
}

function draw(
  path: string,
  said: Json | undefined,
  file: string,
  row: string,
  value: Json,
  size: string,
  measured: number,
  other: string,
): Edit[] {
  const given = is_object(said) ? said : {};
  const gone = [file, ...(given[other] === undefined ? kOfFiles : [])].filter((name) => given[name] !== undefined);
  return [
    { set: path_below(path, row), value },
    ...gone.map((name) => ({ unset: path_below(path, name) })),
    ...(given[size] === undefined && measured > 0
      ? [{ set: path_below(path, size), value: rounded(measured, 1e-4) }]
      : []),
  ];
}

/// Returns the length of a line of points.
export function line_length(line: readonly Point[]): number {
  return line
    .slice(1)
    .reduce((sum, [x, y], k) => sum + Math.hypot(x - (line[k]?.[0] ?? 0), y - (line[k]?.[1] ?? 0)), 0);
}

/// Returns a point of a midrib in the frame of the leaf: up along y and away along -z, `aside` metres beside the blade.
export function place_beside([away, up]: Point, scale: number, aside: number): Vec {
  return [aside, up * scale, -away * scale];
}
