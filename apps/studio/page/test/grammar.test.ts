// SPDX-License-Identifier: Apache-2.0
// Grammars in documents: typed into their lines, faults found there, words by their modules.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { grammars_of } from '../src/grammar/derivation.ts';
import { nearest_place, place_of } from '../src/grammar/drawn_places.ts';
import { offset_in_text, text_in, with_text } from '../src/grammar/grammar_source.ts';
import { module_at, module_starts, short_module } from '../src/grammar/word_view.ts';
import type { Tables } from '../src/tables/tables.ts';
import { parse_json } from '../src/values/json.ts';
import { node_at } from '../src/values/path.ts';

const kDocument =
  '{"grammar": [\n    "#axiom", // where it begins\n    "A",\n    "#rules",\n    "A -> \\\\F"\n  ], "steps": 3}';

const node_in = (document: string): NonNullable<ReturnType<typeof node_at>> => {
  const node = node_at(parse_json(document), 'grammar');
  assert.ok(node);
  return node;
};
const typed = (document: string, text: string): string => with_text(document, node_in(document), text);
const said = (document: string): string | null => text_in(node_in(document));

test('grammars: lines are read as one text', () => {
  assert.equal(said(kDocument), '#axiom\nA\n#rules\nA -> \\F');
  assert.equal(said('{"grammar": "a\\nb"}'), 'a\nb');
  assert.equal(text_in(node_in('{"grammar": [1]}')), null);
});

test('grammars: only the lines that change are written, comments and layout stay', () => {
  const changed = typed(kDocument, '#axiom\nA(1)\n#rules\nA -> \\F');
  assert.equal(changed, kDocument.replace('"A",', '"A(1)",'));
  const added = typed(kDocument, '#axiom\nA\n#rules\nB -> "C"\nA -> \\F');
  assert.equal(added, kDocument.replace('"#rules",\n', '"#rules",\n    "B -> \\"C\\"",\n'));
  const behind = typed(kDocument, '#axiom\nA\n#rules\nA -> \\F\nF -> FF');
  assert.equal(behind, kDocument.replace('"A -> \\\\F"', '"A -> \\\\F",\n    "F -> FF"'));
  assert.equal(typed(kDocument, '#axiom\nA\n#rules'), kDocument.replace(',\n    "A -> \\\\F"', ''));
  assert.equal(typed(kDocument, 'A\n#rules\nA -> \\F'), kDocument.replace('"#axiom", // where it begins\n    ', ''));
});

test('grammars: whatever is typed is what is read', () => {
  let seed = 7;
  const random = (max: number): number => {
    seed = (seed * 1103515245 + 12345) % 2147483648;
    return seed % max;
  };
  for (const first of [
    kDocument,
    '{"grammar": []}',
    '{"grammar": "A"}',
    '{"grammar": ["a\\nb", "c"]}',
    '{"grammar":["x"]}',
  ]) {
    let document = first;
    for (let k = 0; k < 400; k += 1) {
      const text = said(document) ?? '';
      const at = random(text.length + 1);
      const cut = random(4) === 0 ? random(6) : 0;
      const put = ['', 'F', '\n', '"', '\\', '→\u{1f333}', 'A\nB\n', '\t'][random(8)] ?? '';
      const made = text.slice(0, at) + put + text.slice(at + cut);
      document = typed(document, made);
      assert.equal(said(document), made, document);
    }
  }
});

test('grammars: a place in the document is one in the text', () => {
  const node = node_in(kDocument);
  const text = text_in(node) ?? '';
  for (const word of ['A -> ', '#rules'])
    assert.equal(offset_in_text(kDocument, node, kDocument.indexOf(word)), text.indexOf(word));
  assert.equal(offset_in_text(kDocument, node, kDocument.indexOf('F"')), text.indexOf('F'));
  assert.equal(offset_in_text(kDocument, node, 0), null);
});

test('grammars: components with lines are found, in documents and files', () => {
  const tables = {
    components: { lsystem: { doc: '', table: 'an_lsystem' }, leaf: { doc: '', table: 'leaf' } },
    tables: {
      an_lsystem: { doc: '', rows: [{ name: 'grammar', kind: 'lines', doc: '' }] },
      leaf: { doc: '', rows: [] },
    },
  } as unknown as Tables;
  const found = grammars_of(
    {
      components: { a: { type: 'lsystem', grammar: ['F'] }, b: { type: 'leaf' }, c: { type: 'lsystem', file: 'x.l' } },
    },
    tables,
  );
  assert.deepEqual(found, [
    { component: 'a', path: 'components.a.grammar', is_file: false },
    { component: 'c', path: 'components.c.grammar', is_file: true },
  ]);
});

test('words: modules are found by where they stand', () => {
  const { text, starts } = module_starts(['F', '[', '+(30)', 'F', ']']);
  assert.equal(text, 'F[+(30)F]');
  assert.deepEqual(
    [0, 1, 2, 6, 7, 8, 9, -1].map((at) => module_at(starts, at)),
    [0, 1, 2, 2, 3, 4, null, null],
  );
  assert.equal(module_starts(['Leaf', 'F']).text, 'Leaf F');
  assert.equal(module_at(module_starts([]).starts, 0), null);
});

test('words: numbers are shown with the digits that a person reads', () => {
  assert.equal(short_module('F(0.22779067996569605,-12.3456789)'), 'F(0.2278,-12.35)');
  assert.equal(short_module('A(137.5,3)'), 'A(137.5,3)');
  assert.equal(short_module('+'), '+');
});

test('words: the module that is drawn nearest to the pointer', () => {
  const places = [2, 0, 0, 0, 0, 10, 0, 5, 0, 10, 0, 8, 10, 0];
  const flat = ([x, y]: [number, number, number]): [number, number] => [x, y];
  assert.equal(nearest_place(places, flat, [1, 5]), 2);
  assert.equal(nearest_place(places, flat, [6, 11]), 5);
  assert.equal(nearest_place(places, flat, [50, 50]), null);
  assert.equal(
    nearest_place(places, () => null, [1, 5]),
    null,
  );
  assert.deepEqual(place_of(places, 5), { from: [0, 10, 0], to: [8, 10, 0] });
  assert.equal(place_of(places, 3), null);
});
