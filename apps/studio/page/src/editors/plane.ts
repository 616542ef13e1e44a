// SPDX-License-Identifier: Apache-2.0
// A piece of a plane in a picture: its scale, the lines of its grid, and snapping of points.
import { fitting_step, rounded } from '../values/arithmetic.ts';
import type { Frame, Point, Range } from './shape.ts';

export interface PictureSize {
  wide: number;
  high: number;
  margin: number;
}

/// Converts between positions in the frame and positions in the picture.
export class Scale {
  private readonly across_: number;
  private readonly up_: number;

  /// If `is_even`, both directions have one scale, so that outlines keep their shape.
  constructor(
    readonly frame: Frame,
    private readonly size_: PictureSize,
    is_even: boolean,
  ) {
    const { x, y } = frame;
    const [across, up] = [
      (size_.wide - 2 * size_.margin) / (x.high - x.low),
      (size_.high - 2 * size_.margin) / (y.high - y.low),
    ];
    this.across_ = is_even ? Math.min(across, up) : across;
    this.up_ = is_even ? this.across_ : up;
  }

  place([x, y]: Point): Point {
    const { x: a, y: b } = this.frame;
    return [
      this.size_.wide / 2 + (x - (a.low + a.high) / 2) * this.across_,
      this.size_.high / 2 - (y - (b.low + b.high) / 2) * this.up_,
    ];
  }
  value([left, top]: Point): Point {
    const { x: a, y: b } = this.frame;
    return [
      (left - this.size_.wide / 2) / this.across_ + (a.low + a.high) / 2,
      (this.size_.high / 2 - top) / this.up_ + (b.low + b.high) / 2,
    ];
  }
  /// The size of a pixel in the plane, for both directions.
  get pixel(): Point {
    return [1 / this.across_, 1 / this.up_];
  }
  /// The part of the plane between the edges of the picture.
  get seen(): Frame {
    const [[left, top], [right, bottom]] = [this.value([0, 0]), this.value([this.size_.wide, this.size_.high])];
    return { x: { low: left, high: right }, y: { low: bottom, high: top } };
  }
}

/// Returns round numbers within a range that are at least `pixels` apart.
export function grid_lines(range: Range, per_pixel: number, pixels: number): { lines: number[]; step: number } {
  let step = fitting_step(0, per_pixel * pixels, 1);
  while (step < 0.999 * per_pixel * pixels) step = fitting_step(0, 2 * step, 1);
  const first = Math.ceil(range.low / step - 1e-9);
  const last = Math.floor(range.high / step + 1e-9);
  return {
    lines: Array.from({ length: Math.max(0, last - first + 1) }, (_, k) => rounded((first + k) * step, step)),
    step,
  };
}

export interface Snapped {
  point: Point;
  guides: { x: number | null; y: number | null }; // lines to which the point has snapped
}

const kReach = 4; // distance in pixels within which a point snaps to a line

/// Returns a dragged point, snapped to lines within a few pixels. Coordinates that do not snap are rounded to `digits`.
export function snapped(
  point: Point,
  levels: { x: readonly number[]; y: readonly number[] },
  scale: Scale,
  digits: number,
): Snapped {
  const pixel = scale.pixel;
  const nearest = (value: number, lines: readonly number[], reach: number): number | null => {
    let [best, min] = [null as number | null, reach];
    for (const line of lines) {
      const away = Math.abs(line - value);
      if (away <= min) [best, min] = [line, away];
    }
    return best;
  };
  const x = nearest(point[0], levels.x, kReach * pixel[0]);
  const y = nearest(point[1], levels.y, kReach * pixel[1]);
  return { point: [x ?? rounded(point[0], digits), y ?? rounded(point[1], digits)], guides: { x, y } };
}

/// Returns the coordinates to which a point may snap: other points and the lines of the grid.
export function levels_of(others: readonly Point[], scale: Scale, pixels: number): { x: number[]; y: number[] } {
  const { x, y } = scale.seen;
  return {
    x: [...grid_lines(x, scale.pixel[0], pixels).lines, ...others.map(([one]) => one)],
    y: [...grid_lines(y, scale.pixel[1], pixels).lines, ...others.map(([, one]) => one)],
  };
}
