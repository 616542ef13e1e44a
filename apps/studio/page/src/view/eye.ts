// SPDX-License-Identifier: Apache-2.0
// Converts positions of the world into pixels of the canvas, and pixels into lines of sight.
import * as three from 'three';

import type { Ray, Vec } from '../values/space_math.ts';
import type { Orbit } from './orbit.ts';

export class Eye {
  constructor(
    private readonly orbit_: Orbit,
    private readonly canvas_: HTMLCanvasElement,
  ) {}

  /// Returns the pixel of a point of the world, or null if it is behind the camera.
  project([x, y, z]: Vec): [number, number] | null {
    const { camera } = this.orbit_;
    const point = new three.Vector4(x, y, z, 1)
      .applyMatrix4(camera.matrixWorldInverse)
      .applyMatrix4(camera.projectionMatrix);
    if (point.w <= 0) return null;
    return [
      ((point.x / point.w + 1) / 2) * this.canvas_.clientWidth,
      ((1 - point.y / point.w) / 2) * this.canvas_.clientHeight,
    ];
  }

  /// Returns true if a point of the world is within the canvas.
  sees(place: Vec): boolean {
    const at = this.project(place);
    return (
      at !== null && at[0] >= 0 && at[1] >= 0 && at[0] <= this.canvas_.clientWidth && at[1] <= this.canvas_.clientHeight
    );
  }

  /// Returns the line of sight through a pixel of the canvas.
  ray_at(x: number, y: number): Ray {
    const { camera } = this.orbit_;
    const [across, up] = [
      (2 * x) / Math.max(1, this.canvas_.clientWidth) - 1,
      1 - (2 * y) / Math.max(1, this.canvas_.clientHeight),
    ];
    const way = new three.Vector3(across, up, 0.5).unproject(camera).sub(camera.position).normalize();
    return { origin: camera.position.toArray(), way: way.toArray() };
  }

  /// Unit vectors of the world: to the right of the screen, and toward the camera.
  get sides(): { right: Vec; toward: Vec } {
    const [right, up, toward] = [new three.Vector3(), new three.Vector3(), new three.Vector3()];
    this.orbit_.camera.matrixWorld.extractBasis(right, up, toward);
    return { right: right.toArray(), toward: toward.toArray() };
  }

  /// At the point that the camera looks at.
  get metres_per_pixel(): number {
    return this.orbit_.height_at_target / Math.max(1, this.canvas_.clientHeight);
  }
}
