// SPDX-License-Identifier: Apache-2.0
// Values over time as in the library, and the keys that edits write.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { without } from '../src/base/lists.ts';
import { Store } from '../src/base/store.ts';
import type { Page } from '../src/page/page.ts';
import {
  animation_of,
  dragged_keys,
  key_at,
  keys_edits,
  name_of_path,
  path_of_name,
  tracks_of,
  with_key,
  with_time,
} from '../src/time/keys.ts';
import { TimeModel } from '../src/time/time_model.ts';
import type { Key } from '../src/time/track.ts';
import { curve_of, has_values_between, value_at_time } from '../src/time/track.ts';
import { dragged_values, set_values, value_now } from '../src/time/values_now.ts';
import { moved_delay } from '../src/timeline/clock_rows.tsx';
import type { Json } from '../src/values/json.ts';

const kTops = new Set(['meristem', 'seed', 'components', 'links', 'scene', 'output', 'animation', 'variables']);
const keys = (...all: [number, Json, Key['way']?][]): Key[] =>
  all.map(([time, value, way = null]) => ({ time, value, way }));

test('numbers pass evenly, smoothly and in jumps, and stay before and behind', () => {
  const track = keys([1, 0], [3, 4], [5, 4, 'step'], [6, 1, 'step']);
  assert.deepEqual(
    [0, 1, 2, 3, 4.9, 5, 5.9, 6, 99].map((time) => value_at_time(track, time)),
    [0, 0, 2, 4, 4, 4, 4, 1, 1],
  );
  // Fritsch and Butland: monotone, at rest where the values turn and at both ends.
  const smooth = keys([0, 0], [1, 1, 'smooth'], [3, 2, 'smooth'], [4, 0, 'smooth']);
  const values = Array.from({ length: 401 }, (_, k) => value_at_time(smooth, k / 100) as number);
  assert.ok(values.slice(1, 301).every((one, k) => one >= (values[k] ?? 0) - 1e-9));
  assert.ok(values.every((one) => one <= 2));
  assert.ok(Math.abs((values[1] ?? 0) - 0.0003) < 2e-4);
  assert.equal(value_at_time(smooth, 0.5), Number((0.5 - (0.125 * 9) / 13).toFixed(6)));
});

test('vectors and colours pass part by part, all else jumps', () => {
  assert.deepEqual(value_at_time(keys([0, [0, 1, 2]], [2, [2, 1, 0]]), 1), [1, 1, 1]);
  assert.equal(value_at_time(keys([0, '#000000'], [2, '#ff8000']), 1), '#804000');
  const choice = keys([0, 'open'], [2, 'closed']);
  assert.equal(value_at_time(choice, 1.9), 'open');
  assert.equal(value_at_time(choice, 2), 'closed');
  assert.equal(has_values_between(choice), false);
  assert.equal(has_values_between(keys([0, '#123456'])), true);
  assert.equal(curve_of(choice, 3), null);
});

test('names of parameters are those of --set, and paths those of the text', () => {
  const document = { variables: { opening: 1 }, components: { stem: {}, scene: {} } };
  for (const [name, path] of [
    ['stem.length', 'components.stem.length'],
    ['links[1].angle', 'links[1].angle'],
    ['scene.sun.hour', 'scene.sun.hour'],
    ['opening', 'variables.opening'],
    ['components.scene.length', 'components.scene.length'],
  ] as const) {
    assert.equal(path_of_name(document, kTops, name), path);
    assert.equal(name_of_path(kTops, path), name);
  }
});

test('keys are put in by their time, moved between their neighbours and taken away', () => {
  const three = keys([0, 1], [2, 5, 'smooth'], [4, 3]);
  assert.deepEqual(with_key(three, 2, 7)[1], { time: 2, value: 7, way: 'smooth' });
  assert.deepEqual(
    with_key(three, 1, 2).map((one) => [one.time, one.way]),
    [
      [0, null],
      [1, 'smooth'],
      [2, 'smooth'],
      [4, null],
    ],
  );
  assert.deepEqual(with_key([], 1.5, 2), keys([1.5, 2]));
  assert.equal(key_at(three, 4.00001), 2);
  assert.deepEqual(
    with_time(three, 1, 99, 10).map((one) => one.time),
    [0, 3.99, 4],
  );
  assert.deepEqual(
    with_time(three, 2, 99, 10).map((one) => one.time),
    [0, 2, 10],
  );
  assert.equal(without(three, 0).length, 2);
});

test('a document gets an animation with its first key, and loses the keys with the last', () => {
  assert.deepEqual(keys_edits({}, 'stem.length', keys([1, 2])), [
    { set: 'animation', value: { length: 10, keys: { 'stem.length': [[1, 2]] } } },
  ]);
  const film = {
    animation: {
      length: 4,
      keys: {
        'stem.length': [
          [0, 1],
          [4, 2, 'smooth'],
        ],
      },
    },
    components: { stem: {} },
  };
  const [track] = tracks_of(film, kTops);
  assert.deepEqual(track, {
    name: 'stem.length',
    path: 'components.stem.length',
    keys: keys([0, 1], [4, 2, 'smooth']),
  });
  assert.deepEqual(keys_edits(film, 'stem.length', keys([0, 1])), [
    { set: 'animation.keys["stem.length"]', value: [[0, 1]] },
  ]);
  assert.deepEqual(keys_edits(film, 'stem.length', []), [{ unset: 'animation.keys' }]);
  assert.deepEqual(dragged_keys(film, { 'stem.radius': keys([0, 1]) }), {
    'animation.keys': {
      'stem.length': [
        [0, 1],
        [4, 2, 'smooth'],
      ],
      'stem.radius': [[0, 1]],
    },
  });
  assert.deepEqual(animation_of(film), { length: 4, fps: 25 });
  assert.equal(animation_of({}), null);
  // Keys that are not well formed make no track, and do not affect other tracks.
  assert.deepEqual(
    tracks_of({ animation: { keys: { a: [[0]], b: 3, 'c.d': [[0, 1]] } } }, kTops).map((one) => one.name),
    ['c.d'],
  );
});

test('a delay moves as a number and as a range, and not as an expression', () => {
  assert.equal(moved_delay(2, 0.5), 2.5);
  assert.equal(moved_delay(undefined, 0.5), 0.5);
  assert.deepEqual(moved_delay([1, 3], -1), [0, 2]);
  assert.deepEqual(moved_delay({ range: [1, 3], apply: 'v*2' }, 1), { range: [2, 4], apply: 'v*2' });
  assert.equal(moved_delay('3*rand()', 1), null);
});

/// Returns a page whose view shows a time, and that records its edits.
function at_time(document: Json, time: number): { page: Page; edits: object[] } {
  const edits: object[] = [];
  const tracks = tracks_of(document, kTops);
  const edit = (all: object[], label: string): Promise<null> => {
    edits.push({ all, label });
    return Promise.resolve(null);
  };
  return {
    page: { edit, dragged: new Store({}), tool: () => ({ document, tops: kTops, tracks, time }) } as unknown as Page,
    edits,
  };
}

test('what has keys is seen and edited at the time of the view, whoever edits it', () => {
  const document = {
    scene: { sun: { azimuth: 90, altitude: 10 } },
    components: { stem: { frame: { translate: [1, 0, 0] } } },
    animation: {
      length: 4,
      keys: {
        'scene.sun.altitude': [
          [0, 10],
          [4, 50],
        ],
        'stem.frame.translate[1]': [
          [0, 0],
          [4, 2],
        ],
      },
    },
  };
  const { page, edits } = at_time(document, 2);
  assert.deepEqual(value_now(page, 'scene', document.scene), { sun: { azimuth: 90, altitude: 30 } });
  assert.deepEqual(value_now(page, 'components.stem', document.components.stem), { frame: { translate: [1, 1, 0] } });
  set_values(page, { 'scene.sun.altitude': 40 }, 'Set the sun');
  set_values(page, { 'scene.sun.azimuth': 80, 'scene.sun.altitude': 40 }, 'Set the sun');
  // An element with keys gets a key if its value differs from its keys.
  set_values(page, { 'components.stem.frame.translate': [3, 1, 0] }, 'Set the stem');
  set_values(page, { 'components.stem.frame.translate': [1, 1.5, 0] }, 'Set the stem');
  const sun = {
    set: 'animation.keys["scene.sun.altitude"]',
    value: [
      [0, 10],
      [2, 40],
      [4, 50],
    ],
  };
  const still = {
    set: 'animation.keys["stem.frame.translate[1]"]',
    value: [
      [0, 0],
      [4, 2],
    ],
  };
  assert.deepEqual(edits, [
    { all: [sun], label: 'Key the sun' },
    { all: [{ set: 'scene.sun.azimuth', value: 80 }, sun], label: 'Set the sun' },
    { all: [{ set: 'components.stem.frame.translate', value: [3, 1, 0] }], label: 'Set the stem' },
    {
      all: [
        { set: 'components.stem.frame.translate', value: [1, 1.5, 0] },
        {
          ...still,
          value: [
            [0, 0],
            [2, 1.5],
            [4, 2],
          ],
        },
      ],
      label: 'Set the stem',
    },
  ]);
  assert.deepEqual(dragged_values(page, { 'scene.sun.altitude': 40 }), {
    'animation.keys': { ...document.animation.keys, 'scene.sun.altitude': sun.value },
  });
  assert.deepEqual(dragged_values(page, { 'scene.sun.azimuth': 1 }), { 'scene.sun.azimuth': 1 });
});

test('a value within one that has keys as a whole changes its part of the key', () => {
  const document = {
    components: { stem: { frame: { translate: [1, 0, 0] } } },
    animation: {
      length: 4,
      keys: {
        'stem.frame.translate': [
          [0, [0, 0, 0]],
          [4, [4, 4, 4]],
        ],
      },
    },
  };
  const { page, edits } = at_time(document, 2);
  set_values(page, { 'components.stem.frame.translate[2]': 9 }, 'Set the stem');
  assert.deepEqual(edits, [
    {
      all: [
        {
          set: 'animation.keys["stem.frame.translate"]',
          value: [
            [0, [0, 0, 0]],
            [2, [2, 2, 9]],
            [4, [4, 4, 4]],
          ],
        },
      ],
      label: 'Key the stem',
    },
  ]);
});

/// Returns a model of the time with a recording server and view.
function model_of_time(): {
  model: TimeModel;
  asked: Record<string, number>[];
  view: { is_software: boolean; moves: boolean };
} {
  const asked: Record<string, number>[] = [];
  const view = { is_software: true, moves: false, move_time };
  function move_time(moves: boolean): void {
    view.moves = moves;
  }
  const send = (_: string, members: Record<string, number>): Promise<object> => {
    asked.push(members);
    return Promise.resolve({});
  };
  const page = {
    document: { state: new Store({ tree: null }) },
    tables: { tables: {}, document: '' },
    view,
    connection: { request: send, tell: send },
  };
  return { model: new TimeModel(page as unknown as Page), asked, view };
}

const later = (milliseconds: number): Promise<void> => new Promise((done) => setTimeout(done, milliseconds));

test('while the time moves the view knows it and few triangles are asked for; at rest as many as ever', async () => {
  (globalThis as { window?: object }).window ??= globalThis;
  const { model, asked, view } = model_of_time();
  model.scrub(1);
  assert.ok(view.moves);
  assert.equal(asked[0]?.['rest_triangles'], 60_000);
  await later(220);
  assert.ok(!view.moves);
  assert.equal(asked.at(-1)?.['rest_triangles'], 250_000);
  // While it is played, the time moves until it is stopped, however long a picture takes.
  model.state.merge({ is_playing: true });
  model.scrub(2);
  await later(220);
  assert.ok(view.moves);
  model.stop();
  await later(40);
  assert.ok(!view.moves);
  assert.deepEqual([asked.at(-1)?.['time'], asked.at(-1)?.['rest_triangles']], [2, 250_000]);
});

test('a document that cannot be opened leaves the time as it is', async () => {
  const { model, asked } = model_of_time();
  model.scrub(3);
  const left = model.leave();
  assert.equal(model.time, 0);
  model.come_back(left);
  await later(40);
  assert.equal(model.time, 3);
  assert.equal(asked.at(-1)?.['time'], 3);
});
