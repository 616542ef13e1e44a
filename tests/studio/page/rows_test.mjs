// SPDX-License-Identifier: Apache-2.0
// Every kind of row of every component type, of links and of the document's parts is set with mouse and keyboard and
// read back by `meristem check`.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';

import { check_saved, chosen_rows, open_document, owners_of, put_documents, set_rows } from './every_row.mjs';
import { kKinds, said_in, same } from './row_hands.mjs';
import { meristem, open_page, start_browser, start_server, temporary_folder } from './support.mjs';

let place, server, browser, page, tables, documents;

before(async () => {
  place = await temporary_folder();
  documents = await put_documents(place.folder);
  tables = JSON.parse((await meristem('components', '--json')).stdout);
  server = await start_server(place.folder, 'rows/leaf.json');
  browser = await start_browser();
  page = await open_page(await browser.newContext({ viewport: { width: 900, height: 1400 } }), server.address);
  // Documents are read and checked while no plant grows.
  await page.getByRole('button', { name: 'Pause growing' }).click();
});

after(async () => {
  await browser?.close();
  await server?.stop();
  await place?.remove();
});

/// The kinds of a table's own rows. The ends of a link are required and cannot be removed.
const kinds_of = (table) =>
  new Set(table.rows.filter((one) => !['from', 'to'].includes(one.name)).map((one) => one.kind));

/// Sets the rows of these owners and kinds by mouse and keyboard, and one row of each other kind.
async function set_by_hand(wanted) {
  const all = new Set(Object.values(tables.tables).flatMap((table) => [...kinds_of(table)]));
  assert.deepEqual([...all].sort(), [...kKinds].sort());
  const rows = chosen_rows(documents, tables, wanted);
  const keys = new Set(rows.map((one) => one.key));
  assert.deepEqual(
    wanted.filter((key) => !keys.has(key)),
    [],
    'no document gives these',
  );
  const told = { faults: [], kinds: new Set() };
  for (const document of documents) {
    const own = rows.filter((one) => one.document === document);
    if (own.length === 0) continue;
    await open_document(page, document.name);
    const { kinds, faults } = await set_rows(page, own, tables);
    for (const kind of kinds) told.kinds.add(kind);
    told.faults.push(...faults.map((one) => `${document.name}: ${one}`));
    if (faults.length > 0) continue;
    const said = await said_in(page);
    if (!same(said, document.said))
      told.faults.push(`${document.name} says ${JSON.stringify(said)}\n in place of ${JSON.stringify(document.said)}`);
    const check = await check_saved(page, place.folder, document.name);
    if (check.code !== 0) told.faults.push(`${document.name}: ${check.stderr}${check.stdout}`);
  }
  assert.deepEqual(told.faults, []);
  assert.deepEqual([...told.kinds].sort(), [...all].sort());
}

test('each kind is set', () => set_by_hand([]));

test('each kind is set for each component type, link and part of the document', () =>
  set_by_hand(
    Object.entries(owners_of(tables)).flatMap(([owner, table]) =>
      [...kinds_of(table)].map((kind) => `${owner}: ${kind}`),
    ),
  ));
