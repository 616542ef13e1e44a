// SPDX-License-Identifier: Apache-2.0
// Positions of instances for the shaders. A mesh with few triangles is stored several times in its arrays, and one
// instance of the card draws all of these copies. Cards and processors need much time for each instance and little for
// its triangles. In software, an oak's 14,000 leaves of 12 triangles take 9 times as long one by one.
import * as three from 'three';

/// Vertices that one instance of the card draws. A mesh with more vertices is stored once.
const kVerticesAtOnce = 4096;
const kRowBits = 9;
const kRow = 1 << kRowBits; // instances per row of a texture of frames or tints

/// For vertex shaders: `instance()` is the number of the instance, `placed(local)` a point of it in the scene,
/// `projected(place)` this point in the picture, and `tint()` the instance's tint. Rows are found by shifts, because
/// processors divide whole numbers one by one.
export const kInstanceShader = /* glsl */ `
uniform highp sampler2D frames;
uniform lowp sampler2D tints;
uniform int tinted;
uniform int instances;
uniform int copies;
attribute float copy;
int instance() { return gl_InstanceID * copies + int(copy); }
vec4 frame_row(int row) { int at = instance(); return texelFetch(frames, ivec2(3 * (at & ${kRow - 1}) + row, at >> ${kRowBits}), 0); }
vec3 tint() { int at = instance() * tinted; return texelFetch(tints, ivec2(at & ${kRow - 1}, at >> ${kRowBits}), 0).rgb; }
vec3 placed(vec3 local) {
  vec4 at = vec4(local, 1.0);
  return vec3(dot(frame_row(0), at), dot(frame_row(1), at), dot(frame_row(2), at));
}
// Copies past the last instance fall together outside of the picture.
vec4 projected(vec3 place) {
  return instance() < instances ? projectionMatrix * viewMatrix * vec4(place, 1.0) : vec4(2.0, 2.0, 2.0, 1.0);
}
`;

/// The data of a batch for the shaders: the number of instances, and the number that one instance of the card draws.
export interface Placing {
  frames: three.DataTexture;
  tints: three.DataTexture;
  instances: number;
  copies: number;
}

type PlacingUniforms = { [key in keyof Placing]: three.IUniform<Placing[key] | null> } & {
  tinted: three.IUniform<number>;
};

export type PlacingMaterial = three.ShaderMaterial & { uniforms: PlacingUniforms };

/// Returns the uniforms that every material of batches has.
export function placing_uniforms(): PlacingUniforms {
  return {
    frames: { value: null },
    tints: { value: null },
    instances: { value: 0 },
    copies: { value: 1 },
    tinted: { value: 0 },
  };
}

/// Returns the number of copies of a mesh with this many vertices for this number of instances: a power of two.
export function copies_for(vertices: number, instances: number): number {
  const max = Math.min(kVerticesAtOnce / Math.max(vertices, 1), instances);
  return max <= 1 ? 1 : 2 ** Math.floor(Math.log2(max));
}

/// Sets the uniforms of a mesh from `placing` and `more` before each drawing. Materials serve many meshes, one after
/// the other.
export function place(
  mesh: three.Mesh,
  placing: Placing,
  more?: (uniforms: three.ShaderMaterial['uniforms']) => void,
): void {
  mesh.frustumCulled = false; // instances are elsewhere than their mesh
  mesh.matrixAutoUpdate = false;
  mesh.onBeforeRender = (_renderer, _scene, _camera, _geometry, material) => {
    const shader = material as PlacingMaterial;
    for (const key of ['frames', 'tints', 'instances', 'copies'] as const) shader.uniforms[key].value = placing[key];
    const { width, height } = placing.tints.image;
    shader.uniforms.tinted.value = width * height > 1 ? 1 : 0; // one tint serves all
    more?.(shader.uniforms);
    shader.uniformsNeedUpdate = true;
  };
}

/// Returns a texture of the rows of 3x4 frames. Uses the array in place if it fits one row of the texture.
export function frames_texture(frames: Float32Array, count: number): three.DataTexture {
  const [width, height] = [3 * Math.min(Math.max(count, 1), kRow), Math.max(1, Math.ceil(count / kRow))];
  let texels = frames;
  if (frames.length !== 4 * width * height) {
    texels = new Float32Array(4 * width * height);
    texels.set(frames);
  }
  return texture_of(texels, width, height, three.FloatType);
}

/// Returns a texture of one tint per instance.
export function tints_texture(tints: Uint8Array, count: number): three.DataTexture {
  const [width, height] = [Math.min(Math.max(count, 1), kRow), Math.max(1, Math.ceil(count / kRow))];
  let texels = tints;
  if (tints.length !== 4 * width * height) {
    texels = new Uint8Array(4 * width * height);
    texels.set(tints);
  }
  return texture_of(texels, width, height, three.UnsignedByteType);
}

function texture_of(
  texels: Float32Array | Uint8Array,
  width: number,
  height: number,
  type: three.TextureDataType,
): three.DataTexture {
  const texture = new three.DataTexture(texels as Float32Array<ArrayBuffer>, width, height, three.RGBAFormat, type);
  texture.needsUpdate = true;
  return texture;
}
