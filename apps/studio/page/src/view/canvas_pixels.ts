// SPDX-License-Identifier: Apache-2.0
// How many pixels the canvas of a view has. A processor draws a quarter of them while something moves, in less than half
// the time. At rest it draws four for each, as long as they are not too many: several samples per pixel, which cards have,
// would make each triangle three times as dear while hands move too.
import type * as three from 'three';

const kCoarse = 0.5;
const kFine = 2;
const kFinePixels = 4e6;

export class CanvasPixels {
  private frame_: [number, number] = [1, 1]; // pixels of the page
  private made_ = ''; // for what the canvas was made

  constructor(
    private readonly renderer_: three.WebGLRenderer,
    private readonly is_software_: boolean,
  ) {}

  resize(width: number, height: number): void {
    this.frame_ = [width, height];
  }

  /// Just before a picture is drawn, since it clears the last one, and since a canvas whose size changes waits for the
  /// card: up to seconds where a processor draws. Until then the last picture is stretched.
  suit(moves: boolean): void {
    const [width, height] = this.frame_;
    const ratio = this.ratio(moves);
    const wanted = `${width} ${height} ${ratio}`;
    if (wanted === this.made_) return;
    this.made_ = wanted;
    this.renderer_.setDrawingBufferSize(width, height, ratio);
  }

  private ratio(moves: boolean): number {
    if (!this.is_software_) return Math.min(2, window.devicePixelRatio);
    const [width, height] = this.frame_;
    const shown = Math.min(1, window.devicePixelRatio); // a page that is zoomed out is shown on fewer pixels than it has
    return moves ? kCoarse * shown : Math.min(kFine * shown, Math.sqrt(kFinePixels / Math.max(1, width * height)));
  }
}
