// SPDX-License-Identifier: Apache-2.0
// Midrib and width of a grass leaf: measured points with the curves fitted to them, and what it takes to draw them by
// hand instead.
import { rounded } from '../document/arithmetic.ts';
import type { Json } from '../document/json.ts';
import { is_object } from '../document/json.ts';
import { path_below } from '../document/path.ts';
import type { Point } from '../editors/shape.ts';
import type { Edit } from '../server/protocol.ts';
import type { Vec } from '../view/gizmo/space_math.ts';

export interface LeafName {
  rank: number | null;
  leaf: number | null;
}

export interface LeafCurves {
  leaves: LeafName[]; // that the source has
  leaf: LeafName; // whose curves these are
  midrib_points: Point[]; // away from the stem and up it, in the unit of the source
  midrib: Point[]; // fitted
  distance: number; // of the points from it
  width_points: Point[]; // share of the length, share of the largest width
  widths: Point[]; // fitted
  midrib_file: boolean;
  width_file: boolean;
  length: number; // metres as measured; 0: no file says it
  width: number;
}

const kDrawn = 8; // pieces between the points of a curve that is drawn by hand from a fitted one

export function name_of({ rank, leaf }: LeafName): string {
  const parts = [rank === null ? '' : `rank ${rank}`, leaf === null ? '' : `leaf ${leaf}`].filter((one) => one !== '');
  return parts.length > 0 ? parts.join(', ') : 'all leaves';
}

/// Few points of a line, its ends among them; rounded to a thousandth of its extent.
export function drawn_points(line: readonly Point[]): Point[] {
  const extent = Math.max(1e-9, ...line.map(([x, y]) => Math.max(Math.abs(x), Math.abs(y))));
  const step = 10 ** Math.floor(Math.log10(extent / 500));
  const indices = Array.from({ length: kDrawn + 1 }, (_, k) => Math.round((k * (line.length - 1)) / kDrawn));
  return [...new Set(indices)].map((k): Point => [rounded(line[k]?.[0] ?? 0, step), rounded(line[k]?.[1] ?? 0, step)]);
}

/// What is given where curves come from files alone, and goes with the last of them.
const kOfFiles = ['rank', 'leaf', 'unit'];

/// The midrib as points of the document in the place of its file; the blade keeps its length.
export function draw_midrib(path: string, said: Json | undefined, curves: LeafCurves): Edit[] {
  return draw(path, said, 'midrib', 'midrib_points', drawn_points(curves.midrib).map((one) => [...one]), 'length', curves.length, 'widths');
}

/// The widths as a profile of the document in the place of their file.
export function draw_widths(path: string, said: Json | undefined, curves: LeafCurves): Edit[] {
  const points = drawn_points(curves.widths).map(([place, share]) => [place, Math.max(0, share)]);
  return draw(path, said, 'widths', 'profile', { curve: points, kind: 'spline' }, 'width', curves.width, 'midrib');
}

function draw(path: string, said: Json | undefined, file: string, row: string, value: Json, size: string, measured: number, other: string): Edit[] {
  const given = is_object(said) ? said : {};
  const gone = [file, ...(given[other] === undefined ? kOfFiles : [])].filter((name) => given[name] !== undefined);
  return [
    { set: path_below(path, row), value },
    ...gone.map((name) => ({ unset: path_below(path, name) })),
    ...(given[size] === undefined && measured > 0 ? [{ set: path_below(path, size), value: rounded(measured, 1e-4) }] : []),
  ];
}

/// Metres along a line of points.
export function line_length(line: readonly Point[]): number {
  return line.slice(1).reduce((sum, [x, y], k) => sum + Math.hypot(x - (line[k]?.[0] ?? 0), y - (line[k]?.[1] ?? 0)), 0);
}

/// A point of a midrib in the frame of the leaf: up along y and away along -z, `aside` metres beside the blade.
export function place_beside([away, up]: Point, scale: number, aside: number): Vec {
  return [aside, up * scale, -away * scale];
}
