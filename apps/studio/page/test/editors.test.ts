// SPDX-License-Identifier: Apache-2.0
// Editors: snapping of points, colours, positions in space, selections.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { azimuths_of, turned_points } from '../src/editors/crown_cloud.ts';
import { grid_lines, levels_of, Scale, snapped } from '../src/editors/plane.ts';
import { count_named, entries_of, named_numbers } from '../src/editors/selection_set.ts';
import type { Shape } from '../src/editors/shape.ts';
import { frame_of, line_of, with_point, with_point_after, with_point_at } from '../src/editors/shape.ts';
import { frame_from, kSides, moved_in, names_of, places_of, seen_from } from '../src/editors/space.ts';
import { PinList } from '../src/find/pins.ts';
import { strip_states, values_by_chance, values_over } from '../src/find/strip_states.ts';
import { excluded_by } from '../src/rows/exclusion.ts';
import type { Row } from '../src/tables/tables.ts';
import { colour_of, colours_in, full_colour, hsv_of } from '../src/values/colour.ts';

const kFrame = { x: { low: 0, high: 1 }, y: { low: 0, high: 1 } };
const kSize = { wide: 256, high: 120, margin: 8 };

test('planes: a point stands where it is read from', () => {
  for (const is_even of [true, false]) {
    const scale = new Scale(kFrame, kSize, is_even);
    for (const point of [
      [0, 0],
      [0.3, 0.9],
      [1, -2],
    ] as const) {
      const [x, y] = scale.value(scale.place(point));
      assert.ok(Math.abs(x - point[0]) < 1e-12 && Math.abs(y - point[1]) < 1e-12);
    }
  }
  const even = new Scale(kFrame, kSize, true);
  assert.equal(even.pixel[0], even.pixel[1]);
});

test('planes: lines of the grid are round and far enough apart', () => {
  const { lines, step } = grid_lines({ low: -0.07, high: 1.03 }, 0.01, 20);
  assert.deepEqual(lines, [0, 0.2, 0.4, 0.6, 0.8, 1]);
  assert.equal(step, 0.2);
  for (const per_pixel of [0.0013, 0.07, 3, 41]) {
    const grid = grid_lines({ low: -50 * per_pixel, high: 200 * per_pixel }, per_pixel, 24);
    assert.ok(grid.step >= 23.9 * per_pixel && grid.step <= 61 * per_pixel, `${grid.step} ${per_pixel}`);
  }
});

test('planes: points are drawn to the grid and to each other, and else keep few digits', () => {
  const scale = new Scale(kFrame, kSize, false);
  const levels = levels_of([[0.333, 0.9]], scale, 24);
  assert.deepEqual(snapped([0.334, 0.5], levels, scale, 0.01).guides.x, 0.333);
  assert.equal(snapped([0.204, 0.5], levels, scale, 0.01).point[0], 0.2);
  const free = snapped([0.2349, 0.5], { x: [], y: [] }, scale, 0.01);
  assert.deepEqual(free, { point: [0.23, 0.5], guides: { x: null, y: null } });
});

test('profiles: a spline of radius over height, whose points stay in order', () => {
  const profile: Shape = {
    points: [
      [0.2, 1],
      [1, 2],
      [0, 3],
    ],
    joining: 'linear',
    form: 'profile',
  };
  const line = line_of(profile);
  assert.equal(line.length, 25);
  assert.deepEqual([line[0], line[12], line[24]], profile.points);
  assert.ok(line.every(([radius]) => radius >= 0));
  const frame = frame_of(profile);
  assert.ok(Math.abs(frame.x.low + frame.x.high) < 1e-9, 'both sides are shown');
  // The point passes neither its neighbours nor the axis.
  const [radius, height] = with_point_at(profile, 1, [-4, 9], frame, 0.01).points[1] ?? [1, 0];
  assert.ok(radius === 0 && height > 2.9 && height < 3);
  assert.deepEqual(with_point(profile, [0.5, 2.5], 0.01)?.index, 2);
  assert.equal(with_point(profile, [0.5, 2], 0.01), null);
  const between = with_point_after(profile, 0, 0.01)?.shape.points[1] ?? [0, 0];
  assert.ok(between[0] > 0.6 && between[1] === 1.5, 'on the spline, which swings out');
  // A wrong shape is drawn as it is.
  assert.deepEqual(
    line_of({
      ...profile,
      points: [
        [0, 2],
        [1, 2],
      ],
    }),
    [
      [0, 2],
      [1, 2],
    ],
  );
});

test('curves: a point between two is in their middle', () => {
  const made = with_point_after(
    {
      points: [
        [0, 1],
        [1, 0],
      ],
      joining: 'spline',
      form: 'function',
    },
    0,
    0.01,
  );
  assert.deepEqual(made?.shape.points[1], [0.5, 0.5]);
});

test('clouds: points are turned into the plane of their outline', () => {
  const around = [0, 1, -2, 3, 2, 0, 0, 3, 4, -5, 4, 0]; // north, east, south, west
  assert.deepEqual(turned_points(around, null, []), [
    [2, 1],
    [3, 2],
    [4, 3],
    [5, 4],
  ]);
  const azimuths = azimuths_of({ 0: [], 90: [], 225: [] });
  assert.deepEqual(azimuths, [0, 90, 225]);
  assert.deepEqual(turned_points(around, 0, azimuths), [[2, 1]]);
  assert.deepEqual(turned_points(around, 225, azimuths), [
    [4, 3],
    [5, 4],
  ]);
  assert.deepEqual(turned_points([-0.1, 1, -2], 355, [10, 355]).length, 1);
});

test('space: what one picture moves stays where the other shows it', () => {
  const [front, side, top] = kSides;
  const place = [1, 2, 3] as const;
  assert.deepEqual(seen_from(front, place), [1, 2]);
  assert.deepEqual(seen_from(side, place), [-3, 2]);
  assert.deepEqual(seen_from(top, place), [1, -3]);
  for (const view of kSides) assert.deepEqual(moved_in(view, place, seen_from(view, place), 1e-9), place);
  assert.deepEqual(moved_in(side, place, [-4, 5], 0.1), [1, 5, 4]);
  assert.deepEqual(names_of(top), ['x', '−z']);
  const frames = kSides.map((view) => frame_from(view, [place, [0, 0, 0]]));
  const widths = frames.map(({ x }) => x.high - x.low);
  assert.ok(widths.every((one) => Math.abs(one - (widths[0] ?? 0)) < 1e-9));
  assert.equal(places_of([[0, 'a', 1]]), null);
  assert.deepEqual(places_of([[0, 1, 2]]), [[0, 1, 2]]);
});

test('colours: hue, saturation and value give the colour back', () => {
  for (const colour of ['#000000', '#ffffff', '#6b8e23', '#ff0000', '#00ff01', '#123456', '#fedcba'])
    assert.equal(colour_of(hsv_of(colour)), colour);
  assert.equal(full_colour('#AbC'), '#aabbcc');
  assert.equal(full_colour('olive'), null);
  assert.deepEqual(colours_in({ a: { colour: '#ABC', b: ['#112233', '#aabbcc'] }, name: 'oak' }), [
    '#aabbcc',
    '#112233',
  ]);
});

test('selections: cells become the shortest entries, and conditions stay', () => {
  const entries = [0, [3, 5], 'i % 4 == 2'];
  const named = named_numbers(entries, 12);
  assert.deepEqual([...named], [0, 3, 4, 5]);
  named.add(1);
  named.delete(4);
  assert.deepEqual(entries_of(named, entries, 12), [0, 1, 3, 5, 'i % 4 == 2']);
  assert.deepEqual(entries_of(new Set([2, 3, 4, 8]), [], 12), [[2, 4], 8]);
  assert.deepEqual(entries_of(new Set(), [[20, 30]], 12), [[20, 30]]);
  assert.equal(count_named(entries), 6);
});

const row = (part: Partial<Row>): Row => ({ name: 'size', kind: 'number', doc: '', ...part });

test('strips: five values over the usual range, ends included', () => {
  assert.deepEqual(values_over(0, 1, false), [0, 0.25, 0.5, 0.75, 1]);
  assert.deepEqual(values_over(1, 3, true), [1, 2, 3]);
  assert.deepEqual(values_over(1, 1, false), []);
  assert.deepEqual(
    strip_states(row({ usual: [0, 2], min: 0.5 }), 1).map((one) => one.value),
    [0.5, 1, 1.5, 2],
  );
  assert.equal(strip_states(row({ usual: [0, 2] }), 'age/2').length, 5);
  assert.deepEqual(
    strip_states(row({ kind: 'choice', choices: ['a', 'b_c'] }), 'a').map((one) => one.text),
    ['a', 'b c'],
  );
  assert.equal(strip_states(row({ kind: 'boolean' }), undefined).length, 2);
});

test('chance: values lie within their ranges', () => {
  const variable = { name: 'age', value: 3, min: 2, max: 10, unit: '', doc: '', expression: null, private: false };
  for (const chance of [0, 0.37, 1]) {
    const { age } = values_by_chance(
      [variable],
      () => 1,
      () => chance,
    );
    assert.ok(age !== undefined && age >= 2 && age <= 10 && Number.isInteger(age));
  }
});

test('pins: two at most, each with a name of its own', () => {
  const pins = new PinList();
  for (const text of ['1', '2', '3']) pins.add({ text, path: null, model: 'oak' });
  assert.deepEqual(
    pins.shown.get().map((one) => one.name),
    ['A', 'B'],
  );
  pins.remove(pins.shown.get()[0]?.id ?? 0);
  pins.add({ text: '4', path: null, model: null });
  assert.deepEqual(
    pins.shown.get().map((one) => [one.name, one.text]),
    [
      ['A', '4'],
      ['B', '2'],
    ],
  );
});

test('exclusive rows: those that never stand beside a row are known by both names', () => {
  const table = {
    doc: '',
    rows: [],
    one_of: [['above', 'above_lateral', 'outside']],
    never_with: [['at', 'from'] as [string, string]],
  };
  assert.deepEqual(excluded_by(table, 'above_lateral', { above: 3, at: 1 }), ['above']);
  assert.deepEqual(excluded_by(table, 'from', { at: 1 }), ['at']);
  assert.deepEqual(excluded_by(table, 'at', { from: 1, above: 2 }), ['from']);
  assert.deepEqual(excluded_by(table, 'above', { above: 2 }), []);
});
