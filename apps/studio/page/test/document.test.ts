// SPDX-License-Identifier: Apache-2.0
// Edits of the open document when another document is opened.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { DocumentModel } from '../src/document/document_model.ts';
import { kDropped } from '../src/document/edit_queue.ts';
import { text_hash } from '../src/document/hash.ts';
import type { Connection } from '../src/server/connection.ts';
import type { OpenAnswer } from '../src/server/protocol.ts';

function opened(text: string): OpenAnswer {
  return {
    path: 'a.json',
    model: null,
    name: 'a',
    text,
    hash: text_hash(text),
    saved: null,
    good: true,
    faults: [],
    tree: {},
    variables: [],
    implied: [],
    notes: {},
  };
}

test('an edit that another document overtakes is dropped, whether it is on its way or waits', async () => {
  const answers: ((answer: object) => void)[] = [];
  const connection = {
    is_open: true,
    request: () => new Promise((done) => answers.push(done)),
  } as unknown as Connection;
  const document = new DocumentModel(
    () => connection,
    () => '',
    () => undefined,
  );
  document.take_opened(opened('{"a": 1}'));
  const edits = ['a', 'b'].map((path) => document.edit([{ set: path, value: 2 }], 'Set'));
  document.take_opened(opened('{"c": 1}'));
  answers[0]?.({ ...opened('{"a": 2}'), patch: [], inverse: [] });
  // The callers learn that their edits were not made, and choose nothing in the other document.
  assert.deepEqual(await Promise.all(edits), [kDropped, kDropped]);
  assert.equal(document.state.get().text, '{"c": 1}');
  assert.equal(answers.length, 1);
});
