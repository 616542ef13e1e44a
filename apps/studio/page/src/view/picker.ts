// SPDX-License-Identifier: Apache-2.0
// Finds the batch and the instance at a pixel by a ray. The ray is followed here and not on the card: reading one pixel
// from the card would take as long as drawing a whole picture. Rays pass through the holes of leaf pictures.
import * as three from 'three';

import type { Batch } from './buffers.ts';
import { Holes } from './holes.ts';
import type { Ray } from './ray.ts';
import { first_hit } from './ray.ts';

/// A drawn batch; `picture` is set if its holes count.
export interface PickTarget {
  batch: Batch;
  picture: three.Texture | null;
}

export interface Picked {
  target: number; // index into the targets
  instance: number; // number of the instance in the batch
  position: [number, number, number]; // position of the hit in the world
}

export class Picker {
  private readonly holes_ = new Holes();

  /// `x` and `y` are pixels from the upper left corner of a picture with this width and height.
  pick(
    targets: readonly PickTarget[],
    camera: three.PerspectiveCamera,
    [x, y]: [number, number],
    [width, height]: [number, number],
  ): Picked | null {
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

/// Returns the ray from the camera through a point of its picture, with coordinates from -1 to 1. Shares of it are
/// distances along the view.
function ray_through(camera: three.PerspectiveCamera, x: number, y: number): Ray {
  camera.updateMatrixWorld();
  const from = new three.Vector3().setFromMatrixPosition(camera.matrixWorld);
  const along = new three.Vector3(x, y, 0.5).unproject(camera).sub(from);
  along.divideScalar(along.dot(camera.getWorldDirection(new three.Vector3())));
  return { from: from.toArray(), along: along.toArray(), nearest: camera.near, farthest: camera.far };
}
