// SPDX-License-Identifier: Apache-2.0
// The pages of plants that the Python module writes, in a real browser, alone and as frames of a notebook.
// MERISTEM_PYTHON is an interpreter that finds the module.
import assert from 'node:assert/strict';
import { execFile } from 'node:child_process';
import { readFile, writeFile } from 'node:fs/promises';
import path from 'node:path';
import process from 'node:process';
import { after, before, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { promisify } from 'node:util';

import { frames, start_browser, temporary_folder } from './support.mjs';

/// Writes the pages, and prints their expected contents.
const kProgram = `
import json, sys
import meristem
from meristem._page import PageInNotebook
bush = meristem.read("bush").grow()
bush.save_html("bush.html")
bush.save_html("few.html", triangles=3000, view=(90, 20))
meristem.read("sunflower").grow().save_html("sunflower.html")
with open("notebook.html", "w", encoding="utf-8") as file:
    frame = PageInNotebook(bush.to_html(), None)._repr_html_()
    file.write(f"<!DOCTYPE html><title>A notebook</title><div style='height: 300px'></div>{frame}<div style='height: 3000px'></div>")
print(json.dumps({"triangles": bush.triangle_count, "batches": len(bush.meshes)}))
`;

let place, browser, context, wanted;

before(async () => {
  place = await temporary_folder();
  const python = process.env.MERISTEM_PYTHON ?? '/usr/bin/python3';
  wanted = JSON.parse((await promisify(execFile)(python, ['-B', '-c', kProgram], { cwd: place.folder })).stdout);
  browser = await start_browser({ as_users_do: true });
  context = await browser.newContext({ viewport: { width: 700, height: 600 } });
});

after(async () => {
  await browser?.close();
  await place?.remove();
});

/// Opens a file, without a network, and returns its page with all errors and requests.
async function open(name, where = context) {
  const page = await where.newPage();
  page.faults = [];
  page.on('pageerror', (fault) => page.faults.push(String(fault)));
  page.on('console', (message) => ['error', 'warning'].includes(message.type()) && page.faults.push(message.text()));
  page.on('request', (request) => !/^(file|blob|data|about):/.test(request.url()) && page.faults.push(request.url()));
  await page.goto(pathToFileURL(path.join(place.folder, name)).href);
  return page;
}

/// Waits until a picture was drawn after all textures were loaded.
async function drawn(frame) {
  await frame.waitForFunction(
    () => window.viewer?.frames_drawn > 1 || document.getElementById('note').textContent !== 'Opening…',
    null,
    { timeout: 60000 },
  );
  assert.notEqual(await frame.evaluate(() => window.viewer), undefined, await frame.locator('#note').innerText());
  return frame.evaluate(async () => {
    const turn = () => new Promise(requestAnimationFrame);
    window.viewer.paint(false, false); // without the ground, so that only the plant is counted
    for (let k = 0; k < 3; k += 1) await turn();
    return window.viewer.counts;
  });
}

const camera = (frame) => frame.evaluate(() => window.viewer.orbit.state);

/// Returns the share of a screenshot's pixels that differ from an empty sky at their height.
async function covered(page, frame) {
  await frame.evaluate(() => window.viewer.ask());
  const png = (await page.screenshot({ timeout: 60000 })).toString('base64');
  return page.evaluate(async (data) => {
    const image = await createImageBitmap(await (await fetch(`data:image/png;base64,${data}`)).blob());
    const canvas = new OffscreenCanvas(image.width, image.height).getContext('2d');
    canvas.drawImage(image, 0, 0);
    const { data: pixels } = canvas.getImageData(0, 0, image.width, image.height);
    let other = 0;
    for (let y = 0; y < image.height; y += 1) {
      for (let x = 0; x < image.width; x += 1) {
        const [at, edge] = [4 * (y * image.width + x), 4 * (y * image.width + image.width - 2)];
        const away =
          Math.abs(pixels[at] - pixels[edge]) +
          Math.abs(pixels[at + 1] - pixels[edge + 1]) +
          Math.abs(pixels[at + 2] - pixels[edge + 2]);
        other += away > 40 ? 1 : 0;
      }
    }
    return other / (image.width * image.height);
  }, png);
}

test('a page draws all triangles of the plant, and complains about nothing', async () => {
  const page = await open('bush.html');
  const { triangles, batches } = await drawn(page);
  assert.deepEqual({ triangles, batches }, wanted);
  const share = await covered(page, page);
  assert.ok(share > 0.1 && share < 0.9, `${share} of the picture is covered`);
  assert.equal(await page.locator('#note').innerText(), '');
  assert.deepEqual(page.faults, []);
  await page.close();
});

test('a plant that was thinned out says so, and is seen from where it was asked for', async () => {
  const page = await open('few.html');
  const { triangles } = await drawn(page);
  assert.ok(triangles > 900 && triangles <= 3000, `${triangles}`);
  assert.match(await page.locator('#note').innerText(), /^[\d,]+ of [\d,]+ triangles$/);
  const { azimuth, altitude } = await camera(page);
  assert.deepEqual([azimuth, altitude], [90, 20]);
  assert.deepEqual(page.faults, []);
  await page.close();
});

test('a hand turns, moves and zooms; a double click fits', async () => {
  const page = await open('sunflower.html');
  await drawn(page);
  const first = await camera(page);
  await page.mouse.move(300, 300);
  await page.mouse.down();
  await page.mouse.move(400, 330, { steps: 4 });
  await page.mouse.up();
  const turned = await camera(page);
  assert.ok(Math.abs(turned.azimuth - first.azimuth - 35) < 0.01 && turned.altitude > first.altitude);
  await page.mouse.down({ button: 'right' });
  await page.mouse.move(300, 330, { steps: 4 });
  await page.mouse.up({ button: 'right' });
  const moved = await camera(page);
  assert.notDeepEqual(moved.target, turned.target);
  await page.mouse.wheel(0, -400);
  await page.waitForFunction((distance) => window.viewer.orbit.distance < distance, moved.distance);
  await page.mouse.dblclick(300, 300);
  const fitted = await camera(page);
  assert.ok(Math.abs(fitted.target[1] - first.target[1]) < 1e-6);
  assert.equal(await page.locator('#hint').isVisible(), false);
  await page.setViewportSize({ width: 400, height: 600 }); // what a hand has set stays
  await frames(page, 10);
  assert.equal((await camera(page)).distance, fitted.distance);
  await page.close();
});

test('in a notebook the plant fills its frame, and the wheel scrolls the page until the view is clicked', async () => {
  const page = await open('notebook.html');
  const frame = page.frames()[1] ?? (await page.waitForEvent('frameattached'));
  const { triangles } = await drawn(frame);
  assert.equal(triangles, wanted.triangles);
  const { distance } = await camera(frame);
  await page.mouse.move(300, 450);
  await page.mouse.wheel(0, 120);
  await page.waitForFunction(() => window.scrollY > 0);
  assert.equal((await camera(frame)).distance, distance);
  await page.mouse.click(300, 350);
  const before_it = await page.evaluate(() => window.scrollY);
  await page.mouse.wheel(0, -120);
  await frame.waitForFunction((was) => window.viewer.orbit.distance < was, distance);
  assert.equal(await page.evaluate(() => window.scrollY), before_it);
  assert.deepEqual(page.faults, []);
  await page.close();
});

test('a broken page says so instead of staying empty', async () => {
  const page_text = await readFile(path.join(place.folder, 'bush.html'), 'utf8');
  await writeFile(path.join(place.folder, 'broken.html'), page_text.replace(/(id="packed-plant">)[^<]{200}/, '$1'));
  const page = await open('broken.html');
  await page.waitForFunction(() => document.getElementById('note').textContent !== 'Opening…');
  assert.notEqual(await page.locator('#note').innerText(), '');
  await page.close();
});
