// SPDX-License-Identifier: Apache-2.0
// The mark of one instance, which is drawn once more over itself.
import * as three from 'three';

import type { Batch, Buffers } from './buffers.ts';
import { place, placing_uniforms } from './instances.ts';
import { kMarkFragment, kMarkVertex } from './mark_shader.ts';

const kKey = 'mark';
const kColour = new three.Color(1, 0.55, 0.1);

export class Mark {
  private mesh_: three.Mesh<three.BufferGeometry, three.ShaderMaterial> | null = null;
  private of_: Batch | null = null;

  constructor(
    private readonly root_: three.Object3D,
    private readonly buffers_: Buffers,
  ) {}

  /// The batch of the marked instance.
  get of(): Batch | null {
    return this.of_;
  }

  put(batch: Batch, instance: number, picture: three.Texture | null): void {
    this.clear();
    this.buffers_.add_single(kKey, batch.instances_of, instance);
    const single = this.buffers_.add_batch(kKey, batch.mesh, kKey);
    const material = new three.ShaderMaterial({
      vertexShader: kMarkVertex,
      fragmentShader: kMarkFragment,
      defines: picture ? { MASKED: '' } : {},
      side: three.DoubleSide,
      transparent: true,
      depthWrite: false,
      uniforms: { ...placing_uniforms(), colour: { value: kColour }, picture: { value: picture } },
    });
    const mesh = new three.Mesh(single.geometry, material);
    place(mesh, single);
    this.root_.add(mesh);
    [this.mesh_, this.of_] = [mesh, batch];
  }

  clear(): void {
    if (!this.mesh_) return;
    this.root_.remove(this.mesh_);
    this.mesh_.material.dispose();
    this.buffers_.remove_batch(kKey);
    this.buffers_.remove([], [kKey]);
    [this.mesh_, this.of_] = [null, null];
  }
}
