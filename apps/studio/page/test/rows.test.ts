// SPDX-License-Identifier: Apache-2.0
// Rows of the inspector: typed values and pressed buttons.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { next_position } from '../src/editors/next_position.ts';
import { entry_of, entry_text } from '../src/editors/selection_text.ts';
import { LatestSender } from '../src/server/latest_sender.ts';
import { chosen_with, groups_at } from '../src/tables/resolve.ts';
import type { Tables } from '../src/tables/tables.ts';
import { completions } from '../src/text/completion.ts';

test('selections: numbers, ranges and conditions, typed as people write them', () => {
  assert.equal(entry_of(' 7 '), 7);
  for (const range of ['3 to 5', '3-5', '3–5', '3..5', '3 ... 5', '5 to 3'])
    assert.deepEqual(entry_of(range), [3, 5], range);
  for (const condition of ['i % 10 == 9', 'u > 0.5', '7 == i', 'i - 3 < 5'])
    assert.equal(entry_of(condition), condition);
  assert.equal(entry_of('  '), null);
});

test('selections: what is shown is read back as what it is', () => {
  for (const entry of [0, [3, 5], 'i % 4 == 2'] as const) assert.deepEqual(entry_of(entry_text(entry as never)), entry);
});

test('positions: the next goes on as the last ones do', () => {
  assert.deepEqual(next_position([]), [0, 1, 0]);
  assert.deepEqual(next_position([[0, 0, 0]]), [1, 0, 0]);
  assert.deepEqual(
    next_position([
      [0, 0, 0],
      [3, 0.1, -1],
    ]),
    [6, 0.2, -2],
  );
  assert.deepEqual(
    next_position([
      [1, 0, 0],
      [1, 0, 0],
    ]),
    [2, 0, 0],
  );
  assert.deepEqual(
    next_position([
      [0, 0, 0],
      ['size', 0, 0],
    ]),
    [0, 1, 0],
  );
});

test('drags: while one is answered, only the newest of those that came is sent', async () => {
  let newest = 0;
  const sent: number[] = [];
  let answer = (): void => undefined;
  const sender = new LatestSender(() => {
    sent.push(newest);
    return new Promise<void>((done) => (answer = done));
  });
  for (newest = 1; newest < 9; newest += 1) sender.ask();
  answer();
  await new Promise((done) => setTimeout(done, 60));
  answer();
  await new Promise((done) => setTimeout(done, 60));
  assert.deepEqual(sent, [1, 9]);
  sender.ask();
  sender.drop();
  await new Promise((done) => setTimeout(done, 60));
  assert.equal(sent.length, 3);
});

test('names at the top of documents: each is offered, and what is one part is chosen as one', () => {
  const row = (name: string, table?: string): object => ({
    name,
    kind: table ? 'object' : 'text',
    doc: '',
    ...(table ? { table } : {}),
  });
  const tables = {
    document: 'document',
    animation: 'animation',
    limits: 'limits',
    components: {},
    tables: {
      document: { rows: [row('seed'), row('scene', 'scene'), row('output', 'output')] },
      scene: { rows: [] },
      animation: { rows: [row('length')] },
      limits: { rows: [] },
    },
  } as unknown as Tables;
  const offered = completions(tables, null, '{"limits": {}, "', 16).options.map((one) => one.label);
  assert.deepEqual(offered, ['"seed"', '"scene"', '"output"', '"variables"', '"components"', '"links"', '"animation"']);
  const chosen = [
    'seed',
    'scene.sun',
    'output',
    'animation.keys',
    'limits',
    'links[2].kind',
    'links',
    'components.leaf.length',
    'components["a.b"]',
    'variables.size',
  ];
  assert.deepEqual(
    chosen.map((path) => chosen_with(tables, path)),
    [null, 'scene', 'output', 'animation', 'limits', 'links[2]', null, 'components.leaf', 'components["a.b"]', null],
  );
  assert.deepEqual(
    groups_at(tables, null, 'animation').map((one) => one.title),
    ['Animation'],
  );
});
