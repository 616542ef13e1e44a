// SPDX-License-Identifier: Apache-2.0
// What is drawn at a pixel: which batch, and which of its instances. The scene is drawn once more into a target of one
// pixel, with numbers in place of colours: first of the batches, then of the instances of the one that was hit, then its
// depth. Leaves
// are not there where their picture has holes.
import * as three from 'three';

import type { Batch } from './buffers.ts';
import { place, placing_uniforms } from './instances.ts';
import { kPickFragment, kPickVertex } from './pick_shader.ts';

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
  private readonly pixel_ = new three.WebGLRenderTarget(1, 1, { format: three.RGBAFormat, type: three.UnsignedByteType, depthBuffer: true, generateMipmaps: false });
  private readonly scene_ = new three.Scene();
  private readonly camera_ = new three.PerspectiveCamera();
  private readonly plain_ = pick_material(false);
  private readonly masked_ = pick_material(true);

  constructor(private readonly renderer_: three.WebGLRenderer) {
    this.scene_.matrixWorldAutoUpdate = false;
  }

  /// `x` and `y` are pixels of a picture of this width and height, from its upper left corner.
  pick(targets: readonly PickTarget[], camera: three.PerspectiveCamera, [x, y]: [number, number], [width, height]: [number, number]): Picked | null {
    this.camera_.copy(camera);
    this.camera_.setViewOffset(width, height, x, y, 1, 1);
    const target = this.draw(targets.map((one, index) => this.mesh(one, index + 1))) - 1;
    const hit = targets[target];
    if (!hit) return null;
    // Numbers of instances count from 1 too, since 0 is what nothing is drawn over.
    const instance = Math.max(0, this.draw([this.mesh(hit, 0)]) - 1);
    const depth = this.draw([this.mesh(hit, -1)]) / 16777215;
    const at = new three.Vector3(0, 0, 2 * depth - 1).unproject(this.camera_);
    return { target, instance, position: [at.x, at.y, at.z] };
  }

  /// The number that is drawn at the pixel; 0: none.
  private draw(meshes: three.Mesh[]): number {
    this.scene_.add(...meshes);
    this.renderer_.setRenderTarget(this.pixel_);
    this.renderer_.render(this.scene_, this.camera_);
    const bytes = new Uint8Array(4);
    this.renderer_.readRenderTargetPixels(this.pixel_, 0, 0, 1, 1, bytes);
    this.renderer_.setRenderTarget(null);
    this.scene_.clear();
    const [a = 0, b = 0, c = 0, d = 0] = bytes;
    return a + 256 * (b + 256 * (c + 256 * d));
  }

  /// `number` stands for the whole batch; 0: each instance has its own; -1: the depth.
  private mesh({ batch, picture }: PickTarget, number: number): three.Mesh {
    const mesh = new three.Mesh(batch.geometry, picture ? this.masked_ : this.plain_);
    place(mesh, batch, (uniforms) => {
      Object.assign(uniforms['number'] ?? {}, { value: number });
      Object.assign(uniforms['picture'] ?? {}, { value: picture });
    });
    return mesh;
  }
}

function pick_material(is_masked: boolean): three.ShaderMaterial {
  return new three.ShaderMaterial({
    vertexShader: kPickVertex,
    fragmentShader: kPickFragment,
    defines: is_masked ? { MASKED: '' } : {},
    side: three.DoubleSide,
    blending: three.NoBlending,
    uniforms: { ...placing_uniforms(), number: { value: 0 }, picture: { value: null } },
  });
}
