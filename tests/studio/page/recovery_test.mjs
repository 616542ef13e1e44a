// SPDX-License-Identifier: Apache-2.0
// Work is never lost: edits without a server, several tabs, reloads, faulty texts and files that are not text.
import assert from 'node:assert/strict';
import { writeFile } from 'node:fs/promises';
import path from 'node:path';
import process from 'node:process';
import { after, before, test } from 'node:test';

import { drag, field, leave_fields, open_file, retype, row, slider, type_into } from './hands.mjs';
import {
  kept,
  open_page,
  ready,
  settled,
  start_browser,
  start_server,
  temporary_folder,
  text_of,
  write_document,
} from './support.mjs';

const kBush = `// A bush.
{
  "meristem": 1,
  "name": "Bush",
  "variables": {
    "size": {"value": 0.12, "min": 0.05, "max": 0.25},
    "bend": {"value": 30, "min": 0, "max": 90}
  },
  "components": {
    "stem": {"type": "tree", "length": 1.5, "radius": 0.02},
    "leaf": {"type": "leaf", "length": "size", "width": "size/2", "curl": "bend", "outline": {"curve": [[0, 0.1], [0.5, 1], [1, 0]]}}
  },
  "links": [{"from": "stem", "to": "leaf", "kind": "branch", "count": 12, "angle": 60}]
}
`;

let place, server, browser, context, page;
const pictures = process.env.MERISTEM_PICTURES; // a folder for pictures of what was tried
const picture = async (of, name) => pictures && of.screenshot({ path: path.join(pictures, `${name}.png`) });
const banner = (of, name) => of.locator(`[data-banner="${name}"]`);

before(async () => {
  place = await temporary_folder();
  await write_document(place.folder, 'bush.json', kBush);
  server = await start_server(place.folder, path.join(place.folder, 'bush.json'), '--port', '0');
  browser = await start_browser();
  context = await browser.newContext({
    viewport: { width: 1280, height: 720 },
    ...(pictures ? { deviceScaleFactor: 1 } : {}),
  });
  page = await open_page(context, server.address);
});

after(async () => {
  await browser?.close();
  await server?.stop();
  await place?.remove();
});

test('edits without a server are kept, and given back to another tab of the next server', async () => {
  const { port } = new URL(server.address);
  process.kill(server.pid, 'SIGKILL');
  await banner(page, 'lost').waitFor();
  await type_into(page, field(page, 'bend'), '71');
  await drag(page, slider(page, 'size'), [60, 0], { across: 0.3 });
  // Only the library can add a component: this waits for it.
  await page.evaluate(
    () =>
      void window.studio.edit([{ insert: 'components.thorn', value: { type: 'leaf', length: 0.05 } }], 'Add a thorn'),
  );
  assert.match(await text_of(page), /"bend": \{"value": 71,/);
  assert.equal(await field(page, 'bend').inputValue(), '71');
  await picture(page, 'lost');
  await kept(page);
  const text = await text_of(page);
  assert.notEqual(text, kBush.replace('"value": 30', '"value": 71'), 'the slider has changed the text, too');

  await server.stop();
  server = await start_server(place.folder, path.join(place.folder, 'bush.json'), '--port', port);
  const [gone, next] = [page, await open_page(context, server.address)];
  page = next;
  await banner(next, 'kept').waitFor();
  await picture(next, 'kept');
  assert.match(await banner(next, 'kept').innerText(), /1 edit waits/);
  await banner(next, 'kept').getByRole('button', { name: 'Restore' }).click();
  await next.waitForFunction(() => window.studio.document.state.get().text.includes('thorn'));
  const restored = await text_of(next);
  assert.match(restored, /"bend": \{"value": 71,/);
  assert.equal(/"size": \{"value": ([\d.]+)/.exec(restored)[1], /"size": \{"value": ([\d.]+)/.exec(text)[1]);
  // The work of the previous tab is offered only once.
  await kept(next);
  assert.equal(
    await next.evaluate(
      async () =>
        (
          await new Promise((done) => {
            const asked = indexedDB.open('meristem-studio');
            asked.onsuccess = () => {
              const all = asked.result.transaction('slots').objectStore('slots').getAll();
              all.onsuccess = () => done(all.result);
            };
          })
        ).length,
    ),
    1,
  );
  await gone.close();
});

test('a second tab with the same file is announced, and each keeps its own work over a reload', async () => {
  await open_file(page, 'bush.json');
  const other = await open_page(context, server.address);
  await banner(other, 'elsewhere').waitFor();
  await banner(page, 'elsewhere').waitFor();
  await picture(other, 'elsewhere');
  assert.equal(await banner(other, 'kept').count(), 0);
  await type_into(page, field(page, 'bend'), '41');
  await type_into(other, field(other, 'bend'), '42');
  for (const one of [page, other]) await kept(one);
  for (const one of [page, other]) {
    const text = await text_of(one);
    await one.reload();
    await ready(one);
    await banner(one, 'kept').getByRole('button', { name: 'Restore' }).click();
    await settled(one);
    assert.equal(await text_of(one), text);
  }
  await other.close();
  await banner(page, 'elsewhere').waitFor({ state: 'detached' });
});

test('saving under a new name, editing and saving again writes what the page shows; a reload opens that file', async () => {
  await open_file(page, 'bush.json');
  const { readFile } = await import('node:fs/promises');
  const on_disk = () => readFile(path.join(place.folder, 'mine.json'), 'utf8');
  await page.evaluate(() => window.studio.save('mine.json'));
  assert.equal(await on_disk(), kBush);
  await type_into(page, field(page, 'bend'), '51');
  await settled(page);
  await page.keyboard.press('Control+s');
  await page.waitForFunction(() => !window.studio.document.is_changed);
  assert.equal(await on_disk(), await text_of(page));
  assert.match(await on_disk(), /"value": 51/);
  await page.reload();
  await ready(page);
  assert.equal(await page.evaluate(() => window.studio.document.state.get().path), 'mine.json');
});

test('a file that is not UTF-8 says line and byte in the dialog, and the connection stays', async () => {
  await writeFile(path.join(place.folder, 'latin.json'), Buffer.from(kBush.replace('"Bush"', '"B\xfcsche"'), 'latin1'));
  await page.getByRole('button', { name: 'Open a file' }).click();
  await page.getByRole('dialog').locator('.file', { hasText: 'latin.json' }).click();
  const fault = page.getByRole('dialog').getByRole('alert');
  await fault.waitFor();
  assert.match(await fault.innerText(), /byte 0xfc in line 4 \(byte \d+ of the file\) is not UTF-8/);
  await picture(page, 'latin');
  await page.keyboard.press('Escape');
  assert.equal(await page.evaluate(() => window.studio.server.get().link), 'open');
});

for (const [what, from, to] of [
  ['a missing comma', '"max": 0.25},', '"max": 0.25}'],
  ['an unknown parameter', '"length": 1.5', '"lenght": 1.5'],
]) {
  test(`with ${what} handles and rows work on the text, and the view says that its plant is the last one`, async () => {
    await open_file(page, 'bush.json');
    await leave_fields(page);
    await page.keyboard.press('t');
    await retype(page, from, to);
    const mark = page.locator('[data-mark="stale-plant"]');
    await mark.waitFor();
    await retype(page, '"value": 30', '"value": 35');
    await page.waitForFunction(
      () => window.studio.document.state.get().variables.find((one) => one.name === 'bend')?.value === 35,
    );
    assert.equal(await field(page, 'bend').inputValue(), '35');
    await type_into(page, field(page, 'bend'), '72');
    await page.waitForFunction(() => window.studio.document.state.get().text.includes('"bend": {"value": 72,'));
    await picture(page, `fault-${from === '"length": 1.5' ? 'meaning' : 'form'}`);
    await leave_fields(page);
    await page.getByRole('button', { name: 'Reset bend' }).click();
    await page.waitForFunction(() => window.studio.document.state.get().text.includes('"bend": {"value": 30,'));
    assert.equal(await field(page, 'bend').inputValue(), '30');
    assert.ok((await text_of(page)).includes(to));
    await retype(page, to, from);
    await mark.waitFor({ state: 'detached' });
    await settled(page);
    assert.equal(await text_of(page), kBush);
    await page.getByRole('button', { name: 'Inspector' }).click();
  });
}

test('the outline of a leaf stays within half width 1, which its editor draws', async () => {
  await open_file(page, 'bush.json');
  await page.locator('.outline-choice', { hasText: 'leaf' }).first().click();
  const editor = row(page, 'components.leaf.outline').locator('.curve-editor');
  await editor.scrollIntoViewIfNeeded();
  assert.equal(await editor.locator('[data-limit="y-high"]').count(), 1);
  await drag(page, editor.locator('.curve-point').nth(1), [0, -80], { across: 0.5 });
  await settled(page);
  assert.match(await text_of(page), /\[0\.5, 1\]/);
  await drag(page, editor.locator('.curve-point').nth(0), [0, -200], { across: 0.5 });
  await settled(page);
  assert.match(await text_of(page), /"curve": \[\[0, 1\]/);
  assert.equal(await page.evaluate(() => window.studio.document.state.get().good), true);
  await picture(page, 'limits');
});
