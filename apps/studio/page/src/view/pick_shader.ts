// SPDX-License-Identifier: Apache-2.0
// Numbers in place of colours: four bytes, the lowest first.
import { kInstanceShader } from './instances.ts';

export const kPickVertex = /* glsl */ `
${kInstanceShader}
flat out int v_instance;
#ifdef MASKED
varying vec2 v_uv;
#endif
void main() {
  v_instance = instance();
#ifdef MASKED
  v_uv = uv;
#endif
  gl_Position = projected(placed(position));
}
`;

export const kPickFragment = /* glsl */ `
uniform int number;
flat in int v_instance;
#ifdef MASKED
uniform sampler2D picture;
varying vec2 v_uv;
#endif
void main() {
#ifdef MASKED
  if (textureLod(picture, v_uv, 0.0).a < 0.5) discard;
#endif
  // -1 asks for the depth.
  int said = number > 0 ? number : number < 0 ? int(gl_FragCoord.z * 16777215.0) : v_instance + 1;
  gl_FragColor = vec4(ivec4(said, said >> 8, said >> 16, said >> 24) & 255) / 255.0;
}
`;

/// One instance once more, over itself.
export const kMarkVertex = /* glsl */ `
${kInstanceShader}
#ifdef MASKED
varying vec2 v_uv;
#endif
void main() {
#ifdef MASKED
  v_uv = uv;
#endif
  gl_Position = projected(placed(position));
  gl_Position.z -= 1e-4 * gl_Position.w; // before what it lies on
}
`;

export const kMarkFragment = /* glsl */ `
uniform vec3 colour;
#ifdef MASKED
uniform sampler2D picture;
varying vec2 v_uv;
#endif
void main() {
#ifdef MASKED
  if (texture2D(picture, v_uv).a < 0.5) discard;
#endif
  gl_FragColor = vec4(colour, 0.6);
}
`;
