// SPDX-License-Identifier: Apache-2.0
// Measures beside the plant: equal to the command line's measures, beside real plants, over a handle.
import assert from 'node:assert/strict';
import path from 'node:path';
import { after, before, test } from 'node:test';

import { serious_faults } from './boxes.mjs';
import { field, leave_fields, step, type_into, undo_all } from './hands.mjs';
import {
  meristem,
  open_page,
  settled,
  start_browser,
  start_server,
  still,
  temporary_folder,
  text_of,
  undo_count,
  write_document,
} from './support.mjs';

const kTree = `{
  "meristem": 1,
  "variables": {"size": {"value": 2, "min": 1, "max": 3, "doc": "Length of the stem."}},
  "components": {
    "stem": {"type": "tree", "length": "size", "radius": 0.02},
    "leaf": {"type": "leaf", "length": 0.1, "width": 0.05}
  },
  "links": [{"from": "stem", "to": "leaf", "kind": "branch", "count": 12}]
}
`;

let place, server, browser, page;

before(async () => {
  place = await temporary_folder();
  await write_document(place.folder, 'tree.json', kTree);
  server = await start_server(place.folder, path.join(place.folder, 'tree.json'));
  browser = await start_browser();
  page = await open_page(await browser.newContext({ viewport: { width: 1280, height: 900 } }), server.address);
  await leave_fields(page);
  await page.keyboard.press('m');
});

after(async () => {
  await browser?.close();
  await server?.stop();
  await place?.remove();
});

const measure = (name) => page.locator(`[data-measure="${name}"]`);
const told = (name) => page.evaluate((one) => window.studio.bench.measures.state.get().told?.[one], name);
const measured = () =>
  page.waitForFunction(
    () => window.studio.bench.measures.state.get().told && !window.studio.bench.measures.state.get().is_working,
    null,
    { timeout: 30_000 },
  );

test('measures are those of the command line, and follow the document', async () => {
  await measured();
  const { stdout } = await meristem('measure', path.join(place.folder, 'tree.json'), '--json');
  const wanted = JSON.parse(stdout);
  for (const name of ['height', 'leaf_count', 'stem_diameter', 'slenderness', 'triangles'])
    assert.equal(await told(name), wanted[name], name);
  assert.match(await measure('height').innerText(), /2\s*m/);
  assert.match(await measure('height').locator('dt').getAttribute('data-tip'), /highest node/);
  await step(page, () => type_into(page, field(page, 'size'), '2.5'));
  await page.waitForFunction(() => window.studio.bench.measures.state.get().told?.height === 2.5, null, {
    timeout: 30_000,
  });
  await leave_fields(page);
  await undo_all(page);
});

test('a measure stands beside what was measured on real plants, with the source', async () => {
  await page.waitForFunction(() => window.studio.bench.measures.state.get().told?.height === 2, null, {
    timeout: 30_000,
  });
  const band = measure('slenderness').locator('.band');
  assert.match(await band.innerText(), /20–75, most city trees/);
  assert.match(await band.getAttribute('data-tip'), /McPherson/);
});

test('the light on the leaves is measured where it is asked for, with leaf area by height', async () => {
  assert.equal(await told('leaf_irradiance'), null);
  await page.getByRole('checkbox', { name: 'Light on the leaves' }).check();
  await page.waitForFunction(
    () => typeof window.studio.bench.measures.state.get().told?.leaf_irradiance === 'number',
    null,
    { timeout: 30_000 },
  );
  await page.locator('.layers li').first().waitFor();
  const layers = await told('layers');
  const sum = layers.reduce((all, one) => all + one.leaf_area, 0);
  assert.ok(Math.abs(sum - (await told('leaf_area'))) < 1e-6);
  await page.getByRole('checkbox', { name: 'Light on the leaves' }).uncheck();
});

test('a measure is drawn over a handle, and a point of the plot takes its value', async () => {
  await page.getByRole('button', { name: 'Measure', exact: true }).click();
  const points = page.locator('[data-plot=height] circle');
  await points.nth(8).waitFor({ timeout: 60_000 });
  assert.equal(await points.count(), 9);
  assert.equal(await points.first().getAttribute('data-tip'), 'size 1: 1 m');
  assert.equal(await points.last().getAttribute('data-tip'), 'size 3: 3 m');
  assert.equal(await text_of(page), kTree);
  await page.getByRole('combobox', { name: 'Measure of plot 1' }).selectOption('stem_diameter');
  await page.locator('[data-plot=stem_diameter] circle').first().waitFor();
  await page.getByRole('button', { name: 'Draw another measure' }).click();
  assert.equal(await page.locator('.plot').count(), 2);
  await step(page, () => page.locator('[data-plot=height] circle').first().click());
  assert.match(await text_of(page), /"size": \{"value": 1,/);
  assert.equal(await undo_count(page), 1);
  await leave_fields(page);
  await undo_all(page);
  assert.equal(await text_of(page), kTree);
  await settled(page);
});

test('axe finds nothing serious in the measures, light and dark', async () => {
  for (const theme of ['light', 'dark']) {
    await page.emulateMedia({ colorScheme: theme });
    // While a document is being measured, the measures are pale.
    await page.waitForFunction(() => {
      const { studio } = window;
      const { measures } = studio.bench;
      const { grown } = studio.growth.get();
      return (
        !measures.state.get().is_working && (measures.seen_.startsWith(grown.hash) || measures.called_off_ === grown)
      );
    });
    await still(page);
    assert.deepEqual(await serious_faults(page, { colours_only: theme === 'dark' }), [], theme);
  }
});

test('nothing was complained about on the way', () => {
  assert.deepEqual(
    page.faults.filter((fault) => !/WebGL|GL Driver/i.test(fault)),
    [],
  );
});
