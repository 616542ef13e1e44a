// SPDX-License-Identifier: Apache-2.0
// Editors keep what hands move within the ranges of the rows.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { drawn_limits, limits_of, with_legal_point, with_limits } from '../src/editors/limits.ts';
import { entry_of } from '../src/editors/selection_text.ts';
import type { Shape } from '../src/editors/shape.ts';
import { frame_of, with_point } from '../src/editors/shape.ts';
import { kSides, limits_from } from '../src/editors/space.ts';
import { bound_group } from '../src/gizmo/bound_group.ts';
import { groups_of_object } from '../src/gizmo/row_groups.ts';
import { legal_value, legal_values } from '../src/tables/legal.ts';
import type { Row, Tables } from '../src/tables/tables.ts';
import { kWorld } from '../src/values/space_math.ts';

const row = (part: Partial<Row>): Row => ({ name: 'size', kind: 'number', doc: '', ...part });
/// Half widths from 0 to 1 over places along the blade, as of the polygon of a leaf.
const kPolygon = row({
  kind: 'points',
  min: 0,
  max: 1,
  second: { min: -2, max: 2, usual: [0, 1] },
  together: 'silhouette',
});

test('points: each of their two numbers has its own limits', () => {
  const limits = limits_of(kPolygon, 'silhouette');
  assert.deepEqual(limits, { x: { low: 0, high: 1 }, y: { low: -2, high: 2 } });
  const shape: Shape = {
    points: [
      [0, 0],
      [1.445, 2.5],
      [0, 1],
    ],
    joining: 'linear',
    form: 'silhouette',
  };
  assert.deepEqual(with_legal_point(shape, 1, limits).points[1], [1, 2]);
  // Both sides of the leaf are shown, and so is the limit of each.
  assert.deepEqual(drawn_limits(limits, shape).x, { low: -1, high: 1 });
  const frame = with_limits(
    frame_of({
      ...shape,
      points: [
        [0, 0],
        [0.9, 0.5],
        [0, 1],
      ],
    }),
    drawn_limits(limits, shape),
    shape.form,
  );
  assert.ok(frame.x.low < -1 && frame.x.high > 1, 'the limits are in sight');
  assert.deepEqual(limits_of(row({ kind: 'points', min: -3, max: 3 }), 'line').y, { low: -3, high: 3 });
});

test('curves: points stay from 0 to 1, also new ones beside the picture', () => {
  const limits = limits_of(row({ kind: 'curve', min: 0 }), 'function');
  assert.deepEqual(limits, { x: { low: 0, high: 1 }, y: { low: 0, high: Infinity } });
  const made = with_point({ points: [[0.5, 1]], joining: 'spline', form: 'function' }, [-0.1, -2], 0.01);
  assert.ok(made);
  assert.deepEqual(with_legal_point(made.shape, made.index, limits).points, [
    [0, 0],
    [0.5, 1],
  ]);
});

test('values: each kind of row moves its numbers into its range', () => {
  const range = { min: -1, max: 2 };
  assert.equal(legal_value(row(range), 5), 2);
  assert.equal(legal_value(row(range), 'age/2'), 'age/2');
  assert.deepEqual(legal_value(row(range), [-7, 1]), [-1, 1]);
  assert.deepEqual(legal_value(row(range), { range: [0, 9], apply: 'v' }), { range: [0, 2], apply: 'v' });
  assert.deepEqual(
    legal_value(row({ kind: 'box', ...range }), [
      [-5, 0, 0],
      [1, 'a', 3],
    ]),
    [
      [-1, 0, 0],
      [1, 'a', 2],
    ],
  );
  assert.deepEqual(
    legal_value(kPolygon, [
      [-1, -3],
      [1.4, 0.5],
    ]),
    [
      [0, -2],
      [1, 0.5],
    ],
  );
  assert.deepEqual(
    legal_value(row({ kind: 'curve', min: 0 }), {
      curve: [
        [-1, -1],
        [2, 4],
      ],
      kind: 'linear',
    }),
    {
      curve: [
        [0, 0],
        [1, 4],
      ],
      kind: 'linear',
    },
  );
  assert.ok((legal_value(row({ above: 0 }), 0) as number) > 0, 'an end that is excluded');
});

test('places in space: limits stand where a picture shows them', () => {
  const [front, side, top] = kSides;
  const range = { low: -1, high: 5 };
  assert.deepEqual(limits_from(front, range).x, range);
  assert.deepEqual(limits_from(side, range), { x: { low: -5, high: 1 }, y: range });
  assert.deepEqual(limits_from(top, range).y, { low: -5, high: 1 });
});

test('selections: numbers of instances stay countable', () => {
  assert.equal(entry_of('99999999999'), 4294967295);
  assert.deepEqual(entry_of('3 to 99999999999'), [3, 4294967295]);
});

const kTables = {
  components: {},
  tables: {
    document: { doc: '', rows: [{ name: 'scene', kind: 'object', doc: '', table: 'scene' }] },
    scene: {
      doc: '',
      rows: [
        row({ name: 'lamps', kind: 'list', table: 'lamp' }),
        row({ name: 'supports', kind: 'map', table: 'support' }),
      ],
    },
    lamp: { doc: '', rows: [row({ name: 'position', kind: 'vector', in_space: 'position', min: -10, max: 10 })] },
    support: {
      doc: '',
      rows: [row({ name: 'line', kind: 'positions', together: 'line', min: -4, max: 4 })],
      shorthand: 'line',
    },
  },
  document: 'document',
} as unknown as Tables;

test('grips: a hand moves nothing beyond the range of its row', () => {
  const scene = {
    lamps: [{ position: [1, 2, 3] }],
    supports: {
      wire: [
        [0, 1, 0],
        [2, 1, 0],
      ],
    },
  };
  const rows = [kTables.tables['scene'] ?? { doc: '', rows: [] }];
  const groups = groups_of_object(kTables, rows, scene, 'scene', 'scene', kWorld, {
    right: [1, 0, 0],
    toward: [0, 0, 1],
    reach: 1,
  });
  const moved = (index: number): unknown => {
    const group = groups[index];
    assert.ok(group);
    const bound = bound_group(
      group,
      [],
      () => undefined,
      (values) => legal_values(kTables, null, values),
    );
    return bound.grips.find((one) => one.key === 'move x')?.values({ by: [99, 0, 0], degrees: 0, step: 0.01 });
  };
  assert.deepEqual(moved(0), { 'scene.lamps[0].position': [10, 2, 3] });
  // A list alone stands for an object with a line.
  assert.deepEqual(moved(2), {
    'scene.supports.wire': [
      [0, 1, 0],
      [4, 1, 0],
    ],
  });
});
