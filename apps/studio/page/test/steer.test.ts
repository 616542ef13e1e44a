// SPDX-License-Identifier: Apache-2.0
// The sun's path, rotations of documents, grips from the tables, operations as text.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { Store } from '../src/base/store.ts';
import { bound_group } from '../src/gizmo/bound_group.ts';
import { expressed, expressions_in, meant_values, said_of_held, with_numbers } from '../src/gizmo/expressions.ts';
import type { GripGroup, Sight } from '../src/gizmo/grip.ts';
import { amount_of } from '../src/gizmo/grip.ts';
import { groups_of_object } from '../src/gizmo/row_groups.ts';
import { draw_midrib, draw_widths, drawn_points } from '../src/grass/curves.ts';
import type { FoundShoot } from '../src/page/instance_choice.ts';
import { InstanceChoice } from '../src/page/instance_choice.ts';
import type { Page } from '../src/page/page.ts';
import { kNoGrowth } from '../src/page/page_state.ts';
import { counted_act, text_with_off, times_of, what_of, when_of, years_of } from '../src/pruning/operation_text.ts';
import { kept_metamers, kFirstChoice, operation_of, parts_of, why_not } from '../src/pruning/shoot_cut.ts';
import { bearers_of, measures_of, moved_metamer, place_of } from '../src/pruning/shoot_text.ts';
import {
  date_of_day,
  day_of,
  day_of_date,
  daylight,
  declination,
  hour_and_declination,
  hour_of,
  sun_place,
} from '../src/scene/sun_math.ts';
import { sun_state, with_time } from '../src/scene/sun_state.ts';
import type { OperationAct, Variable } from '../src/server/protocol.ts';
import type { Tables } from '../src/tables/tables.ts';
import type { Json } from '../src/values/json.ts';
import { with_values } from '../src/values/put_values.ts';
import type { Vec } from '../src/values/space_math.ts';
import {
  along_line,
  frame_of_rows,
  framed,
  kWorld,
  on_plane,
  point_in,
  turn_of,
  turns_to,
  vector_in,
  vector_out,
} from '../src/values/space_math.ts';

const near = (a: number, b: number, within = 1e-6): void => assert.ok(Math.abs(a - b) <= within, `${a} is not ${b}`);
const near_all = (a: readonly number[], b: readonly number[], within = 1e-6): void => {
  for (const [k, one] of a.entries()) near(one, b[k] ?? NaN, within);
};

test('the sun of a day goes over the south, and comes back from its place', () => {
  const noon = sun_place(51.5, 172, 12);
  near(noon.azimuth, 180, 0.01);
  near(noon.altitude, 90 - 51.5 + declination(172), 1e-6);
  near(declination(172), 23.44, 0.02);
  for (const [day, hour] of [
    [172, 9.5],
    [80, 15],
    [355, 11],
  ] as const) {
    const back = hour_and_declination(51.5, sun_place(51.5, day, hour));
    near(back.hour, hour, 1e-6);
    near(back.declination, declination(day), 1e-6);
    assert.equal(day_of(back.declination, day), day);
  }
  const light = daylight(51.5, 172);
  assert.ok(light && light[0] < 4.5 && light[1] > 19.5);
  assert.equal(daylight(80, 355), null);
  assert.deepEqual(daylight(80, 172), [0, 24]);
});

test('days and hours are those of dates and clocks', () => {
  assert.equal(day_of_date('2026-06-21'), 172);
  assert.equal(date_of_day(172, 2026), '2026-06-21');
  assert.equal(hour_of('15:30'), 15.5);
  assert.equal(hour_of('noon'), null);
});

test('the dial writes what the scene says its sun by', () => {
  const by_day = { latitude: 50, sun: { day: 100, hour: 9 } };
  assert.deepEqual(with_time(by_day, sun_state(by_day), 100, 10.02), { 'scene.sun.hour': 10 });
  assert.deepEqual(with_time(by_day, sun_state(by_day), 120, 9), { 'scene.sun.hour': 9, 'scene.sun.day': 120 });
  const by_date = { latitude: 50, sun: { date: '2026-06-21', hour: '09:30' } };
  assert.deepEqual(with_time(by_date, sun_state(by_date), 173, 15.5), {
    'scene.sun.hour': '15:30',
    'scene.sun.date': '2026-06-22',
  });
  const season = { latitude: 50, sun: { days: [90, 270], hour: 9 } };
  assert.equal(sun_state(season).kind, 'season');
  assert.equal(sun_state(season).day, 180);
  assert.deepEqual(with_time(season, sun_state(season), 10, 8), { 'scene.sun.hour': 8 });
  assert.equal(sun_state({ sun: { day: 'noon_day' } }).kind, 'other');
  assert.equal(sun_state({}).kind, 'none');
});

test('turns of documents go there and back', () => {
  for (const turn of [
    [0, 30, 0],
    [20, -40, 70],
    [-80, 10, 5],
    [90, 0, 33],
  ] as Vec[])
    near_all(turns_to(turn_of(turn)), turn, 1e-6);
  // A roll about y of 90 degrees takes z to x.
  near_all(turn_of([0, 90, 0])[2], [1, 0, 0]);
  const frame = framed(
    { axes: turn_of([20, 30, 40]), origin: [1, 2, 3] },
    {
      axes: [
        [2, 0, 0],
        [0, 2, 0],
        [0, 0, 2],
      ],
      origin: [0, 1, 0],
    },
  );
  near_all(vector_out(frame, vector_in(frame, [0.3, -0.2, 0.9])), [0.3, -0.2, 0.9]);
  assert.deepEqual(point_in(frame_of_rows([1, 0, 0, 5, 0, 1, 0, 6, 0, 0, 1, 7]), [1, 1, 1]), [6, 7, 8]);
});

test('a line of sight finds its place on lines and planes', () => {
  const ray = { origin: [0, 0, 10] as Vec, way: [0, 0, -1] as Vec };
  near(along_line(ray, [3, 0, 0], [1, 0, 0]) ?? NaN, -3);
  assert.equal(along_line(ray, [0, 0, 0], [0, 0, 1]), null);
  near_all(on_plane(ray, [0, 0, 2], [0, 0, 1]) ?? [], [0, 0, 2]);
  assert.equal(on_plane(ray, [0, 0, 20], [0, 0, 1]), null);
});

const row = (name: string, kind: string, more: object = {}): object => ({ name, kind, doc: name, ...more });
const kTables = {
  tables: {
    scene: {
      doc: '',
      rows: [
        row('obstacles', 'list', { table: 'obstacle' }),
        row('lamps', 'list', { table: 'lamp' }),
        row('supports', 'map', { table: 'support' }),
      ],
    },
    obstacle: {
      doc: '',
      rows: [
        row('box', 'box'),
        row('mesh', 'file'),
        row('scale', 'number'),
        row('rotate', 'vector', { in_space: 'turn' }),
        row('translate', 'vector', { in_space: 'shift' }),
      ],
    },
    lamp: { doc: '', rows: [row('position', 'vector', { in_space: 'position' })] },
    support: { doc: '', rows: [row('line', 'positions', { together: 'line' })], shorthand: 'line' },
    tree: {
      doc: '',
      rows: [
        row('roots', 'positions', { together: 'apart', default: [[0, 0, 0]] }),
        row('crown', 'object', { table: 'crown' }),
        row('frame', 'object', { table: 'transform' }),
      ],
    },
    crown: {
      doc: '',
      rows: [
        row('profile', 'points', { in_space: 'profile' }),
        row('sphere', 'object', { table: 'sphere' }),
        row('cone', 'object', { table: 'cone' }),
      ],
    },
    sphere: {
      doc: '',
      rows: [
        row('centre', 'vector', { in_space: 'position' }),
        row('radius', 'number', { in_space: 'radius', above: 0 }),
      ],
    },
    cone: {
      doc: '',
      rows: [
        row('base', 'vector', { in_space: 'position' }),
        row('height', 'number', { in_space: 'height', above: 0 }),
      ],
    },
    transform: {
      doc: '',
      rows: [row('translate', 'vector', { in_space: 'shift' }), row('rotate', 'vector', { in_space: 'turn' })],
    },
  },
} as unknown as Tables;
const kSight: Sight = { right: [1, 0, 0], toward: [0, 0, 1], reach: 1 };
const of = (table: string, value: unknown, path: string): GripGroup[] =>
  groups_of_object(
    kTables,
    [kTables.tables[table] ?? { doc: '', rows: [] }],
    value as never,
    path,
    path,
    kWorld,
    kSight,
  );
const values_of = (group: GripGroup | undefined, key: string, by: Vec, degrees = 0): unknown =>
  group?.grips.find((one) => one.key === key)?.values({ by, degrees, step: 0.01 });

test('a box is moved, sized and turned about its middle', () => {
  const [box] = of(
    'scene',
    {
      obstacles: [
        {
          box: [
            [1, 0, 0],
            [3, 2, 2],
          ],
        },
      ],
    },
    'scene',
  );
  assert.equal(box?.key, 'scene.obstacles[0].box');
  assert.equal(box?.label, 'obstacle 1, box');
  assert.deepEqual(values_of(box, 'move x', [0.5, 0, 0]), {
    'scene.obstacles[0].box': [
      [1.5, 0, 0],
      [3.5, 2, 2],
    ],
  });
  assert.deepEqual(values_of(box, 'upper y', [0, 1, 0]), {
    'scene.obstacles[0].box': [
      [1, 0, 0],
      [3, 3, 2],
    ],
  });
  // A side does not pass the other one.
  assert.deepEqual(values_of(box, 'lower x', [9, 0, 0]), {
    'scene.obstacles[0].box': [
      [3, 0, 0],
      [3, 2, 2],
    ],
  });
  const turned = values_of(box, 'turn y', [0, 0, 0], 90) as Record<string, number[]>;
  near_all(turned['scene.obstacles[0].rotate'] ?? [], [0, 90, 0]);
  // The middle, (2, 1, 1), stays: turned about the origin it would be at (1, 1, -2).
  near_all(turned['scene.obstacles[0].translate'] ?? [], [1, 0, 3], 1e-4);
});

test('lamps, meshes and wires are moved; expressions have no grips', () => {
  const groups = of(
    'scene',
    {
      lamps: [{ position: [1, 2, 3] }, { position: ['t', 0, 0] }],
      obstacles: [{ mesh: 'a.obj', translate: [1, 0, 0] }],
      supports: {
        wire: [
          [0, 1, 0],
          [2, 1, 0],
        ],
      },
    },
    'scene',
  );
  assert.deepEqual(
    groups.map((one) => one.label),
    ['obstacle 1, place', 'lamp 1', 'support wire, point 1', 'support wire, point 2'],
  );
  assert.deepEqual(values_of(groups[1], 'move xz', [1, 0, 1]), { 'scene.lamps[0].position': [2, 2, 4] });
  assert.deepEqual(values_of(groups[3], 'move y', [0, 1, 0]), {
    'scene.supports.wire': [
      [0, 1, 0],
      [2, 2, 0],
    ],
  });
  assert.deepEqual(
    groups[0]?.fields.map((one) => one.label),
    ['x', 'y', 'z', 'pitch', 'roll', 'yaw'],
  );
});

test('expressions are found where numbers may stand, and nowhere else', () => {
  const scene = {
    lamps: [{ position: ['a', 0, [1, 2]] }],
    obstacles: [
      {
        box: [
          ['-a', 0, 0],
          [1, 'b/2', 1],
        ],
        mesh: 'a',
        scale: 'b',
      },
    ],
  };
  const rows = [kTables.tables['scene'] ?? { doc: '', rows: [] }];
  const found = expressions_in(kTables, rows, scene, 'scene');
  // A vector within a vector is no number.
  assert.deepEqual(Object.fromEntries(found), {
    'scene.lamps[0].position[0]': 'a',
    'scene.obstacles[0].box[0][0]': '-a',
    'scene.obstacles[0].box[1][1]': 'b/2',
    'scene.obstacles[0].scale': 'b',
  });
});

test('a hand moves variables in the place of their names, and what it leaves stays as it is written', () => {
  const lamp = { position: ['a', 'a + 1', 3] };
  const written_at = (): Json => lamp.position;
  const variable = { name: 'a', value: 1, min: 0, max: 2, expression: null } as unknown as Variable;
  const all = expressed(
    new Map<string, Json>([
      ['l.position[0]', 'a'],
      ['l.position[1]', 'a + 1'],
    ]),
    { 'l.position[1]': 2 },
    [variable],
    () => 1,
  );
  assert.deepEqual(with_numbers({ position: lamp.position }, 'l', all), { position: [1, 2, 3] });
  assert.deepEqual(meant_values({ 'l.position': [1.5, 2, 3] }, all, written_at).values, { a: 1.5 });
  assert.deepEqual(meant_values({ 'l.position': [9, 2, 3] }, all, written_at).values, { a: 2 });
  assert.deepEqual(meant_values({ 'l.position': [1, 2, 4] }, all, written_at).values, {
    'l.position': ['a', 'a + 1', 4],
  });
  const { values, held } = meant_values({ 'l.position': [1, 2.5, 3] }, all, written_at);
  assert.deepEqual([values, held.map((one) => one.path)], [{}, ['l.position[1]']]);
  assert.equal(said_of_held(held), 'position[1] is the expression “a + 1”');
  const [group] = of('lamp', { position: [1, 2, 3] }, 'l');
  assert.ok(group);
  const bound = bound_group(group, all, written_at);
  const states = Object.fromEntries(bound.grips.map((one) => [one.key, [one.moves.length, one.held.length]]));
  assert.deepEqual(states, {
    move: [1, 1],
    'move x': [1, 0],
    'move y': [0, 1],
    'move z': [0, 0],
    'move yz': [0, 1],
    'move xz': [1, 0],
    'move xy': [1, 1],
  });
  assert.deepEqual(
    bound.fields.map((one) => [one.moves.length, one.held.length]),
    [
      [1, 0],
      [0, 1],
      [0, 0],
    ],
  );
  // A variable is one number, so a box cannot be stretched by it.
  const both = expressed(
    new Map<string, Json>([
      ['b[0]', 'a'],
      ['b[1]', 'a'],
    ]),
    {},
    [variable],
    () => 1,
  );
  assert.equal(meant_values({ b: [1.5, 1.2] }, both, () => ['a', 'a']).held.length, 1);
  assert.deepEqual(meant_values({ b: [1.5, 1.5] }, both, () => ['a', 'a']).values, { a: 1.5 });
});

test('crowns stand on the first root, in the frame of their component', () => {
  const tree = {
    frame: { translate: [10, 0, 0] },
    roots: [[1, 0, 0]],
    crown: { sphere: { centre: [0, 2, 0], radius: 1 } },
  };
  const groups = of('tree', tree, 'components.tree');
  const ball = groups.find((one) => one.label === 'crown, sphere');
  assert.deepEqual(ball?.at, [11, 2, 0]);
  assert.deepEqual(values_of(ball, 'radius', [0.5, 0, 0]), { 'components.tree.crown.sphere.radius': 1.5 });
  assert.deepEqual(
    groups.map((one) => one.key),
    ['components.tree.roots[0]', 'components.tree.crown.sphere.centre', 'components.tree.frame.translate'],
  );
});

test('points of a profile are dragged across the view and keep their order', () => {
  const [profile] = of(
    'crown',
    {
      profile: [
        [0.2, 1],
        [1, 2],
        [0, 3],
      ],
    },
    'crown',
  );
  assert.deepEqual(values_of(profile, 'point 2', [0.5, 0.25, 0]), {
    'crown.profile': [
      [0.2, 1],
      [1.5, 2.25],
      [0, 3],
    ],
  });
  assert.deepEqual(values_of(profile, 'point 2', [-5, 9, 0]), {
    'crown.profile': [
      [0.2, 1],
      [0, 2.999],
      [0, 3],
    ],
  });
});

test('a hand moves along the line that it has hold of', () => {
  const [box] = of(
    'scene',
    {
      obstacles: [
        {
          box: [
            [0, 0, 0],
            [2, 2, 2],
          ],
        },
      ],
    },
    'scene',
  );
  const grip = box?.grips.find((one) => one.key === 'move x');
  assert.ok(grip);
  const ray = (x: number): { origin: Vec; way: Vec } => ({ origin: [x, 5, 10], way: [0, 0, -1] });
  near_all(amount_of({ grip, start: ray(2) }, ray(3.5), kSight.toward, 0.1)?.by ?? [], [1.5, 0, 0]);
});

test("values under the hand stand in the place of the document's", () => {
  const value = { obstacles: [{ box: 1 }, { box: 2 }] };
  assert.deepEqual(with_values(value, ['scene'], { 'scene.obstacles[1].box': 3, 'leaf.length': 1 }), {
    obstacles: [{ box: 1 }, { box: 3 }],
  });
});

test('curves of files become few points of the document', () => {
  const line = Array.from({ length: 49 }, (_, k): [number, number] => [k / 4, k / 2]);
  const curves = {
    leaves: [],
    leaf: { rank: 1, leaf: null },
    midrib_points: line,
    midrib: line,
    distance: 0,
    width_points: [],
    widths: line,
    midrib_file: true,
    width_file: true,
    length: 0.26834,
    width: 0.02,
  };
  const edits = draw_midrib('components.leaf', { midrib: 'a.csv', widths: 'b.csv', rank: 1 }, curves);
  assert.deepEqual(
    edits.map((one) => Object.keys(one)[0]),
    ['set', 'unset', 'set'],
  );
  assert.deepEqual(edits[2], { set: 'components.leaf.length', value: 0.2683 });
  assert.equal(drawn_points(line).length, 9);
  assert.deepEqual(drawn_points(line).at(-1), [12, 24]);
  // With the last file, the parameters that only files need are removed.
  const last = draw_widths('components.leaf', { widths: 'b.csv', rank: 1, unit: 0.01, width: 0.03 }, curves);
  assert.deepEqual(last.slice(1), [
    { unset: 'components.leaf.widths' },
    { unset: 'components.leaf.rank' },
    { unset: 'components.leaf.unit' },
  ]);
});

test('a shoot is told in words, and the place on it moves from node to node', () => {
  assert.deepEqual(bearers_of('main.4.2b'), [
    { shoot: 'main.4', metamer: 2 },
    { shoot: 'main', metamer: 4 },
  ]);
  assert.deepEqual(bearers_of('main'), []);
  assert.equal(measures_of(kShoot), 'Order 1, 3 m long, 2 m from its base');
  assert.deepEqual(place_of(kShoot), [2, 0, 0]);
  assert.deepEqual(
    [1, -1, 9, -Infinity].map((by) => moved_metamer(kShoot, by)),
    [3, 1, 3, 0],
  );
});

const kShoot = {
  component: 'pear',
  shoot: 'main.4',
  tree: 1,
  metamer: 2,
  iteration: 9,
  metamers: [0, 1, 2, 3],
  course: [0, 0, 0, 1, 0, 0, 2, 0, 0, 3, 0, 0],
} as unknown as FoundShoot;

test('a shoot is cut, bent, tied and marked after the year on show', () => {
  assert.deepEqual(operation_of(kShoot, kFirstChoice, 1), { do: 'cut', at: 9, shoots: 'main.4', above: 2 });
  assert.deepEqual(operation_of(kShoot, { ...kFirstChoice, cut_at: 'base', season: 'summer' }, 2), {
    do: 'cut',
    at: 9,
    season: 'summer',
    shoots: 'main.4',
    tree: 1,
    above: 0,
  });
  assert.deepEqual(operation_of(kShoot, { ...kFirstChoice, action: 'bend', inclination: -20 }, 1), {
    do: 'bend',
    at: 9,
    shoots: 'main.4',
    below: 2,
    metamers: 3,
    inclination: -20,
  });
  assert.deepEqual(operation_of(kShoot, { ...kFirstChoice, action: 'tie' }, 1), {
    do: 'tie',
    at: 9,
    shoots: 'main.4',
    below: 2,
    anchor: 'ground',
    length: 0.5,
  });
  assert.deepEqual(operation_of(kShoot, { ...kFirstChoice, action: 'mark', state: 'dead' }, 1), {
    do: 'mark',
    at: 9,
    shoots: 'main.4',
    state: 'dead',
  });
  assert.notEqual(why_not({ ...kShoot, shoot: 'main' }, { ...kFirstChoice, cut_at: 'base' }), '');
  assert.equal(kept_metamers(kShoot, { ...kFirstChoice, cut_at: 'count', count: 1 }), 1);
  assert.deepEqual(parts_of(kShoot, 2), { stays: [0, 0, 0, 1, 0, 0, 2, 0, 0], goes: [2, 0, 0, 3, 0, 0] });
  assert.deepEqual(parts_of(kShoot, 9).goes, [3, 0, 0]);
});

test('operations are told in words, and by years', () => {
  assert.equal(what_of({ do: 'cut', at: 8, shoots: 'leader', above: 7 }), 'cut leader, above 7');
  assert.equal(
    what_of({
      do: 'cut',
      outside: {
        box: [
          [0, 0, 0],
          [1, 1, 1],
        ],
      },
    }),
    'cut, outside box',
  );
  assert.equal(
    what_of({
      do: 'support',
      line: [
        [0, 0, 0],
        [0, 2, 0],
      ],
      weight: 6,
    }),
    'support, line of 2 points, weight 6',
  );
  assert.deepEqual(
    [counted_act(1, 'cut'), counted_act(4, 'disbud'), counted_act(2, 'graft')],
    ['1 cut', '4 buds off', '2 graft'],
  );
  assert.equal(when_of({ do: 'cut', at: 8, season: 'summer' }), 'year 8, summer');
  assert.equal(when_of({ do: 'spur' }), 'every year');
  assert.equal(when_of({ do: 'spur', from: 3, every: 2, to: 9, once: true }), 'years 3 to 9, every 2, once');
  const acts: OperationAct[] = [
    ['c.operations[1]', 8, 'cut', 2],
    ['c.operations[0]', 8, 'cut', 1],
    ['c.training', 7, 'bend', 4],
  ];
  assert.equal(times_of(acts, 'c.operations[1]'), 2);
  const years = years_of(acts, [{ do: 'cut' }, { do: 'cut', season: 'summer' }], 'c.operations');
  assert.deepEqual(
    years.map(({ year, seasons }) => [year, seasons.map(({ season, entries }) => [season, entries.length])]),
    [
      [7, [['winter', 1]]],
      [
        8,
        [
          ['summer', 1],
          ['winter', 1],
        ],
      ],
    ],
  );
  assert.equal(text_with_off('[{"do": "cut"}]', 1, false), '[{"off": true, "do": "cut"}]');
});

/// Returns a page that answers questions for an instance when the test tells it to.
function asked_page(): {
  page: Page;
  grow: () => void;
  answer: (shoot: string | null, iteration: number) => Promise<void>;
} {
  const growth = new Store(kNoGrowth);
  const waiting: ((answer: object) => void)[] = [];
  const request = (): Promise<object> => new Promise((done) => waiting.push(done));
  const page = {
    growth,
    chosen: new Store('components.tree'),
    choose: () => undefined,
    connection: { request },
  } as unknown as Page;
  const answer = async (shoot: string | null, iteration: number): Promise<void> => {
    const instance =
      shoot === null
        ? null
        : { component: 'tree', shoot, tree: 0, metamer: 1, course: [0, 0, 0], metamers: [1], iteration };
    waiting.shift()?.({ instance });
    await new Promise((done) => setTimeout(done, 40));
  };
  return { page, answer, grow: () => growth.merge({ grown: { dragged: false } as never }) };
}

test('a chosen shoot is one of the growth on show, or let go', async () => {
  const { page, grow, answer } = asked_page();
  const choice = new InstanceChoice(page);
  choice.choose({ component: 'tree', frame: [], position: [0, 1, 0] });
  await answer('main.2', 8);
  assert.equal(choice.found.get()?.iteration, 8);
  grow();
  await answer('main.2', 9);
  assert.equal(choice.found.get()?.iteration, 9);
  grow();
  await answer(null, 10);
  assert.equal(choice.found.get(), null);
  assert.equal(choice.seen.get(), null);
});

test('a shoot is held by its name, and its place moves while the server is asked', async () => {
  const { page, grow, answer } = asked_page();
  const choice = new InstanceChoice(page);
  const held = choice.hold('tree', null);
  await answer('main', 8);
  assert.equal(await held, true);
  grow();
  const found = choice.found.get();
  assert.ok(found);
  choice.found.set({ ...found, metamer: 5 });
  await answer('main', 9);
  await answer('main', 10); // asked again, at the place where it is now
  assert.equal(choice.found.get()?.iteration, 10);
  const nobody = choice.hold('tree', null, 'child');
  await answer(null, 10);
  assert.equal(await nobody, false);
  assert.equal(choice.found.get()?.shoot, 'main');
});

test('an answer for a shoot that was let go meanwhile counts no more', async () => {
  const { page, answer } = asked_page();
  const choice = new InstanceChoice(page);
  choice.choose({ component: 'tree', frame: [], position: [0, 1, 0] });
  choice.forget();
  await answer('main.2', 8);
  assert.equal(choice.found.get(), null);
});
