// SPDX-License-Identifier: Apache-2.0
// Texts that the page reads itself: with a fault, and without a server.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { tree_of } from '../src/document/document_state.ts';
import { text_with_edits } from '../src/document/text_edits.ts';
import { variables_of_text } from '../src/document/text_variables.ts';
import { limits_of, with_legal_point } from '../src/editors/limits.ts';
import { shape_of } from '../src/editors/shape.ts';
import { node_at, value_at } from '../src/values/path.ts';

const kText = `// A bush.
{
  "meristem": 1,
  "variables": {
    "size": {"value": 0.1, "min": 0, "max": 1}, // long
    "count": 12,
    "angle": "size*40"
  },
  "components": {
    "leaf": {"type": "leaf", "length": "size", "colour": "#337722"}
  },
  "links": [["stem", "leaf"]]
}
`;

test('a text with one fault of its form gives its values with their places', () => {
  const good = tree_of(kText, null).tree;
  const faults: [string, string][] = [
    ['"count": 12,', '"count": 12'], // a comma is missing
    ['"count": 12,', '"count": 12,,'],
    ['"count": 12,', '"count": ,'],
    ['"#337722"}', '"#337722}'], // a quote is missing
    ['"#337722"}', '"#337722",}'],
    ['"leaf"]]', '"leaf"]'], // a bracket is missing
    ['"#337722"}', '"#337722"'],
    ['"links": [', '"links" ['],
  ];
  for (const [from, to] of faults) {
    const text = kText.replace(from, to);
    const { tree, tree_is } = tree_of(text, good);
    assert.equal(tree_is, 'mended', to);
    const node = node_at(tree, 'components.leaf.length');
    assert.equal(text.slice(node?.start, node?.end), '"size"', to);
    assert.equal(value_at(tree, 'variables.size.value'), 0.1, to);
  }
  assert.deepEqual(tree_of('{"meri', good), { tree: good, tree_is: 'old' });
  assert.equal(tree_of('[[[', good).tree_is, 'old');
});

test('edits are made in the text as it is written, and what cannot be made here is left to the server', () => {
  const made = (...edits: Parameters<typeof text_with_edits>[1][number][]): string | null =>
    text_with_edits(kText, edits);
  assert.equal(made({ set: 'size', value: 0.25 }), kText.replace('"value": 0.1', '"value": 0.25'));
  assert.equal(
    made({ set: 'count', value: 7 }, { set: 'leaf.colour', value: '#ff0000' }),
    kText.replace('12', '7').replace('#337722', '#ff0000'),
  );
  assert.equal(made({ set: 'leaf.width', value: 2 }), kText.replace('"#337722"', '"#337722", "width": 2'));
  assert.equal(made({ set: 'variables.more', value: 1 }), kText.replace('"size*40"', '"size*40",\n    "more": 1'));
  assert.equal(made({ unset: 'leaf.colour' }), kText.replace(', "colour": "#337722"', ''));
  assert.equal(made({ unset: 'leaf.type' }), kText.replace('"type": "leaf", ', ''));
  assert.equal(made({ unset: 'leaf.width' }), kText);
  assert.equal(made({ set: 'links[0][1]', value: 'stem' }), kText.replace('"leaf"]]', '"stem"]]'));
  assert.equal(made({ remove: 'components.leaf' }), null);
  assert.equal(made({ set: 'nothing.there', value: 1 }), null);
  const broken = kText.replace('12,', '12');
  assert.equal(text_with_edits(broken, [{ set: 'size', value: 0.25 }]), broken.replace('0.1', '0.25'));
});

test('handles have the values of the text where the server has read none', () => {
  const known = [
    { name: 'angle', value: 4, min: 0, max: 90, unit: 'deg', doc: 'Steep.', expression: 'size*40', private: false },
  ];
  const [size, count, angle] = variables_of_text(known, tree_of(kText, null).tree);
  assert.deepEqual(size, {
    name: 'size',
    value: 0.1,
    min: 0,
    max: 1,
    unit: '',
    doc: '',
    expression: null,
    private: false,
  });
  assert.deepEqual([count?.value, count?.min, count?.max], [12, 0, 12]);
  assert.deepEqual(angle, { ...known[0], min: 0, max: 90 });
});

test('a point of a curve stays within the range of its row', () => {
  const shape = shape_of({
    curve: [
      [0, 0],
      [0.5, 1],
      [1, 0],
    ],
  });
  assert.ok(shape);
  const limits = limits_of({ min: 0, max: 1 }, shape.form);
  const moved = with_legal_point(
    {
      ...shape,
      points: [
        [0, 0],
        [0.5, 1.445],
        [1, 0],
      ],
    },
    1,
    limits,
  );
  assert.deepEqual(moved.points[1], [0.5, 1]);
  assert.deepEqual(
    with_legal_point(
      {
        ...shape,
        points: [
          [0, -0.2],
          [1, 0],
        ],
      },
      0,
      limits,
    ).points[0],
    [0, 0],
  );
  assert.deepEqual(limits_of({ min: -2, max: 2 }, 'silhouette').x, { low: 0, high: 2 });
});
