// SPDX-License-Identifier: Apache-2.0
// Finds the first hit of a ray among the instances of a mesh. Spheres around the instances exclude most of them, and
// the triangles of the others are tested one by one. Numbers stay in arrays, since a plant has hundreds of thousands of
// instances.

/// The data of a mesh that rays need.
export class Solid {
  private sphere_: readonly [number, number, number, number] | null = null;

  constructor(
    readonly positions: Float32Array, // x, y, z per vertex
    readonly corners: ArrayLike<number>, // three vertices per triangle
    readonly uv: ((vertex: number) => readonly [number, number]) | null, // texture coordinates of a vertex
  ) {}

  /// A sphere around all vertices, about the middle of their box: x, y, z and radius.
  get sphere(): readonly [number, number, number, number] {
    this.sphere_ ??= sphere_around(this.positions);
    return this.sphere_;
  }
}

/// A ray from `from` through `from + along`.
export interface Ray {
  from: readonly [number, number, number];
  along: readonly [number, number, number];
  nearest: number; // range of shares of `along` in which hits count
  farthest: number;
}

/// Returns true if a picture has a hole at a position.
export type IsHole = (u: number, v: number) => boolean;

export interface Hit {
  instance: number;
  share: number; // share of the ray's `along`
}

/// Returns the first of `count` instances that the ray hits; each has three rows of four numbers in `frames`. Positions
/// for which `is_hole` is true are not hit.
export function first_hit(
  solid: Solid,
  frames: Float32Array,
  count: number,
  ray: Ray,
  is_hole: IsHole | null,
): Hit | null {
  const [cx, cy, cz, radius] = solid.sphere;
  const [ox, oy, oz] = ray.from;
  const [dx, dy, dz] = ray.along;
  const length = dx * dx + dy * dy + dz * dz;
  let best: Hit | null = null;
  for (let k = 0; k < count; k += 1) {
    const at = 12 * k;
    const a = frames[at] ?? 0;
    const b = frames[at + 1] ?? 0;
    const c = frames[at + 2] ?? 0;
    const d = frames[at + 4] ?? 0;
    const e = frames[at + 5] ?? 0;
    const f = frames[at + 6] ?? 0;
    const g = frames[at + 8] ?? 0;
    const h = frames[at + 9] ?? 0;
    const i = frames[at + 10] ?? 0;
    const x = a * cx + b * cy + c * cz + (frames[at + 3] ?? 0) - ox;
    const y = d * cx + e * cy + f * cz + (frames[at + 7] ?? 0) - oy;
    const z = g * cx + h * cy + i * cz + (frames[at + 11] ?? 0) - oz;
    // A matrix stretches by at most the root of the sum of its squares.
    const stretch = a * a + b * b + c * c + d * d + e * e + f * f + g * g + h * h + i * i;
    const reach = radius * radius * stretch;
    const on = (x * dx + y * dy + z * dz) / length;
    if (x * x + y * y + z * z - on * on * length > reach) continue;
    const until: number = best ? best.share : ray.farthest;
    const local = seen_from(frames.subarray(at, at + 12), ray);
    const share = local && first_triangle(solid, local, ray.nearest, until, is_hole);
    if (share !== null) best = { instance: k, share };
  }
  return best;
}

function sphere_around(positions: Float32Array): readonly [number, number, number, number] {
  const box = [Infinity, Infinity, Infinity, -Infinity, -Infinity, -Infinity] as [
    number,
    number,
    number,
    number,
    number,
    number,
  ];
  const at = (k: number): [number, number, number] => [positions[k] ?? 0, positions[k + 1] ?? 0, positions[k + 2] ?? 0];
  for (let k = 0; k + 2 < positions.length; k += 3) {
    const [x, y, z] = at(k);
    box[0] = Math.min(box[0], x);
    box[1] = Math.min(box[1], y);
    box[2] = Math.min(box[2], z);
    box[3] = Math.max(box[3], x);
    box[4] = Math.max(box[4], y);
    box[5] = Math.max(box[5], z);
  }
  const centre = [(box[0] + box[3]) / 2, (box[1] + box[4]) / 2, (box[2] + box[5]) / 2] as const;
  let max = 0;
  for (let k = 0; k + 2 < positions.length; k += 3) {
    const [x, y, z] = at(k);
    max = Math.max(max, (x - centre[0]) ** 2 + (y - centre[1]) ** 2 + (z - centre[2]) ** 2);
  }
  return [...centre, Math.sqrt(max)];
}

/// Three rows of a matrix, with four numbers each.
type Rows = [number, number, number, number, number, number, number, number, number, number, number, number];

type Six = [number, number, number, number, number, number];

/// Returns the ray's origin and direction in the frame of the mesh, or null if its instance is flat.
function seen_from(frame: Float32Array, { from, along }: Ray): Six | null {
  const [a, b, c, tx, d, e, f, ty, g, h, i, tz] = [...frame] as Rows;
  const [A, B, C] = [e * i - f * h, f * g - d * i, d * h - e * g];
  const [D, E, F] = [c * h - b * i, a * i - c * g, b * g - a * h];
  const [G, H, I] = [b * f - c * e, c * d - a * f, a * e - b * d];
  const determinant = a * A + b * B + c * C;
  if (determinant === 0) return null;
  const back = (x: number, y: number, z: number): [number, number, number] => [
    (A * x + D * y + G * z) / determinant,
    (B * x + E * y + H * z) / determinant,
    (C * x + F * y + I * z) / determinant,
  ];
  return [...back(from[0] - tx, from[1] - ty, from[2] - tz), ...back(along[0], along[1], along[2])];
}

/// Returns the share of the ray at the first triangle that it hits between two shares, from either side.
function first_triangle(
  { positions, corners, uv }: Solid,
  [ox, oy, oz, dx, dy, dz]: Six,
  nearest: number,
  farthest: number,
  is_hole: IsHole | null,
): number | null {
  let best: number | null = null;
  for (let k = 0; k + 2 < corners.length; k += 3) {
    const [i, j, l] = [corners[k] ?? 0, corners[k + 1] ?? 0, corners[k + 2] ?? 0];
    const ax = positions[3 * i] ?? 0;
    const ay = positions[3 * i + 1] ?? 0;
    const az = positions[3 * i + 2] ?? 0;
    const bx = (positions[3 * j] ?? 0) - ax;
    const by = (positions[3 * j + 1] ?? 0) - ay;
    const bz = (positions[3 * j + 2] ?? 0) - az;
    const cx = (positions[3 * l] ?? 0) - ax;
    const cy = (positions[3 * l + 1] ?? 0) - ay;
    const cz = (positions[3 * l + 2] ?? 0) - az;
    const nx = dy * cz - dz * cy;
    const ny = dz * cx - dx * cz;
    const nz = dx * cy - dy * cx;
    const determinant = bx * nx + by * ny + bz * nz;
    if (determinant === 0) continue;
    const sx = ox - ax;
    const sy = oy - ay;
    const sz = oz - az;
    const s = (sx * nx + sy * ny + sz * nz) / determinant;
    if (s < 0 || s > 1) continue;
    const qx = sy * bz - sz * by;
    const qy = sz * bx - sx * bz;
    const qz = sx * by - sy * bx;
    const t = (dx * qx + dy * qy + dz * qz) / determinant;
    if (t < 0 || s + t > 1) continue;
    const share = (cx * qx + cy * qy + cz * qz) / determinant;
    if (share < nearest || share > (best ?? farthest)) continue;
    if (is_hole && uv) {
      const [[u0, v0], [u1, v1], [u2, v2]] = [uv(i), uv(j), uv(l)];
      if (is_hole(u0 + s * (u1 - u0) + t * (u2 - u0), v0 + s * (v1 - v0) + t * (v2 - v0))) continue;
    }
    best = share;
  }
  return best;
}
