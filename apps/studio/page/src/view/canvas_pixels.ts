// SPDX-License-Identifier: Apache-2.0
// The number of pixels of a view's canvas. A processor draws a quarter of the pixels during movements, which takes less
// than half the time. At rest it draws four pixels for each, unless these are too many. Multisampling, which cards
// offer, would make each triangle three times as slow, during movements too.
import type * as three from 'three';

const kCoarse = 0.5;
const kFine = 2;
const kFinePixels = 4e6;

export class CanvasPixels {
  private frame_: [number, number] = [1, 1]; // pixels of the page
  private made_ = ''; // the sizes for which the canvas was made

  constructor(
    private readonly renderer_: three.WebGLRenderer,
    private readonly is_software_: boolean,
  ) {}

  resize(width: number, height: number): void {
    this.frame_ = [width, height];
  }

  /// Called just before a picture is drawn, because it clears the previous one. A canvas that changes its size waits
  /// for the card, up to seconds if a processor draws. Until then the previous picture is stretched.
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
    // A page that is zoomed out is shown on fewer pixels than it has
    const shown = Math.min(1, window.devicePixelRatio);
    return moves ? kCoarse * shown : Math.min(kFine * shown, Math.sqrt(kFinePixels / Math.max(1, width * height)));
  }
}
