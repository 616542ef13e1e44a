// SPDX-License-Identifier: Apache-2.0
// The light on the plant: a sun behind the camera's left shoulder, or the document's sun.
import * as three from 'three';

import type { Light } from './materials.ts';

export class Sunlight {
  is_sunlit = false; // true: lit by the document's sun if it is above the horizon
  readonly light: Light = {
    sun: { value: new three.Vector3(0.5, 0.75, 0.42).normalize() },
    sun_colour: { value: new three.Color(1.35, 1.27, 1.1) },
    sky_colour: { value: new three.Color(0.62, 0.7, 0.8) },
    ground_colour: { value: new three.Color(0.3, 0.29, 0.24) },
    crown_centre: { value: new three.Vector3() },
    crown_size: { value: new three.Vector3(1, 1, 1) },
  };

  /// `azimuth` is the azimuth of the camera, degrees.
  place(azimuth: number, sun: readonly [number, number, number] | undefined): void {
    if (this.is_sunlit && sun && sun[1] > 0) {
      this.light.sun.value.set(...sun);
      return;
    }
    // The sun follows the camera, so that no visible side of a plant is dark.
    const behind = (azimuth - 50) * (Math.PI / 180);
    this.light.sun.value.set(0.66 * Math.sin(behind), 0.75, -0.66 * Math.cos(behind)).normalize();
  }

  /// Adapts the darker inside of crowns to the plants.
  suit(box: three.Box3): void {
    box.getCenter(this.light.crown_centre.value);
    box.getSize(this.light.crown_size.value).multiplyScalar(0.5).addScalar(1e-6);
  }
}
