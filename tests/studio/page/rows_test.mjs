// SPDX-License-Identifier: Apache-2.0
// Every kind of row of every component type, of links and of the document's parts is set with mouse and keyboard and
// read back by `meristem check`.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';

import { check_saved, chosen_rows, put_documents, set_rows } from './every_row.mjs';
import { open_file } from './hands.mjs';
import { kKinds, said_in, same } from './row_hands.mjs';
import { meristem, open_page, start_browser, start_server, temporary_folder } from './support.mjs';

let place, server, browser, page, tables, documents;

before(async () => {
  place = await temporary_folder();
  documents = await put_documents(place.folder);
  tables = JSON.parse((await meristem('components', '--json')).stdout);
  server = await start_server(place.folder, 'rows/leaf.json');
  browser = await start_browser();
  page = await open_page(await browser.newContext({ viewport: { width: 1280, height: 1600 } }), server.address);
});

after(async () => {
  await browser?.close();
  await server?.stop();
  await place?.remove();
});

/// Kinds of rows that the tables have, wherever they stand.
const kinds_of_tables = () => new Set(Object.values(tables.tables).flatMap((table) => table.rows.map((one) => one.kind)));

test('each kind is set for each component type, link and part of the document', async () => {
  assert.deepEqual([...kinds_of_tables()].filter((kind) => !kKinds.includes(kind)), []);
  const rows = chosen_rows(documents, tables);
  const owners = new Set(rows.map((one) => one.subject.owner));
  for (const type of Object.keys(tables.components)) assert.ok(owners.has(type), `no document of tests/rows is about ${type}`);
  for (const part of ['scene', 'output', 'limits', 'document', 'link branch', 'link crown']) assert.ok(owners.has(part), part);
  const told = { faults: [], kinds: new Set() };
  for (const document of documents) {
    const own = rows.filter((one) => one.document === document);
    if (own.length === 0) continue;
    await open_file(page, document.name);
    const { kinds, faults } = await set_rows(page, own, tables);
    for (const kind of kinds) told.kinds.add(kind);
    told.faults.push(...faults.map((one) => `${document.name}: ${one}`));
    if (faults.length > 0) continue;
    const said = await said_in(page);
    if (!same(said, document.said)) told.faults.push(`${document.name} says ${JSON.stringify(said)}\n in place of ${JSON.stringify(document.said)}`);
    const check = await check_saved(page, place.folder, document.name);
    if (check.code !== 0) told.faults.push(`${document.name}: ${check.stderr}${check.stdout}`);
  }
  assert.deepEqual(told.faults, []);
  assert.deepEqual([...told.kinds].sort(), [...kinds_of_tables()].sort());
});
