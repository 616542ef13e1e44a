// SPDX-License-Identifier: Apache-2.0
// What is seen at a pixel: which batch, and which of its instances. A ray through the pixel is followed here and not on
// the card, from which one pixel would take as long to read as a whole picture to draw. Leaves are not there where their
// picture has holes.
import * as three from 'three';

import type { Batch } from './buffers.ts';
import { Holes } from './holes.ts';
import type { Ray } from './ray.ts';
import { first_hit } from './ray.ts';

/// A batch as it is drawn; `picture` where its holes count.
export interface PickTarget {
  batch: Batch;
  picture: three.Texture | null;
}

export interface Picked {
  target: number; // index into the targets
  instance: number; // along the batch
  position: [number, number, number]; // of what was hit, in the world
}

export class Picker {
  private readonly holes_ = new Holes();

  /// `x` and `y` are pixels of a picture of this width and height, from its upper left corner.
  pick(targets: readonly PickTarget[], camera: three.PerspectiveCamera, [x, y]: [number, number], [width, height]: [number, number]): Picked | null {
    const ray = ray_through(camera, (2 * (x + 0.5)) / width - 1, 1 - (2 * (y + 0.5)) / height);
    let found: Picked | null = null;
    for (const [target, { batch, picture }] of targets.entries()) {
      const frames = batch.frames.image.data as Float32Array;
      const hit = first_hit(batch.solid, frames, batch.instances, ray, picture && this.holes_.of(picture));
      if (!hit) continue;
      ray.farthest = hit.share;
      const at = new three.Vector3(...ray.from).addScaledVector(new three.Vector3(...ray.along), hit.share);
      found = { target, instance: hit.instance, position: at.toArray() };
    }
    return found;
  }
}

/// From the camera through a place of its picture, both from -1 to 1; shares of it are distances along the view.
function ray_through(camera: three.PerspectiveCamera, x: number, y: number): Ray {
  camera.updateMatrixWorld();
  const from = new three.Vector3().setFromMatrixPosition(camera.matrixWorld);
  const along = new three.Vector3(x, y, 0.5).unproject(camera).sub(from);
  along.divideScalar(along.dot(camera.getWorldDirection(new three.Vector3())));
  return { from: from.toArray(), along: along.toArray(), nearest: camera.near, farthest: camera.far };
}
