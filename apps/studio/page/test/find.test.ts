// SPDX-License-Identifier: Apache-2.0
// Values of strips and sweeps, lists that are put in order, cameras that are written.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { moved, with_behind, without } from '../src/base/lists.ts';
import { component_order_edits } from '../src/board/board_edits.ts';
import { graph_of } from '../src/board/plant_graph.ts';
import { camera_edits, camera_of_document, state_between } from '../src/camera/camera_document.ts';
import { strip_states, variable_states } from '../src/find/strip_states.ts';
import { groups_of, shown_measure } from '../src/measures/measure_groups.ts';
import { values_of } from '../src/measures/sweep_part.tsx';
import type { ExportCamera } from '../src/server/protocol.ts';
import type { Row } from '../src/tables/tables.ts';
import { kFieldOfView, Orbit } from '../src/view/orbit.ts';

const kRow: Row = { name: 'curl', kind: 'number', doc: '', min: 0, max: 90, usual: [0, 40], varies: 'instance' };
const kTypes = {
  camera: { doc: '', table: 'camera', is_camera: true },
  tree: { doc: '', table: 'tree', makes_stems: true },
};

test('of a range the middle moves and the width stays, within what the row allows', () => {
  const values = strip_states(kRow, [10, 16]).map((one) => one.value);
  assert.deepEqual(values, [
    [0, 6],
    [7, 13],
    [17, 23],
    [27, 33],
    [37, 43],
  ]);
  assert.deepEqual(strip_states(kRow, [16, 10])[2]?.value, [23, 17]);
  assert.deepEqual(strip_states(kRow, { range: [10, 16], apply: 'v*2' })[1]?.value, { range: [7, 13], apply: 'v*2' });
  assert.match(strip_states(kRow, [10, 16])[1]?.tip ?? '', /the width stays/);
});

test('an expression gives way to numbers, which the tooltip says', () => {
  const states = strip_states(kRow, 'bend/2');
  assert.deepEqual(
    states.map((one) => one.value),
    [0, 10, 20, 30, 40],
  );
  assert.match(states[1]?.tip ?? '', /a number in place of the expression bend\/2/);
  assert.equal(strip_states(kRow, 12)[1]?.tip, undefined);
  assert.match(strip_states(kRow, ['a', 3])[0]?.tip ?? '', /the range with expressions/);
  const variable = { name: 'a', value: 1, min: 0, max: 2, unit: '', doc: '', expression: 'b+1', private: false };
  assert.match(variable_states(variable, 0.1)[0]?.tip ?? '', /in place of the expression b\+1/);
  assert.deepEqual(values_of({ ...variable, max: 8 }, 5), [0, 2, 4, 6, 8]);
});

test('components change places among some, and all others stay', () => {
  const document = { components: { a: {}, x: {}, b: {}, c: {} } };
  const all = ['a', 'b', 'c'];
  assert.deepEqual(component_order_edits(document, all, 'a', 1), [{ move: 'components.a', index: 2 }]);
  assert.deepEqual(component_order_edits(document, all, 'c', 0), [{ move: 'components.c', index: 0 }]);
  assert.deepEqual(component_order_edits(document, all, 'b', 99), [{ move: 'components.b', index: 3 }]);
  assert.deepEqual(component_order_edits(document, all, 'b', 1), []);
  assert.deepEqual(component_order_edits(document, ['a'], 'a', 1), []);
});

test('elements of a list are moved, put in and taken out', () => {
  assert.deepEqual(moved([1, 2, 3], 0, 2), [2, 3, 1]);
  assert.deepEqual(moved([1, 2, 3], 2, 0), [3, 1, 2]);
  assert.deepEqual(with_behind([1, 2], 0, 9), [1, 9, 2]);
  assert.deepEqual(without([1, 2, 3], 1), [1, 3]);
});

test('the camera is written over what it said, or added above all that it links to', () => {
  const camera: ExportCamera = { position: [1.23456, 2, 3], target: [0, 1, 0], field_of_view: 32 };
  const said = {
    components: { view: { type: 'camera', azimuth: 30 }, stem: { type: 'tree' } },
    links: [['view', 'stem']],
  };
  assert.deepEqual(camera_edits(said, graph_of(said, kTypes), camera), [
    { unset: 'components.view.azimuth' },
    { set: 'components.view.position', value: [1.235, 2, 3] },
    { set: 'components.view.target', value: [0, 1, 0] },
    { set: 'components.view.field_of_view', value: 32 },
  ]);
  assert.deepEqual(camera_of_document(said, graph_of(said, kTypes), 35), {
    azimuth: 30,
    altitude: 6,
    field_of_view: 35,
  });
  const without_one = { components: { a: { type: 'tree' }, b: { type: 'tree' } } };
  const edits = camera_edits(without_one, graph_of(without_one, kTypes), camera);
  assert.deepEqual(edits.slice(1), [
    { set: 'links', value: [] },
    { insert: 'links[0]', value: ['camera', 'a'] },
    { insert: 'links[1]', value: ['camera', 'b'] },
  ]);
  const { azimuth, altitude, distance } = state_between([1, 1, 0], [0, 1, 0]);
  assert.deepEqual([azimuth, altitude, distance], [90, 0, 1]);
});

test('measures stand under headings and are read at a look', () => {
  const rows = ['trees', 'nodes', 'length', 'height', 'pipe_exponent'].map((name) => ({ name, unit: '', doc: '' }));
  assert.deepEqual(
    groups_of(rows).map((one) => [one.title, one.rows.length]),
    [
      ['Counts', 2],
      ['Size and crown', 2],
      ['Thickness at forks', 1],
    ],
  );
  assert.equal(shown_measure(0.123456), '0.1235');
  assert.equal(shown_measure(12345.6), '12,346');
  assert.equal(shown_measure([1, 2.5]), '1, 2.5');
  assert.equal(shown_measure(null), '–');
});

test('the view looks with the field of view of the document’s camera', () => {
  const said = {
    components: {
      eye: { type: 'camera', position: [0, 1, 4], target: [0, 1, 0], field_of_view: 60 },
      tree: { type: 'tree' },
    },
    links: [['eye', 'tree']],
  };
  const found = camera_of_document(said, graph_of(said, kTypes), 35);
  assert.ok(found && 'state' in found);
  assert.equal(found.state.field_of_view, 60);
  const orbit = new Orbit();
  orbit.look(found.state);
  assert.equal(orbit.camera.fov, 60);
  assert.ok(Math.abs(orbit.height_at_target - 8 * Math.tan(Math.PI / 6)) < 1e-9);
  assert.equal(orbit.as_document.field_of_view, 60);
  const other = new Orbit();
  assert.ok(other.follow(orbit));
  assert.equal(other.camera.fov, 60);
  // Old bookmarks have no field of view. A camera of the document by angles may have none either.
  orbit.look({ azimuth: 0, altitude: 0, distance: 4, target: [0, 1, 0] });
  assert.equal(orbit.camera.fov, kFieldOfView);
});
