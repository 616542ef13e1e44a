// SPDX-License-Identifier: Apache-2.0
// The shaders of overlays. Colours are screen colours, and no light affects them.

export const kOverlayVertex = `
attribute vec4 colour;
varying vec4 v_colour;
void main() {
  v_colour = colour;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}`;

export const kOverlayFragment = `
varying vec4 v_colour;
void main() {
  gl_FragColor = v_colour;
}`;

export const kOverlayPointVertex = `
attribute vec4 colour;
varying vec4 v_colour;
uniform float size;
uniform float pixel_ratio;
void main() {
  v_colour = colour;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
  gl_PointSize = size * pixel_ratio;
}`;

// A disc with a darker rim, so that points of one colour can be distinguished.
export const kOverlayPointFragment = `
varying vec4 v_colour;
void main() {
  float r = length(gl_PointCoord - 0.5);
  if (r > 0.5) discard;
  gl_FragColor = vec4(v_colour.rgb * (r > 0.38 ? 0.6 : 1.0), v_colour.a);
}`;
