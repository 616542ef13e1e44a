// SPDX-License-Identifier: Apache-2.0
// A large plant is opened. The previous plant disappears at once, and a draft comes first. If the growth reaches its
// time limit, the draft stays, and Continue continues the growth.
import assert from 'node:assert/strict';
import path from 'node:path';
import process from 'node:process';
import { after, before, test } from 'node:test';

import { leave_fields } from './hands.mjs';
import { open_page, settled, start_browser, start_server, temporary_folder, write_document } from './support.mjs';

const kSmall = `{
  "meristem": 1,
  "components": {"post": {"type": "tree", "length": 1, "radius": 0.05}}
}
`;

let place, server, browser, page;
const limit = { is_reached: false, held: [], asked: 0 }; // while reached, pictures at rest wait for Continue

/// A proxy between page and server. It acts like a server whose growth reaches the time limit after the draft.
async function hold_pictures(context) {
  await context.routeWebSocket(/socket$/, (socket) => {
    const beyond = socket.connectToServer();
    socket.onMessage((message) => {
      if (typeof message === 'string' && JSON.parse(message).do === 'continue') {
        limit.asked += 1;
        limit.is_reached = false;
        for (const held of limit.held.splice(0)) socket.send(held);
      }
      beyond.send(message);
    });
    beyond.onMessage((message) => {
      const head =
        typeof message === 'string' || message.toString('latin1', 0, 4) !== 'MSP1'
          ? null
          : JSON.parse(message.toString('utf8', 8, 8 + message.readUInt32LE(4)));
      if (!limit.is_reached || !head || head.draft) return socket.send(message);
      limit.held.push(message);
      socket.send(
        JSON.stringify({
          is: 'failed',
          job: 'grow',
          hash: head.hash,
          faults: [],
          message: 'stopped after 60 seconds (job_seconds)',
          limit: 'job_seconds',
          continues: true,
        }),
      );
    });
  });
}

before(async () => {
  place = await temporary_folder();
  await write_document(place.folder, 'small.json', kSmall);
  server = await start_server(place.folder, path.join(place.folder, 'small.json'));
  browser = await start_browser();
  const context = await browser.newContext({ viewport: { width: 1280, height: 900 }, deviceScaleFactor: 1 });
  await hold_pictures(context);
  page = await open_page(context, server.address);
  await page.getByRole('button', { name: 'Start', exact: true }).click();
  await leave_fields(page);
});

after(async () => {
  await browser?.close();
  await server?.stop();
  await place?.remove();
});

const shown = () => page.evaluate(() => window.studio.growth.get().shown);
const note = () => page.locator('.view > .view-note');

test('a large plant shows a draft that stays at the time limit, and Continue goes on', async () => {
  await settled(page);
  assert.deepEqual(await page.evaluate(() => window.studio.view.plant.components), ['post']);
  // Records the view's plant at each change of the document or the picture.
  await page.evaluate(() => {
    const { document, growth, view } = window.studio;
    window.seen = [];
    const look = () => window.seen.push({ model: document.state.get().model, components: view.plant.components });
    document.state.subscribe(look);
    growth.subscribe(look);
    requestAnimationFrame(function again() {
      look();
      requestAnimationFrame(again);
    });
  });
  limit.is_reached = true;
  await page.keyboard.press('Control+m');
  await page.locator('[data-model="spruce"]').click();
  await note().getByRole('button', { name: 'Continue' }).waitFor({ timeout: 60000 });
  assert.match(await note().textContent(), /stopped after 60 seconds.*What is shown is a draft\./);
  const draft = await shown();
  assert.equal(draft.draft, true);
  assert.ok(draft.triangles > 1000);
  if (process.env.MERISTEM_PICTURES)
    await page.screenshot({ path: path.join(process.env.MERISTEM_PICTURES, 'continue.png') });
  const seen = await page.evaluate(() => window.seen.filter((one) => one.model === 'spruce'));
  assert.ok(seen.some((one) => one.components.length > 0));
  assert.ok(!seen.some((one) => one.components.includes('post')), 'the plant of the other document is not seen');

  await note().getByRole('button', { name: 'Continue' }).click();
  await settled(page);
  assert.equal(limit.asked, 1);
  assert.equal(await note().count(), 0);
  assert.ok((await shown()).triangles > draft.triangles);
  assert.deepEqual(page.faults, []);
});

test('a document with faults shows nothing of the plant before it', async () => {
  await write_document(place.folder, 'faulty.json', '{"meristem": 1, "components": {"a": {"type": "nothing"}}}');
  await page.getByRole('button', { name: 'Open a file' }).click();
  await page
    .getByRole('dialog')
    .locator('.file', { has: page.getByText('faulty.json', { exact: true }) })
    .click();
  await page.waitForFunction(() => window.studio.document.state.get().path === 'faulty.json');
  assert.deepEqual(await page.evaluate(() => window.studio.view.plant.components), []);
  assert.match(await note().textContent(), /there is no plant to show yet/);
});
