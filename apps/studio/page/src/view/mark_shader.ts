// SPDX-License-Identifier: Apache-2.0
// The shader that draws one instance once more over itself.
import { kInstanceShader } from './instances.ts';

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
