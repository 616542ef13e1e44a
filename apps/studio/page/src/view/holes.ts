// SPDX-License-Identifier: Apache-2.0
// The holes in the pictures of leaves, for picking by the processor. Their alpha is kept as long as the picture.
import type * as three from 'three';

import type { IsHole } from './ray.ts';

const kMax = 512; // largest number of pixels per side that are kept

export class Holes {
  private readonly known_ = new WeakMap<object, IsHole>();

  /// Returns a function that is true if a picture's alpha at (u, v) is below one half. The picture repeats with period
  /// 1.
  of(picture: three.Texture): IsHole | null {
    const image = picture.image as ImageBitmap | null;
    if (!image) return null;
    const known = this.known_.get(image);
    if (known) return known;
    const [width, height] = [Math.min(kMax, image.width), Math.min(kMax, image.height)];
    const context = new OffscreenCanvas(width, height).getContext('2d', { willReadFrequently: true });
    if (!context) return null;
    context.drawImage(image, 0, 0, width, height);
    const { data } = context.getImageData(0, 0, width, height);
    const pixel = (share: number, pixels: number): number =>
      Math.min(pixels - 1, Math.floor((share - Math.floor(share)) * pixels));
    const made: IsHole = (u, v) => (data[4 * (pixel(v, height) * width + pixel(u, width)) + 3] ?? 255) < 128;
    this.known_.set(image, made);
    return made;
  }
}
