// SPDX-License-Identifier: Apache-2.0
// Draws the manual's pictures of the studio anew, and compares them with the kept pictures.
import assert from 'node:assert/strict';
import { mkdir, readFile, stat } from 'node:fs/promises';
import path from 'node:path';
import process from 'node:process';
import { after, before, test } from 'node:test';

import { draw_all, kFolder, kMaxBytes, kPictures } from './pictures.mjs';
import { kSource, start_browser, temporary_folder } from './support.mjs';

/// How far pictures may differ on average, out of 255, in squares of 16 pixels. A page that is drawn again differs by
/// up to 0.3, because times differ. A strip of small plants over the view makes 4.
const kNear = 2;
const kScale = 0.5; // half as many pixels each way as the pictures that are kept: they are compared in far fewer

let place, browser, out, page;

before(async () => {
  place = await temporary_folder();
  out = process.env.MERISTEM_PICTURES ?? path.join(place.folder, 'pictures');
  await mkdir(out, { recursive: true });
  browser = await start_browser();
  await draw_all(browser, out, { scale: process.env.MERISTEM_PICTURES === undefined ? kScale : 1 });
  page = await browser.newPage();
});

after(async () => {
  await browser?.close();
  await place?.remove();
});

/// Returns the mean difference of two pictures after both were made small.
async function difference(first, second) {
  const address = async (file) => `data:image/jpeg;base64,${(await readFile(file)).toString('base64')}`;
  return page.evaluate(
    async (files) => {
      const [a, b] = await Promise.all(
        files.map(async (file) => {
          const image = await createImageBitmap(await (await fetch(file)).blob(), {
            resizeWidth: 80,
            resizeHeight: 48,
            resizeQuality: 'high',
          });
          const canvas = new OffscreenCanvas(80, 48);
          const context = canvas.getContext('2d');
          context.drawImage(image, 0, 0);
          return context.getImageData(0, 0, 80, 48).data;
        }),
      );
      return a.reduce((sum, one, k) => sum + Math.abs(one - b[k]), 0) / (0.75 * a.length);
    },
    [await address(first), await address(second)],
  );
}

for (const { name } of kPictures) {
  test(`the picture ${name} is kept as the studio looks`, async () => {
    const [made, kept] = [path.join(out, `${name}.jpg`), path.join(kFolder, `${name}.jpg`)];
    assert.ok((await stat(kept)).size < kMaxBytes);
    const far = await difference(made, kept);
    assert.ok(far < kNear, `${kept} differs by ${far.toFixed(1)}; \`./dev gallery studio\` draws it anew`);
  });
}

test('two pictures of different things are told apart', async () => {
  for (const { name } of kPictures.slice(1))
    assert.ok((await difference(path.join(kFolder, 'oak.jpg'), path.join(kFolder, `${name}.jpg`))) > kNear, name);
});

test('manual and README show all of them', async () => {
  const pages = ['studio', 'studio-flower', 'studio-steer'].map((name) =>
    readFile(path.join(kSource, `docs/manual/${name}.md`), 'utf8'),
  );
  const manual = (await Promise.all(pages)).join('\n');
  for (const { name } of kPictures) assert.ok(manual.includes(`(studio/${name}.jpg)`), name);
  assert.ok((await readFile(path.join(kSource, 'README.md'), 'utf8')).includes('(docs/manual/studio/oak.jpg)'));
});
