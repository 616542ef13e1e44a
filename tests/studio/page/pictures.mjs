// SPDX-License-Identifier: Apache-2.0
// Draws the pictures of the manual's chapter on the studio: node tests/studio/page/pictures.mjs [FOLDER]
import { mkdir, stat } from 'node:fs/promises';
import path from 'node:path';
import process from 'node:process';

import { kSource, open_page, settled, start_browser, start_server, temporary_folder } from './support.mjs';

const kMostBytes = 250_000;
const out = path.resolve(process.argv[2] ?? path.join(kSource, 'docs/manual/studio'));
const place = await temporary_folder();
const server = await start_server(place.folder);
const browser = await start_browser();

/// A picture of the page after what `act` does, as good as its size allows.
async function draw(name, theme, act, viewport = { width: 1280, height: 760 }) {
  const context = await browser.newContext({ viewport, colorScheme: theme });
  const page = await open_page(context, server.address);
  await page.evaluate(() => window.studio.shell.merge({ shows_hints: false }));
  await act(page);
  await page.waitForTimeout(1200);
  const file = path.join(out, `${name}.jpg`);
  for (let quality = 90; quality >= 50; quality -= 8) {
    await page.screenshot({ path: file, type: 'jpeg', quality, timeout: 120_000 });
    if ((await stat(file)).size < kMostBytes) break;
  }
  console.log(`${file}: ${(await stat(file)).size} bytes`);
  await context.close();
}

const open = async (page, model) => {
  await page.evaluate((wanted) => window.studio.open({ model: wanted }), model);
  await settled(page);
};

await mkdir(out, { recursive: true });
try {
  await draw('oak', 'light', async () => undefined);
  await draw('inspector', 'dark', async (page) => {
    await open(page, 'sunflower');
    await page.locator('.outline-choice').nth(2).click();
  });
  await draw('text', 'light', async (page) => {
    await open(page, 'low-poly-oak');
    await page.keyboard.press('t');
    await page.evaluate(() => window.studio.document.type(window.studio.document.state.get().text.replace('"blend": 0.6', '"blend": 0.6*spraed')));
    await page.locator('.fault-list button').first().click();
  });
  await draw('models', 'light', async (page) => {
    await page.keyboard.press('Control+m');
    await page.locator('.model img').first().waitFor();
    await page.waitForTimeout(2500);
  });
} finally {
  await browser.close();
  await server.stop();
  await place.remove();
}
