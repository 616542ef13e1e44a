// SPDX-License-Identifier: Apache-2.0
// The ground: a disc with a grid that fades, and a soft shadow below the plant.
import * as three from 'three';

import { kGroundFragment, kGroundVertex } from './plant_shader.ts';

export class Ground {
  readonly mesh: three.Mesh;
  private readonly uniforms_ = {
    reach: { value: 20 },
    spacing: { value: 1 },
    shade_radius: { value: 1 },
    shade_centre: { value: new three.Vector2() },
    ground: { value: new three.Color() },
    line: { value: new three.Color() },
  };

  constructor() {
    const disc = new three.CircleGeometry(1, 64).rotateX(-Math.PI / 2);
    const material = new three.ShaderMaterial({
      vertexShader: kGroundVertex,
      fragmentShader: kGroundFragment,
      uniforms: this.uniforms_,
      transparent: true,
      depthWrite: false,
      side: three.DoubleSide,
    });
    this.mesh = new three.Mesh(disc, material);
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = -1;
  }

  /// Adapts the size of the ground to the plants.
  suit(box: three.Box3): void {
    const size = box.getSize(new three.Vector3());
    const wide = Math.max(size.x, size.z, 0.3 * size.y, 0.02);
    this.uniforms_.reach.value = 5 * Math.max(wide, 0.7 * size.y);
    this.uniforms_.spacing.value = 10 ** Math.floor(Math.log10(wide / 1.5));
    this.uniforms_.shade_radius.value = 0.62 * Math.max(size.x, size.z, 0.05 * size.y);
    this.uniforms_.shade_centre.value.set((box.min.x + box.max.x) / 2, (box.min.z + box.max.z) / 2);
  }

  paint(is_dark: boolean): void {
    this.uniforms_.ground.value.set(is_dark ? 0x191d1b : 0xdfe4da).convertLinearToSRGB();
    this.uniforms_.line.value.set(is_dark ? 0x4a544e : 0xa3ada0).convertLinearToSRGB();
  }
}
