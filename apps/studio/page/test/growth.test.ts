// SPDX-License-Identifier: Apache-2.0
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { view_layer } from '../src/growth/layers.ts';
import type { ArrayPlace, PacketArrays } from '../src/server/packet.ts';
import { floats, is_answer, read_packed, read_packet } from '../src/server/packet.ts';
import { arrow_lines } from '../src/view/overlays.ts';

/// Arrays one after another, and their places.
function packed(...numbers: (Float32Array | Uint8Array)[]): { arrays: PacketArrays; places: ArrayPlace[] } {
  const places: ArrayPlace[] = [];
  let size = 0;
  for (const one of numbers) {
    places.push([size, one.length]);
    size += 4 * Math.ceil(one.byteLength / 4);
  }
  const first = 12;
  const buffer = new ArrayBuffer(first + size);
  for (const [k, one] of numbers.entries())
    new Uint8Array(buffer).set(new Uint8Array(one.buffer), first + (places[k]?.[0] ?? 0));
  return { arrays: { buffer, first }, places };
}

const kNone: ArrayPlace = [0, 0];
const nothing = { positions: kNone, colours: kNone };

test('an answer comes as a packet of its own kind, and is no scene', () => {
  const head = new TextEncoder().encode(JSON.stringify({ is: 'done', re: 7 }).padEnd(24));
  const buffer = new ArrayBuffer(8 + head.length + 4);
  new Uint8Array(buffer).set(new TextEncoder().encode('MSA1'));
  new DataView(buffer).setUint32(4, head.length, true);
  new Uint8Array(buffer).set(head, 8);
  new Float32Array(buffer, 8 + head.length)[0] = 2.5;
  assert.ok(is_answer(buffer));
  assert.throws(() => read_packet(buffer), /no scene packet/);
  const answer = read_packed<{ re: number }>(buffer);
  assert.equal(answer.head.re, 7);
  assert.deepEqual([...floats(answer, [0, 1])], [2.5]);
  assert.ok(!is_answer(new ArrayBuffer(3)));
});

test('places come from the arrays as they were', () => {
  const { arrays, places } = packed(new Float32Array([1, -2.5, 3]), new Uint8Array([10, 20, 30, 255]));
  const points = { positions: places[0] ?? kNone, colours: places[1] ?? kNone };
  const layer = view_layer({ part: 'points', points, lines: nothing, arrows: nothing, labels: [], legend: [] }, arrays);
  assert.deepEqual([...(layer.points?.positions ?? [])], [1, -2.5, 3]);
  assert.deepEqual([...(layer.points?.colours ?? [])], [10, 20, 30, 255]);
  assert.equal(layer.points?.positions.buffer, arrays.buffer, 'they are not copied');
});

test('arrows have an end each and the colour of their beginning', () => {
  const { arrays, places } = packed(new Float32Array([0, 0, 0, 0, 1, 0]), new Uint8Array([1, 2, 3, 255, 4, 5, 6, 255]));
  const arrow = { positions: places[0] ?? kNone, colours: places[1] ?? kNone };
  const layer = view_layer(
    { part: 'ways', points: nothing, lines: nothing, arrows: arrow, labels: [], legend: [] },
    arrays,
  );
  assert.deepEqual(layer.arrows, [{ from: [0, 0, 0], to: [0, 1, 0], colour: [1, 2, 3] }]);
  assert.equal(layer.points?.positions.length, 0);
});

test('an arrow is a shaft and four strokes that end at its tip', () => {
  const lines = arrow_lines([0, 0, 0], [2, 0, 0]);
  assert.equal(lines.length, 5);
  assert.deepEqual(lines[0], [
    [0, 0, 0],
    [2, 0, 0],
  ]);
  for (const [begin, end] of lines.slice(1)) {
    assert.deepEqual(begin, [2, 0, 0]);
    assert.ok(end[0] < 2 && end[0] > 1.5);
  }
  assert.deepEqual(arrow_lines([1, 1, 1], [1, 1, 1]), []);
});
