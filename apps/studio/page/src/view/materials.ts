// SPDX-License-Identifier: Apache-2.0
// Materials by their index, and pictures by their keys. Pictures are decoded once, in parallel with the drawing.
import * as three from 'three';

import type { Packet, PacketMaterial, PacketPicture } from '../server/packet.ts';
import { bytes } from '../server/packet.ts';
import { placing_uniforms } from './instances.ts';
import { kPlantFragment, kPlantVertex, kWireFragment, kWireVertex } from './plant_shader.ts';

/// The light that all materials share.
export interface Light {
  sun: three.IUniform<three.Vector3>;
  sun_colour: three.IUniform<three.Color>;
  sky_colour: three.IUniform<three.Color>;
  ground_colour: three.IUniform<three.Color>;
  crown_centre: three.IUniform<three.Vector3>;
  crown_size: three.IUniform<three.Vector3>; // half of the box around the plant
}

interface Picture {
  texture: three.Texture;
  width: number;
  height: number;
}

export class Materials {
  readonly wire = new three.ShaderMaterial({
    vertexShader: kWireVertex,
    fragmentShader: kWireFragment,
    uniforms: { ...placing_uniforms(), line: { value: new three.Color(0.2, 0.3, 0.24) } },
    wireframe: true,
    transparent: true,
    depthWrite: false,
  });
  private readonly said_: PacketMaterial[] = [];
  private readonly made_ = new Map<string, three.ShaderMaterial>();
  private readonly pictures_ = new Map<string, Picture>();
  // Belongs to this view only
  private readonly white_ = new three.DataTexture(new Uint8Array([255, 255, 255, 255]), 1, 1);

  constructor(
    private readonly light_: Light,
    private readonly anisotropy_: number, // number of samples for pictures at a flat angle
    private readonly changed_: () => void,
  ) {
    this.white_.needsUpdate = true;
  }

  get counts(): { materials: number; pictures: number } {
    return { materials: this.said_.length, pictures: this.pictures_.size };
  }

  say(material: PacketMaterial): void {
    this.said_[material.index] = material;
    this.forget(material.index);
  }

  keep(count: number): void {
    for (let index = count; index < this.said_.length; index += 1) this.forget(index);
    this.said_.length = Math.min(this.said_.length, count);
  }

  /// Returns the material of one batch. It has the batch's tint scale, and emphasises the chosen component.
  material_for(index: number, tint_scale: three.Color, is_emphasised: boolean): three.ShaderMaterial {
    const key = `${index}/${tint_scale.getHexString()}/${tint_scale.r.toFixed(4)}/${is_emphasised}`;
    const known = this.made_.get(key);
    if (known) return known;
    const made = this.make(this.said_[index] ?? kPlain, tint_scale, is_emphasised);
    this.made_.set(key, made);
    return made;
  }

  /// Returns the picture whose holes cut a material. Returns null if it has none, or if it is not loaded yet.
  holes_of(index: number): three.Texture | null {
    const said = this.said_[index];
    const texture = said?.masked && said.picture !== undefined ? this.pictures_.get(said.picture)?.texture : undefined;
    return texture?.image ? texture : null;
  }

  add_picture(packet: Packet, picture: PacketPicture): void {
    const texture = new three.Texture();
    texture.wrapS = texture.wrapT = three.RepeatWrapping;
    texture.flipY = false; // pictures are flipped when they are decoded
    texture.anisotropy = this.anisotropy_;
    this.pictures_.set(picture.key, { texture, width: picture.width, height: picture.height });
    const blob = new Blob([bytes(packet, picture.bytes)], { type: picture.type });
    createImageBitmap(blob, { imageOrientation: 'flipY', premultiplyAlpha: 'none', colorSpaceConversion: 'none' })
      .then((image) => {
        texture.image = image;
        texture.needsUpdate = true;
        this.changed_();
      })
      .catch(() => undefined); // the plain colour stays
  }

  remove_pictures(keys: string[]): void {
    for (const key of keys) {
      this.pictures_.get(key)?.texture.dispose();
      this.pictures_.delete(key);
    }
  }

  clear(): void {
    this.keep(0);
    this.remove_pictures([...this.pictures_.keys()]);
    this.white_.dispose();
  }

  private forget(index: number): void {
    for (const [key, material] of this.made_) {
      if (!key.startsWith(`${index}/`)) continue;
      material.dispose();
      this.made_.delete(key);
    }
  }

  private make(said: PacketMaterial, tint_scale: three.Color, is_emphasised: boolean): three.ShaderMaterial {
    const picture = said.picture === undefined ? undefined : this.pictures_.get(said.picture);
    const normals = said.normals === undefined ? undefined : this.pictures_.get(said.normals);
    if (picture) picture.texture.colorSpace = three.SRGBColorSpace;
    const defines: Record<string, string> = {};
    if (said.two_sided) defines['TWO_SIDED'] = '';
    if (picture || normals) defines['HAS_PICTURE'] = '';
    if (picture && said.masked) defines['MASKED'] = '';
    if (normals) defines['HAS_NORMALS'] = '';
    return new three.ShaderMaterial({
      vertexShader: kPlantVertex,
      fragmentShader: kPlantFragment,
      defines,
      transparent: said.opacity < 1,
      depthWrite: said.opacity === 1,
      side: three.DoubleSide, // frames may be mirrored, which reverses the winding
      uniforms: {
        ...this.light_,
        ...placing_uniforms(),
        colour: { value: new three.Color(...said.colour) },
        translucency: { value: said.translucency },
        opacity: { value: said.opacity },
        gloss: { value: 0.12 * (1 - said.roughness) ** 2 },
        emphasis: { value: is_emphasised ? 1 : 0 },
        tint_scale: { value: tint_scale },
        picture: { value: picture?.texture ?? this.white_ },
        picture_size: { value: new three.Vector2(picture?.width ?? 1, picture?.height ?? 1) },
        normals: { value: normals?.texture ?? null },
      },
    });
  }
}

const kPlain: PacketMaterial = {
  index: 0,
  name: '',
  colour: [0.5, 0.5, 0.5],
  roughness: 1,
  translucency: 0,
  opacity: 1,
  two_sided: true,
  masked: false,
};
