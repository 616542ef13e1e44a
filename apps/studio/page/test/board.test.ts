// SPDX-License-Identifier: Apache-2.0
// The p-graph in the page: recursions, levels, order, and the edits of actions on the board.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import {
  add_edits,
  copied_link,
  free_name,
  hang_edits,
  kind_edits,
  link_edit,
  order_edits,
  place_behind,
  place_of_link,
  remove_alone_edits,
  remove_edits,
} from '../src/board/board_edits.ts';
import { lay_out } from '../src/board/board_layout.ts';
import { edge_above, fitting_direction, neighbour } from '../src/board/board_places.ts';
import type { GraphLink, PlantGraph } from '../src/board/plant_graph.ts';
import { graph_of, held_by, refusal_of_link, way_between } from '../src/board/plant_graph.ts';
import type { Json } from '../src/values/json.ts';

const kTypes = {
  camera: { doc: '', table: 'camera', is_camera: true },
  tree: { doc: '', table: 'tree', makes_stems: true },
  leaf: { doc: '', table: 'leaf' },
};

function plant(ids: string, links: Json[]): Json {
  const components = Object.fromEntries(ids.split(' ').map((id) => [id, { type: id === 'view' ? 'camera' : 'tree' }]));
  return { components, links };
}
const graph = (ids: string, links: Json[], implied: { from: string; to: string }[] = []): PlantGraph =>
  graph_of(plant(ids, links), kTypes, implied);
const across = (of: PlantGraph, id: string): number => lay_out(of).nodes.find((one) => one.key === id)?.across ?? NaN;

test('children stand in the order of the links, and parents above them', () => {
  const flower = graph('view stem leaf bud', [
    ['view', 'stem'],
    ['stem', 'bud'],
    ['stem', 'leaf'],
  ]);
  const { nodes, levels } = lay_out(flower);
  assert.deepEqual(
    nodes.map((one) => [one.key, one.level]),
    [
      ['view', 0],
      ['stem', 1],
      ['bud', 2],
      ['leaf', 2],
    ],
  );
  assert.equal(levels, 3);
  assert.ok(across(flower, 'bud') < across(flower, 'leaf'));
  assert.equal(across(flower, 'stem'), (across(flower, 'bud') + across(flower, 'leaf')) / 2);
});

test('no two nodes of a level stand nearer than neighbours', () => {
  let chance = 7;
  const next = (below: number): number => {
    chance = (chance * 16807) % 2147483647;
    return chance % below;
  };
  for (let round = 0; round < 30; round += 1) {
    const ids = Array.from({ length: 40 }, (_, k) => `c${k}`);
    const links = ids.slice(1).map((id, k): Json => [`c${next(k + 1)}`, id]);
    const { nodes, breadth } = lay_out(graph(ids.join(' '), links));
    for (const a of nodes) {
      assert.ok(a.across >= 0.5 - 1e-9 && a.across <= breadth - 0.5 + 1e-9);
      for (const b of nodes) if (a !== b && a.level === b.level) assert.ok(Math.abs(a.across - b.across) > 1 - 1e-9);
    }
  }
});

test('a recursion shows its first component at both ends, with doubled lines between', () => {
  const { nodes, edges } = lay_out(
    graph('A B C D E', [['A', 'B'], ['B', 'C'], ['C', 'D'], ['D', 'B'], { from: 'D', to: 'E', kind: 'leaf' }]),
  );
  const end = nodes.filter((one) => one.is_end);
  assert.deepEqual(
    end.map((one) => [one.id, one.parent]),
    [['B', 'D']],
  );
  const doubled = edges.filter((one) => one.is_doubled).map((one) => `${one.link.from}${one.link.to}`);
  assert.deepEqual(doubled.sort(), ['BC', 'CD', 'DB']);
  assert.equal(edges.find((one) => one.link.to === 'E')?.link.kind, 'leaf');
});

test('a component with two parents stands once, under the deeper one; all its links are drawn', () => {
  const { nodes, edges } = lay_out(
    graph('A B C D', [
      ['A', 'D'],
      ['A', 'B'],
      ['B', 'C'],
      ['C', 'D'],
    ]),
  );
  const shared = nodes.filter((one) => one.id === 'D');
  assert.deepEqual(
    shared.map((one) => [one.parent, one.level]),
    [['C', 4]],
  );
  assert.equal(edges.filter((one) => one.to === 'D').length, 2);
});

test('without a camera one is added that links to all that nothing links to', () => {
  const two = graph('a b c', [['b', 'c']]);
  assert.deepEqual(two.roots, ['camera']);
  assert.deepEqual(
    two.links.filter((one) => one.from === 'camera').map((one) => one.to),
    ['a', 'b'],
  );
  assert.deepEqual(
    graph('a b', [
      ['a', 'b'],
      ['b', 'a'],
    ])
      .links.filter((one) => one.from === 'camera')
      .map((one) => one.to),
    ['a'],
  );
  assert.deepEqual(graph('view a', []).roots, ['view', 'a']);
});

test('what a grammar places is drawn too', () => {
  const placed = graph('view plant leaf', [['view', 'plant']], [{ from: 'plant', to: 'leaf' }]);
  assert.deepEqual(
    placed.links.map((one) => [one.to, one.kind, one.index]),
    [
      ['plant', 'child', 0],
      ['leaf', 'placed', null],
    ],
  );
});

test('folding hides what stands below and says how much', () => {
  const { nodes } = lay_out(
    graph('A B C D', [
      ['A', 'B'],
      ['B', 'C'],
      ['B', 'D'],
    ]),
    new Set(['B']),
  );
  assert.deepEqual(
    nodes.map((one) => [one.key, one.hides]),
    [
      ['camera', 0],
      ['A', 0],
      ['B', 2],
    ],
  );
});

test('links that cannot be are refused with the reason', () => {
  const chain = graph('view a b c', [
    ['view', 'a'],
    ['a', 'b'],
    ['b', 'c'],
  ]);
  const once = (): number => 1;
  assert.match(
    refusal_of_link(chain, 'c', 'a', once) ?? '',
    /a > b > c > a would form an endless circle. A recursion of at least 2 in a/,
  );
  assert.match(refusal_of_link(chain, 'b', 'b', once) ?? '', /b > b would/);
  assert.match(refusal_of_link(chain, 'a', 'view', once) ?? '', /camera/);
  assert.match(refusal_of_link(chain, 'a', 'b', once) ?? '', /already/);
  assert.equal(refusal_of_link(chain, 'a', 'c', once), null);
  assert.equal(
    refusal_of_link(chain, 'c', 'a', () => 2),
    null,
  );
  assert.deepEqual(way_between(chain, 'view', 'c'), ['view', 'a', 'b', 'c']);
});

test('new things are written where a person would look for them', () => {
  const links: Json[] = [
    ['view', 'stem'],
    ['stem', 'leaf'],
    ['view', 'pot'],
  ];
  const document = plant('view stem leaf pot', links);
  const of = graph_of(document, kTypes);
  assert.equal(place_behind(document, of, 'stem'), 3);
  assert.equal(place_behind(document, of, null), 4);
  assert.equal(place_of_link(document, 'stem'), 2);
  assert.equal(place_of_link(document, 'leaf'), 2);
  assert.equal(place_of_link(document, 'nobody'), 3);
  assert.deepEqual(add_edits(document, of, 'bud', { type: 'leaf' }, 'stem', 'branch'), [
    { insert: 'components.bud', value: { type: 'leaf' }, index: 3 },
    { insert: 'links[2]', value: { from: 'stem', to: 'bud', kind: 'branch' } },
  ]);
  assert.deepEqual(link_edit(document, 'pot', 'leaf', 'child'), { insert: 'links[3]', value: ['pot', 'leaf'] });
  assert.equal(free_name('leaf', of.components), 'leaf_2');
  assert.equal(free_name('leaf_2', new Set(['leaf', 'leaf_2'])), 'leaf_3');
});

test('deleting takes what stands on nothing else, or hangs it on the parents', () => {
  const links: Json[] = [
    ['view', 'a'],
    ['a', 'b'],
    ['b', 'c'],
    ['view', 'd'],
    ['d', 'c'],
  ];
  const document = plant('view a b c d', links);
  const of = graph_of(document, kTypes);
  assert.deepEqual([...held_by(of, 'a')].sort(), ['a', 'b']);
  assert.deepEqual(remove_edits(of, held_by(of, 'a'), { b: 'a note' }), [
    { note: 'components.b', text: '' },
    { remove: 'components.b' },
    { remove: 'components.a' },
  ]);
  assert.deepEqual(remove_alone_edits(document, of, 'a', {}), [
    { insert: 'links[1]', value: ['view', 'b'] },
    { remove: 'components.a' },
  ]);
});

test('links change their kind, order and ends', () => {
  const links: Json[] = [['view', 'a'], { from: 'view', to: 'b', kind: 'branch', count: 4 }, ['view', 'c']];
  const document = plant('view a b c', links);
  const of = graph_of(document, kTypes);
  const link = (to: string): GraphLink => {
    const found = of.links.find((one) => one.to === to);
    assert.ok(found, `there is no link to ${to}`);
    return found;
  };
  assert.deepEqual(kind_edits(document, link('a'), 'leaf'), [
    { set: 'links[0]', value: { from: 'view', to: 'a', kind: 'leaf' } },
  ]);
  assert.deepEqual(kind_edits(document, link('b'), 'child'), [{ set: 'links[1]', value: ['view', 'b'] }]);
  assert.deepEqual(kind_edits(document, link('b'), 'crown'), [
    { unset: 'links[1].count' },
    { set: 'links[1].kind', value: 'crown' },
  ]);
  assert.deepEqual(order_edits(of, link('c'), 0), [{ move: 'links[2]', index: 0 }]);
  assert.deepEqual(order_edits(of, link('c'), 9), []);
  assert.deepEqual(hang_edits(document, link('b'), 'a'), [{ set: 'links[1].from', value: 'a' }]);
  assert.deepEqual(hang_edits(document, link('c'), 'a'), [{ set: 'links[2][0]', value: 'a' }]);
  assert.deepEqual(copied_link(document, link('b'), 'd'), [
    { insert: 'links[2]', value: { from: 'view', to: 'd', kind: 'branch', count: 4 } },
  ]);
});

test('arrow keys go up, down and along a level', () => {
  const layout = lay_out(
    graph('view a b c', [
      ['view', 'a'],
      ['view', 'b'],
      ['b', 'c'],
    ]),
  );
  assert.equal(neighbour(layout, 'c', 'up')?.key, 'b');
  assert.equal(neighbour(layout, 'view', 'down')?.key, 'a');
  assert.equal(neighbour(layout, 'a', 'behind')?.key, 'b');
  assert.equal(neighbour(layout, 'a', 'before'), undefined);
  assert.equal(edge_above(layout, 'c')?.link.from, 'b');
});

test('the board lies in the direction in which it is larger', () => {
  const flat = lay_out(
    graph(
      `view ${'abcdefghijklmnop'.split('').join(' ')}`,
      'abcdefghijklmnop'.split('').map((id): Json => ['view', id]),
    ),
  );
  assert.equal(fitting_direction(flat, 460, 500), 'right');
  assert.equal(
    fitting_direction(
      lay_out(
        graph('view a b c d', [
          ['view', 'a'],
          ['a', 'b'],
          ['b', 'c'],
          ['c', 'd'],
        ]),
      ),
      460,
      500,
    ),
    'down',
  );
});
