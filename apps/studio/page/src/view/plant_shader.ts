// SPDX-License-Identifier: Apache-2.0
// The shader of plants: sky and ground as a hemisphere, one sun, light through leaves, holes by alpha. Frames of
// instances are three rows of a 3x4 matrix. They may be skewed or mirrored, so normals use cofactors.

import { kInstanceShader } from './instances.ts';

export const kPlantVertex = /* glsl */ `
${kInstanceShader}
#ifdef HAS_NORMALS
attribute vec4 tangent;
varying vec4 v_tangent;
#endif
uniform vec3 tint_scale;
varying vec3 v_normal;
varying vec3 v_position;
varying vec3 v_tint;
#ifdef HAS_PICTURE
varying vec2 v_uv;
#endif

void main() {
  vec4 frame_0 = frame_row(0);
  vec4 frame_1 = frame_row(1);
  vec4 frame_2 = frame_row(2);
  vec4 local = vec4(position, 1.0);
  vec3 place = vec3(dot(frame_0, local), dot(frame_1, local), dot(frame_2, local));
  vec3 a = cross(frame_1.xyz, frame_2.xyz);
  vec3 b = cross(frame_2.xyz, frame_0.xyz);
  vec3 c = cross(frame_0.xyz, frame_1.xyz);
  float side = dot(frame_0.xyz, a) < 0.0 ? -1.0 : 1.0;
  v_normal = side * vec3(dot(a, normal), dot(b, normal), dot(c, normal));
  v_position = place;
  v_tint = tint() * tint_scale;
#ifdef HAS_PICTURE
  v_uv = uv;
#endif
#ifdef HAS_NORMALS
  v_tangent = vec4(dot(frame_0.xyz, tangent.xyz), dot(frame_1.xyz, tangent.xyz), dot(frame_2.xyz, tangent.xyz), tangent.w * side);
#endif
  gl_Position = projected(place);
}
`;

export const kPlantFragment = /* glsl */ `
uniform vec3 colour;
uniform vec3 sun;
uniform vec3 sun_colour;
uniform vec3 sky_colour;
uniform vec3 ground_colour;
uniform float translucency;
uniform float opacity;
uniform float gloss;
uniform float emphasis;
uniform vec3 crown_centre;
uniform vec3 crown_size;
varying vec3 v_normal;
varying vec3 v_position;
varying vec3 v_tint;
#ifdef HAS_PICTURE
uniform sampler2D picture;
uniform vec2 picture_size;
varying vec2 v_uv;
#endif
#ifdef HAS_NORMALS
uniform sampler2D normals;
varying vec4 v_tangent;
#endif

void main() {
  vec3 albedo = colour * v_tint;
#ifdef HAS_PICTURE
  vec4 texel = texture2D(picture, v_uv);
#ifdef MASKED
  // Far away a picture's mean alpha sinks below the threshold and leaves would thin out: raise it with the level.
  vec2 dx = dFdx(v_uv * picture_size);
  vec2 dy = dFdy(v_uv * picture_size);
  float level = max(0.0, 0.5 * log2(max(dot(dx, dx), dot(dy, dy))));
  if (texel.a * (1.0 + 0.25 * level) < 0.5) discard;
#endif
  albedo *= texel.rgb;
#endif
  vec3 to_eye = normalize(cameraPosition - v_position);
  vec3 n = normalize(v_normal);
#ifdef HAS_NORMALS
  vec3 t = normalize(v_tangent.xyz);
  vec3 bent = texture2D(normals, v_uv).xyz * 2.0 - 1.0;
  n = normalize(bent.x * t + bent.y * v_tangent.w * cross(n, t) + bent.z * n);
#endif
#ifdef TWO_SIDED
  if (dot(n, to_eye) < 0.0) n = -n;
#endif
  float facing = dot(n, sun);
  float lit = max(0.0, (facing + 0.15) / 1.15);
  vec3 light = mix(ground_colour, sky_colour, 0.5 + 0.5 * n.y) + sun_colour * lit;
  // Deep inside the plant less of the sky is seen.
  light *= mix(0.5, 1.0, smoothstep(0.1, 0.95, length((v_position - crown_centre) / crown_size)));
  // Light from behind comes through warmer than it is thrown back.
  vec3 through = sun_colour * translucency * max(0.0, -facing) * vec3(1.1, 1.2, 0.6);
  vec3 shine = sun_colour * gloss * pow(max(0.0, dot(n, normalize(sun + to_eye))), 24.0);
  vec3 seen = albedo * (light + through) + shine;
  seen = mix(seen, vec3(0.16, 0.62, 0.36), 0.22 * emphasis * (1.0 - 0.6 * abs(dot(n, to_eye))));
  // A soft shoulder, so that petals in the sun keep their colour.
  seen = seen / (1.0 + 0.18 * seen);
  gl_FragColor = vec4(seen, opacity);
  #include <colorspace_fragment>
}
`;

export const kWireVertex = /* glsl */ `
${kInstanceShader}
void main() { gl_Position = projected(placed(position)); }
`;

export const kWireFragment = /* glsl */ `
uniform vec3 line;
void main() { gl_FragColor = vec4(line, 0.4); }
`;

export const kLineVertex = /* glsl */ `
attribute float order;
varying float v_order;
void main() {
  v_order = order;
  gl_Position = projectionMatrix * viewMatrix * vec4(position, 1.0);
}
`;

// Colours by order, from the trunk outward: brown, ochre, green, teal, blue, violet.
export const kLineFragment = /* glsl */ `
varying float v_order;
void main() {
  float k = floor(v_order + 0.5);
  vec3 shade = k < 0.5 ? vec3(0.55, 0.36, 0.20) : k < 1.5 ? vec3(0.80, 0.55, 0.16) : k < 2.5 ? vec3(0.28, 0.60, 0.24)
    : k < 3.5 ? vec3(0.10, 0.58, 0.56) : k < 4.5 ? vec3(0.20, 0.44, 0.78) : vec3(0.52, 0.36, 0.74);
  gl_FragColor = vec4(shade, 1.0);
}
`;

export const kGroundVertex = /* glsl */ `
varying vec2 v_place;
uniform float reach;
void main() {
  v_place = position.xz * reach;
  gl_Position = projectionMatrix * viewMatrix * vec4(v_place.x, 0.0, v_place.y, 1.0);
}
`;

// A grid that fades toward the rim and where its lines get too dense, and a soft shadow below the plant.
export const kGroundFragment = /* glsl */ `
varying vec2 v_place;
uniform float reach;
uniform float spacing;
uniform float shade_radius;
uniform vec2 shade_centre;
uniform vec3 ground;
uniform vec3 line;
float grid(float step_size) {
  vec2 at = v_place / step_size;
  vec2 width = fwidth(at);
  vec2 near = abs(fract(at - 0.5) - 0.5) / max(width, vec2(1e-6));
  float crowd = clamp(1.0 - 1.6 * max(width.x, width.y), 0.0, 1.0);
  return clamp(1.0 - min(near.x, near.y), 0.0, 1.0) * crowd;
}
void main() {
  float away = length(v_place) / reach;
  float fade = 1.0 - smoothstep(0.25, 1.0, away);
  float lines = max(0.35 * grid(spacing), 0.8 * grid(spacing * 10.0));
  float shade = 0.34 * (1.0 - smoothstep(0.0, 1.0, length(v_place - shade_centre) / shade_radius));
  vec3 colour = mix(mix(ground, line, lines), vec3(0.0), shade);
  gl_FragColor = vec4(colour, fade * max(0.55, max(lines, shade)));
}
`;
