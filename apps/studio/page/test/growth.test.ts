// SPDX-License-Identifier: Apache-2.0
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { unpacked, view_layer } from '../src/growth/layers.ts';
import { arrow_lines } from '../src/view/overlays.ts';

const base64 = (bytes: Uint8Array): string => Buffer.from(bytes).toString('base64');
const floats = (...numbers: number[]): string => base64(new Uint8Array(new Float32Array(numbers).buffer));
const nothing = { positions: '', colours: '' };

test('places come from base 64 as they were', () => {
  const { positions, colours } = unpacked({ positions: floats(1, -2.5, 3), colours: base64(new Uint8Array([10, 20, 30, 255])) });
  assert.deepEqual([...positions], [1, -2.5, 3]);
  assert.deepEqual([...colours], [10, 20, 30, 255]);
});

test('arrows have an end each and the colour of their beginning', () => {
  const arrows = { positions: floats(0, 0, 0, 0, 1, 0), colours: base64(new Uint8Array([1, 2, 3, 255, 4, 5, 6, 255])) };
  const layer = view_layer({ part: 'ways', points: nothing, lines: nothing, arrows, labels: [], legend: [] });
  assert.deepEqual(layer.arrows, [{ from: [0, 0, 0], to: [0, 1, 0], colour: [1, 2, 3] }]);
  assert.equal(layer.points?.positions.length, 0);
});

test('an arrow is a shaft and four strokes that end at its tip', () => {
  const lines = arrow_lines([0, 0, 0], [2, 0, 0]);
  assert.equal(lines.length, 5);
  assert.deepEqual(lines[0], [[0, 0, 0], [2, 0, 0]]);
  for (const [begin, end] of lines.slice(1)) {
    assert.deepEqual(begin, [2, 0, 0]);
    assert.ok(end[0] < 2 && end[0] > 1.5);
  }
  assert.deepEqual(arrow_lines([1, 1, 1], [1, 1, 1]), []);
});
