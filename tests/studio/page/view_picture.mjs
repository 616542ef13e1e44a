// SPDX-License-Identifier: Apache-2.0
// Takes a picture of a page that the Python module has written: node tests/studio/page/view_picture.mjs PAGE PICTURE.jpg
import { stat } from 'node:fs/promises';
import path from 'node:path';
import process from 'node:process';
import { pathToFileURL } from 'node:url';

import { start_browser } from './support.mjs';

const kMaxBytes = 250_000;
const [page_file, picture] = process.argv.slice(2);
if (picture === undefined) throw new Error('usage: node view_picture.mjs PAGE PICTURE.jpg [light|dark]');
const browser = await start_browser();
try {
  const context = await browser.newContext({
    viewport: { width: 900, height: 620 },
    deviceScaleFactor: 1,
    colorScheme: process.argv[4] ?? 'light',
  });
  const page = await context.newPage();
  await page.goto(pathToFileURL(path.resolve(page_file)).href);
  await page.waitForFunction(() => window.viewer?.frames_drawn > 0, null, { timeout: 120_000 });
  await page.waitForTimeout(3000); // textures come after the first picture
  for (let quality = 90; quality >= 50; quality -= 8) {
    await page.screenshot({ path: picture, type: 'jpeg', quality, timeout: 120_000 });
    if ((await stat(picture)).size < kMaxBytes) break;
  }
  console.log(`${picture}: ${(await stat(picture)).size} bytes`);
} finally {
  await browser.close();
}
