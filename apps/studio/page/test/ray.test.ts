// SPDX-License-Identifier: Apache-2.0
import assert from 'node:assert/strict';
import { test } from 'node:test';

import * as three from 'three';

import type { Ray } from '../src/view/ray.ts';
import { first_hit, Solid } from '../src/view/ray.ts';

const square = new Solid(new Float32Array([-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0]), [0, 1, 2, 0, 2, 3], (k) => [
  k === 1 || k === 2 ? 1 : 0,
  k > 1 ? 1 : 0,
]);
const at = (x: number, y: number, z: number, size = 1): number[] => [size, 0, 0, x, 0, size, 0, y, 0, 0, size, z];
const down = (x: number, y: number): Ray => ({ from: [x, y, 10], along: [0, 0, -1], nearest: 0.1, farthest: 1000 });

/// Returns numbers from 0 to 1 that are equal in every run.
function chance(): () => number {
  let state = 7;
  return () => {
    state = (state * 48271) % 2147483647;
    return state / 2147483647;
  };
}

test('the nearest instance is hit, from either side', () => {
  const frames = new Float32Array([...at(0, 0, 0), ...at(0, 0, 3), ...at(5, 0, 4), ...at(0, 0, 12)]);
  assert.deepEqual(first_hit(square, frames, 4, down(0.5, 0.5), null), { instance: 1, share: 7 });
  assert.deepEqual(first_hit(square, frames, 4, { ...down(0, 0), from: [0, 0, -10], along: [0, 0, 1] }, null), {
    instance: 0,
    share: 10,
  });
  assert.equal(first_hit(square, frames, 4, down(2, 2), null), null);
});

test('what lies before the nearest or past the farthest share is not hit', () => {
  const frames = new Float32Array(at(0, 0, 0));
  assert.equal(first_hit(square, frames, 1, { ...down(0, 0), nearest: 11 }, null), null);
  assert.equal(first_hit(square, frames, 1, { ...down(0, 0), farthest: 9 }, null), null);
});

test('holes let through to what lies behind', () => {
  const frames = new Float32Array([...at(0, 0, 1), ...at(0, 0, 0)]);
  const is_hole = (u: number, v: number): boolean => u > 0.5 && v > 0.5;
  assert.equal(first_hit(square, frames, 2, down(-0.5, 0.5), is_hole)?.instance, 0);
  assert.equal(first_hit(square, frames, 1, down(0.5, 0.5), is_hole), null);
});

test('flat instances are not there', () => {
  assert.equal(first_hit(square, new Float32Array(at(0, 0, 0, 0)), 1, down(0, 0), null), null);
});

test('turned, stretched and mirrored instances are hit where their triangles are', () => {
  const random = chance();
  const matrix = new three.Matrix4();
  let hits = 0;
  for (let k = 0; k < 2000; k += 1) {
    const turn = new three.Euler(6 * random(), 6 * random(), 6 * random());
    const sizes = new three.Vector3(0.2 + random(), -0.2 - random(), 0.2 + random());
    matrix.compose(new three.Vector3(random(), random(), random()), new three.Quaternion().setFromEuler(turn), sizes);
    const m = matrix.elements;
    const rows = [0, 1, 2].flatMap((row) => [m[row] ?? 0, m[4 + row] ?? 0, m[8 + row] ?? 0, m[12 + row] ?? 0]);
    const ray = down(2 * random() - 0.5, 2 * random() - 0.5);
    const corner = (vertex: number): three.Vector3 =>
      new three.Vector3().fromArray(square.positions, 3 * vertex).applyMatrix4(matrix);
    const line = new three.Ray(new three.Vector3(...ray.from), new three.Vector3(...ray.along));
    const met = [
      [0, 1, 2],
      [0, 2, 3],
    ]
      .map(([a = 0, b = 0, c = 0]) =>
        line.intersectTriangle(corner(a), corner(b), corner(c), false, new three.Vector3()),
      )
      .find(Boolean);
    const found = first_hit(square, new Float32Array(rows), 1, ray, null);
    assert.equal(Boolean(found), Boolean(met));
    if (!found || !met) continue;
    hits += 1;
    assert.ok(Math.abs(10 - found.share - met.z) < 1e-4);
  }
  assert.ok(hits > 300);
});
