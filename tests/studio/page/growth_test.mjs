// SPDX-License-Identifier: Apache-2.0
// The panel of growth: stepping without growing anew, with the overlays of the step.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import path from 'node:path';
import { after, before, test } from 'node:test';

import { open_file } from './hands.mjs';
import {
  kAxe,
  open_page,
  settled,
  start_browser,
  start_server,
  temporary_folder,
  text_of,
  write_document,
} from './support.mjs';

const kTree = `{
  "meristem": 1, "seed": 4,
  "components": {"tree": {
    "type": "colonize", "crown": {"ellipsoid": {"centre": [0, 1.2, 0], "radii": [0.6, 0.7, 0.6]}},
    "points": 90, "step": 0.06, "influence": 0.8, "kill": 0.16, "iterations": 18
  }}
}
`;

// Two of these trees, from another document, beside a herb of the document.
const kGarden = `{
  "meristem": 1,
  "components": {
    "view": {"type": "camera"},
    "row": {"type": "places", "line": {"points": [[0, 0], [3, 0]], "spacing": 3}},
    "fruit": {"type": "document", "file": "tree.json", "seed": 4},
    "herb": {"type": "lsystem", "steps": 3, "grammar": ["axiom: A", "A -> F[+A][-A]"]}
  },
  "links": [["view", "row"], ["row", "fruit"], ["view", "herb"]]
}
`;

let place, server, browser, page;

before(async () => {
  place = await temporary_folder();
  await write_document(place.folder, 'tree.json', kTree);
  await write_document(place.folder, 'garden.json', kGarden);
  server = await start_server(place.folder, path.join(place.folder, 'tree.json'));
  browser = await start_browser();
  page = await open_page(await browser.newContext({ viewport: { width: 1280, height: 800 } }), server.address);
});

after(async () => {
  await browser?.close();
  await server?.stop();
  await place?.remove();
});

const look = () => page.evaluate(() => window.studio.bench.growth_look.state.get());
const grown = () => page.evaluate(() => window.studio.growth.get().grown);
const overlays = () => page.evaluate(() => window.studio.view.counts.overlays);
const slider = () => page.getByRole('slider', { name: 'Step of growth' });

/// Waits until a step is shown with its overlays.
async function shown(step) {
  await page.waitForFunction(
    (wanted) => window.studio.growth.get().grown?.step === wanted && window.studio.growth.get().grown.steps !== null,
    step,
    { timeout: 20000 },
  );
  await settled(page);
}

test('the panel opens by its key and tells how many steps growth took', async () => {
  await page.keyboard.press('s');
  await shown(18);
  assert.equal((await look()).steps, 18);
  assert.match(await page.locator('.growth-step').innerText(), /18 of 18/);
});

test('overlays show the points of the step, and what the colours mean', async () => {
  await page.getByRole('button', { name: 'Attraction points' }).click();
  await page.waitForFunction(() => window.studio.view.counts.overlays.points === 90);
  assert.equal((await overlays()).layers, 1);
  const legend = await page.locator('.growth-legend').innerText();
  const [left, used] = [/(\d+) points? left/, /(\d+) points? used up/].map((of) => Number(of.exec(legend)?.[1] ?? 0));
  assert.equal(left + used, 90);
  assert.ok(used > 10);
});

test('steps go back and forth by keyboard without growing anew; the document stays', async () => {
  const text = await text_of(page);
  const nodes = (await grown()).nodes;
  await slider().focus();
  for (let k = 0; k < 6; ++k) await page.keyboard.press('ArrowLeft');
  await shown(12);
  const at_12 = await grown();
  assert.ok(at_12.nodes < nodes);
  const skeletons = at_12.reuse.find(({ what }) => what === 'grown skeletons');
  assert.deepEqual([skeletons.made, skeletons.reused], [0, 1]);
  await page.waitForFunction(() => /points left/.test(document.querySelector('.growth-legend')?.textContent ?? ''));
  await page.getByRole('button', { name: 'Before growth' }).click();
  await shown(0);
  assert.equal((await grown()).nodes, 1);
  await page.keyboard.press('PageUp');
  await shown(1);
  await page.getByRole('button', { name: 'After all steps' }).click();
  await shown(18);
  assert.equal((await grown()).nodes, nodes);
  assert.equal(await text_of(page), text);
});

test('step 12 of 18 equals a document with 12 iterations', async () => {
  await slider().focus();
  for (let k = 0; k < 6; ++k) await page.keyboard.press('ArrowLeft');
  await shown(12);
  const of_step = (await grown()).nodes;
  const bounds = await page.evaluate(() => [
    window.studio.view.bounds.min.toArray(),
    window.studio.view.bounds.max.toArray(),
  ]);
  await page.keyboard.press('s');
  await page.evaluate(() => window.studio.edit([{ set: 'tree.iterations', value: 12 }], 'Fewer iterations'));
  await page.waitForFunction(
    () =>
      window.studio.growth.get().grown?.steps === null &&
      window.studio.document.state.get().text.includes('"iterations": 12'),
  );
  await settled(page);
  assert.equal((await grown()).nodes, of_step);
  const again = await page.evaluate(() => [
    window.studio.view.bounds.min.toArray(),
    window.studio.view.bounds.max.toArray(),
  ]);
  assert.deepEqual(again, bounds);
});

test('the plants of a garden go through their steps side by side, or those of one component alone', async () => {
  await page.keyboard.press('Control+z');
  await settled(page);
  await open_file(page, 'garden.json');
  await page.keyboard.press('s');
  await shown(18);
  const whole = (await grown()).nodes;
  const of = page.getByRole('combobox', { name: 'Steps of' });
  assert.deepEqual(await of.locator('option').allInnerTexts(), [
    'all plants, side by side (18)',
    'fruit (18)',
    'herb (3)',
  ]);
  await page.getByRole('button', { name: 'A step back' }).click();
  await shown(17);
  const reuse = (await grown()).reuse.find(({ what }) => what === 'placed plants');
  assert.deepEqual([reuse.made, reuse.reused], [0, 1], 'one growth gives all steps');
  await page.getByRole('button', { name: 'Attraction points' }).click();
  await page.waitForFunction(() => window.studio.view.counts.overlays.points === 180);
  await of.selectOption('herb');
  await shown(3);
  await page.getByRole('button', { name: 'Before growth' }).click();
  await shown(0);
  const without_herb = (await grown()).nodes;
  await of.selectOption('');
  await shown(18);
  assert.equal((await grown()).nodes, whole);
  assert.ok(without_herb < whole, `${without_herb} of ${whole}`);
  await page.keyboard.press('s');
});

test('closing takes all away; axe finds nothing serious in the open panel', async () => {
  assert.equal((await overlays()).layers, 0);
  await page.keyboard.press('s');
  await page.waitForFunction(() => window.studio.bench.growth_look.state.get().steps !== null);
  await page.getByRole('button', { name: 'Skeleton', exact: true }).last().click();
  await page.waitForFunction(() => window.studio.view.counts.overlays.lines > 0);
  await page.evaluate(await readFile(kAxe, 'utf8'));
  const found = await page.evaluate(() => window.axe.run('.growth-panel'));
  const serious = found.violations.filter(({ impact }) => impact === 'serious' || impact === 'critical');
  assert.deepEqual(
    serious.map(({ id, nodes }) => [id, nodes[0].html]),
    [],
  );
  assert.deepEqual(page.faults, []);
});
