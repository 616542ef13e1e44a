// SPDX-License-Identifier: Apache-2.0
// Curves, outlines and paths of files, as the rows of the inspector change them.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import type { Shape } from '../src/editors/shape.ts';
import {
  frame_of,
  line_of,
  min_points,
  mirrored,
  shape_of,
  with_point,
  with_point_after,
  with_point_at,
  with_points,
  without_point,
} from '../src/editors/shape.ts';
import { endings_in } from '../src/files/file_endings.ts';
import { folder_of, path_from } from '../src/files/file_path.ts';

const kCurve: Shape = {
  points: [
    [0, 1],
    [0.5, 0.8],
    [1, 0],
  ],
  joining: 'spline',
  form: 'function',
};

test('curves: read as documents write them, and nothing else', () => {
  assert.deepEqual(
    shape_of({
      curve: [
        [0, 1],
        [0.5, 0.8],
        [1, 0],
      ],
    }),
    kCurve,
  );
  assert.equal(shape_of({ curve: [[0, 1]], kind: 'linear' })?.joining, 'linear');
  assert.equal(
    shape_of([
      [0, 0],
      [1, 1],
    ])?.form,
    'line',
  );
  assert.equal(
    shape_of(
      [
        [0, 0],
        [1, 1],
      ],
      'polygon',
    )?.form,
    'polygon',
  );
  assert.equal(shape_of({ curve: [[0, 1]] }, 'polygon')?.form, 'function');
  for (const other of [undefined, null, 3, 'x', [], [[0, '2*size']], [[0, 0, 0]], { curve: [[0, 'a']] }, {}])
    assert.equal(shape_of(other as never), null);
});

test('curves: written back with what else they say', () => {
  assert.deepEqual(with_points({ curve: [], kind: 'spline' }, kCurve), {
    curve: [
      [0, 1],
      [0.5, 0.8],
      [1, 0],
    ],
    kind: 'spline',
  });
  assert.deepEqual(with_points(undefined, kCurve), {
    curve: [
      [0, 1],
      [0.5, 0.8],
      [1, 0],
    ],
  });
  assert.deepEqual(with_points(undefined, { ...kCurve, joining: 'linear' }), {
    curve: [
      [0, 1],
      [0.5, 0.8],
      [1, 0],
    ],
    kind: 'linear',
  });
});

test('curves: the natural spline runs through its points, and is a line where they stand on one', () => {
  const line = line_of(kCurve, 10);
  for (const point of kCurve.points)
    assert.ok(line.some(([x, y]) => Math.abs(x - point[0]) < 1e-12 && Math.abs(y - point[1]) < 1e-12));
  // For three points the second derivative m at the middle is known: (y2 - 2 y1 + y0) 3 / (2 h h). At a quarter of the
  // way, in the first piece, the value is (y0 3 + y1) / 4 + ((1/4)^3 - 1/4) m h h / 6.
  const bend = ((0 - 1.6 + 1) * 3) / (2 * 0.25);
  const quarter = line_of(kCurve, 4)[1];
  assert.ok(Math.abs((quarter?.[1] ?? 0) - (0.75 * 1 + 0.25 * 0.8 + ((0.25 ** 3 - 0.25) * bend * 0.25) / 6)) < 1e-12);
  for (const [x, y] of line_of({
    ...kCurve,
    points: [
      [0, 0],
      [0.2, 0.2],
      [0.7, 0.7],
      [1, 1],
    ],
  }))
    assert.ok(Math.abs(x - y) < 1e-12);
});

test('curves: points keep their order, and nothing leaves the range of x', () => {
  const frame = frame_of(kCurve);
  for (const x of [-3, 0.2, 0.999, 7]) {
    for (const index of [0, 1, 2]) {
      const xs = with_point_at(kCurve, index, [x, 0.3], frame, 0.0001).points.map(([one]) => one);
      assert.ok(
        xs.every((one, k) => k === 0 || one > (xs[k - 1] ?? 0)),
        xs.join(' '),
      );
      assert.ok((xs[0] ?? 0) >= 0 && (xs[2] ?? 0) <= 1);
    }
  }
});

test('curves: an added point stands in its place, and can be removed again', () => {
  const added = with_point(kCurve, [0.7, 0.4], 0.01);
  assert.equal(added?.index, 2);
  assert.deepEqual(without_point(added?.shape ?? kCurve, 2), kCurve);
  assert.equal(with_point(kCurve, [0.5, 0.4], 0.01), null);
  assert.deepEqual(with_point_after({ ...kCurve, joining: 'linear' }, 2, 0.01)?.shape.points[2], [0.75, 0.4]);
  assert.deepEqual(with_point_after({ ...kCurve, points: [[0, 2]] }, 0, 0.01)?.shape.points, [
    [0, 2],
    [1, 2],
  ]);
});

test('outlines: a point is added on the side that is nearest', () => {
  const outline: Shape = {
    points: [
      [0, 0],
      [1, 0],
      [1, 1],
    ],
    joining: 'linear',
    form: 'line',
  };
  assert.equal(with_point(outline, [1.1, 0.5], 0.01)?.index, 2);
  assert.equal(with_point(outline, [0.4, -0.2], 0.01)?.index, 1);
});

test('polygons: the last side leads back to the first point, and takes points too', () => {
  const ring: Shape = {
    points: [
      [0, 0],
      [1, 0],
      [1, 1],
      [0, 1],
    ],
    joining: 'linear',
    form: 'polygon',
  };
  assert.deepEqual(line_of(ring).at(-1), [0, 0]);
  assert.equal(with_point(ring, [-0.1, 0.5], 0.01)?.index, 4);
  assert.deepEqual(with_point_after(ring, 3, 0.01)?.shape.points[4], [0, 0.5]);
  assert.equal(min_points(ring), 3);
});

test('silhouettes: both sides are in the frame, and x = 0', () => {
  const cup: Shape = {
    points: [
      [0.02, 0],
      [0.04, 0.1],
    ],
    joining: 'linear',
    form: 'silhouette',
  };
  const { x } = frame_of(cup);
  assert.ok(x.low < -0.04 && x.high > 0.04 && Math.abs(x.low + x.high) < 1e-12);
  assert.deepEqual(mirrored(cup.points), [
    [-0.02, 0],
    [-0.04, 0.1],
  ]);
});

test('files: paths lead from the document to the file', () => {
  assert.equal(folder_of('plants/oak.json'), 'plants');
  assert.equal(folder_of('oak.json'), '');
  assert.equal(path_from('', 'data/leaf.csv'), 'data/leaf.csv');
  assert.equal(path_from('plants', 'data/leaf.csv'), '../data/leaf.csv');
  assert.equal(path_from('plants/trees', 'plants/leaf.csv'), '../leaf.csv');
  assert.equal(path_from('plants', 'plants/leaf.csv'), 'leaf.csv');
  assert.equal(path_from('', 'plants/../data/./leaf.csv'), 'data/leaf.csv');
});

test('files: the row says which formats it reads', () => {
  assert.deepEqual(endings_in('File with a closed mesh (OBJ, PLY or GLB).'), ['.obj', '.ply', '.glb']);
  assert.deepEqual(endings_in('Picture of colours (PNG or JPEG).'), ['.png', '.jpg', '.jpeg']);
  assert.deepEqual(endings_in('Whatever you have.'), []);
});
