// SPDX-License-Identifier: Apache-2.0
// Finding by looking: strips of plants under rows, nine by chance, pinned states.
import assert from 'node:assert/strict';
import path from 'node:path';
import { after, before, test } from 'node:test';

import { serious_faults } from './boxes.mjs';
import { choose, drag, field, leave_fields, open_file, open_model, row, step, type_into, undo_all } from './hands.mjs';
import {
  frames,
  open_page,
  settled,
  start_browser,
  start_server,
  temporary_folder,
  text_of,
  undo_count,
  write_document,
} from './support.mjs';

const kSmall = `{
  "meristem": 1,
  "seed": 4,
  "variables": {
    "size": {"value": 0.12, "min": 0.05, "max": 0.25, "unit": "m", "doc": "Length of the leaves."},
    "bend": {"value": 30, "min": 0, "max": 90, "doc": "How they bend."}
  },
  "components": {
    "tree": {"type": "tree", "length": 1.5, "radius": 0.02},
    "leaf": {"type": "leaf", "length": "size", "width": "size/2", "curl": "bend + 5*rand(-1,1)"}
  },
  "links": [{"from": "tree", "to": "leaf", "kind": "branch", "count": 12, "angle": 60}]
}
`;

let place, server, browser, page;

before(async () => {
  place = await temporary_folder();
  await write_document(place.folder, 'small.json', kSmall);
  server = await start_server(place.folder, path.join(place.folder, 'small.json'));
  browser = await start_browser();
  page = await open_page(await browser.newContext({ viewport: { width: 1280, height: 800 } }), server.address);
});

after(async () => {
  await browser?.close();
  await server?.stop();
  await place?.remove();
});

const pictures = (where, count) =>
  page.waitForFunction(
    ([selector, wanted]) => document.querySelectorAll(`${selector} img.still:not(.old)`).length === wanted,
    [where, count],
    { timeout: 60000 },
  );
const sources = (where) => page.locator(`${where} img.still`).evaluateAll((all) => all.map((one) => one.src));

async function all_back() {
  await leave_fields(page);
  await undo_all(page);
  assert.equal(await text_of(page), kSmall);
  await settled(page);
}

test('a strip shows five plants over the usual range of a row; a click takes a value as one step', async () => {
  await choose(page, 'tree');
  const length = row(page, 'components.tree.length');
  await length.hover();
  await length.getByRole('button', { name: 'Plants over length' }).click();
  await pictures('.strip', 5);
  const first = await sources('.strip');
  assert.equal(new Set(first).size, 5);
  const count = await undo_count(page);
  await step(page, () => page.locator('.strip button').nth(3).click());
  assert.equal((await undo_count(page)) - count, 1);
  const value = await page.evaluate(() => window.studio.document.state.get().tree.value.components.tree.length);
  assert.equal(await page.locator('.strip button[aria-pressed=true]').innerText(), String(value));
  // The strip shows all other changes, too.
  await step(page, () => type_into(page, field(page, 'size'), '0.2'));
  await pictures('.strip', 5);
  await page.waitForFunction((before) => document.querySelector('.strip img.still')?.src !== before, first[0], {
    timeout: 20000,
  });
  await all_back();
});

test('a choice has a plant for each of its values, and one strip is open at a time', async () => {
  const phyllotaxis = page.locator('.inspector .row[data-kind=choice], .inspector .row[data-kind=boolean]').first();
  await phyllotaxis.scrollIntoViewIfNeeded();
  await phyllotaxis.hover();
  await phyllotaxis.getByRole('button', { name: /^Plants over/ }).click();
  assert.equal(await page.locator('.strip').count(), 1);
  await page.waitForFunction(() => document.querySelectorAll('.strip img.still').length > 1);
  await phyllotaxis.getByRole('button', { name: /^Plants over/ }).click();
  assert.equal(await page.locator('.strip').count(), 0);
});

test('of a range the middle moves and the width stays; an expression gives way to a number, as the tooltip says', async () => {
  const text = kSmall.replace('"width": "size/2"', '"width": "size/2", "fold": [10, 20]');
  await write_document(place.folder, 'ranged.json', text);
  await open_file(page, 'ranged.json');
  await choose(page, 'leaf');
  const leaf = () => page.evaluate(() => window.studio.document.state.get().tree.value.components.leaf);
  const fold = row(page, 'components.leaf.fold');
  await fold.scrollIntoViewIfNeeded();
  await fold.hover();
  await fold.getByRole('button', { name: 'Plants over fold' }).click();
  await pictures('.strip', 5);
  await step(page, () => page.locator('.strip button').nth(3).click());
  const [low, high] = (await leaf()).fold;
  assert.ok(Math.abs(high - low - 10) < 1e-9 && low > 10, `${low} ${high}`);
  assert.equal(await page.locator('.strip button[aria-pressed=true]').innerText(), `${low}…${high}`);
  await fold.hover();
  await fold.getByRole('button', { name: 'Plants over fold' }).click();
  const curl = row(page, 'components.leaf.curl');
  await curl.scrollIntoViewIfNeeded();
  await curl.hover();
  await curl.getByRole('button', { name: 'Plants over curl' }).click();
  assert.match(
    await page.locator('.strip button').first().getAttribute('data-tip'),
    /a number in place of the expression bend \+ 5/,
  );
  await step(page, () => page.locator('.strip button').nth(1).click());
  assert.equal(typeof (await leaf()).curl, 'number');
  await leave_fields(page);
  await undo_all(page);
  assert.equal(await text_of(page), text);
  await open_file(page, 'small.json');
});

test('a handle has a strip over its own range', async () => {
  const handle = page.locator('[data-handle=bend]');
  await handle.hover();
  await handle.getByRole('button', { name: 'Plants over bend' }).click();
  await pictures('.strip', 5);
  await step(page, () => handle.locator('.strip button').last().click());
  assert.match(await text_of(page), /"bend": \{"value": 90,/);
  await handle.hover();
  await handle.getByRole('button', { name: 'Plants over bend' }).click();
  await all_back();
});

test('nine by chance: locked handles stay, and one is taken as one step', async () => {
  const handle = page.locator('[data-handle=size]');
  await handle.hover();
  await handle.getByRole('button', { name: 'Lock size' }).click();
  await leave_fields(page);
  await page.keyboard.press('n');
  await pictures('.nine', 9);
  const before_it = await sources('.nine');
  assert.ok(new Set(before_it).size > 5);
  await page.getByRole('button', { name: 'Nine others' }).click();
  await page.waitForFunction(
    (known) =>
      document.querySelectorAll('.nine img.still:not(.old)').length === 9 &&
      document.querySelector('.nine img.still').src !== known,
    before_it[0],
    { timeout: 60000 },
  );
  const tip = await page.locator('.nine button').nth(4).getAttribute('data-tip');
  assert.match(tip, /^bend [\d.]+$/);
  await step(page, () => page.locator('.nine button').nth(4).click());
  assert.equal(await undo_count(page), 1);
  const text = await text_of(page);
  assert.ok(text.includes(`"bend": {"value": ${tip.slice(5)},`) && text.includes('"size": {"value": 0.12,'), text);
  await all_back();
});

test('without handles the seed alone is thrown', async () => {
  const handle = page.locator('[data-handle=bend]');
  await handle.hover();
  await handle.getByRole('button', { name: 'Lock bend' }).click();
  await leave_fields(page);
  await page.keyboard.press('n');
  await pictures('.nine', 9);
  assert.match(await page.locator('.nine button').first().getAttribute('data-tip'), /^seed \d+$/);
  await page.keyboard.press('Escape');
  await page.locator('.nine').waitFor({ state: 'detached' });
});

test('two states are pinned beside the present one and seen from its side; one is taken again', async () => {
  await leave_fields(page);
  await page.keyboard.press('p');
  await step(page, () => type_into(page, field(page, 'bend'), '85'));
  await leave_fields(page);
  await page.keyboard.press('p');
  assert.equal(await page.locator('.pinned').count(), 2);
  await page.waitForFunction(() => document.querySelectorAll('.pinned .view-note').length === 0, null, {
    timeout: 60000,
  });
  assert.ok(await page.getByRole('button', { name: 'Two states are pinned' }).isDisabled());
  const widths = await page
    .locator('.pinned, .views > .view')
    .evaluateAll((all) => all.map((one) => one.getBoundingClientRect().width));
  assert.ok(Math.max(...widths) - Math.min(...widths) < 2, widths.join(' '));
  // Turning one view turns all views.
  const azimuth = () => page.evaluate(() => window.studio.view.orbit.azimuth);
  const first = await azimuth();
  await drag(page, page.locator('.pinned canvas').first(), [60, 0], { steps: 5 });
  await page.waitForFunction((known) => window.studio.view.orbit.azimuth !== known, first);
  // A view that was moved is not fitted again when the window's size changes.
  const distance = () => page.evaluate(() => window.studio.view.orbit.distance);
  const far = await distance();
  await page.locator('.pinned canvas').first().hover();
  await page.mouse.wheel(0, -300);
  await page.waitForFunction((known) => window.studio.view.orbit.distance < known, far);
  await frames(page, 10); // the turn of the wheel has ended
  const near = await distance();
  const size = page.viewportSize();
  await page.setViewportSize({ width: size.width - 100, height: size.height - 100 });
  await page.evaluate(() => window.studio.view.drawn());
  await frames(page, 10);
  assert.equal(await distance(), near);
  await page.setViewportSize(size);
  await step(page, () => page.locator('.pinned[data-pin=A]').getByRole('button', { name: 'Take' }).click());
  assert.equal(await text_of(page), kSmall);
  assert.equal(await undo_count(page), 2);
  await page.evaluate(() => {
    window.pinned_contexts = [...document.querySelectorAll('.pinned canvas')].map(
      (one) => new WeakRef(one.getContext('webgl2')),
    );
  });
  for (const name of ['A', 'B']) await page.getByRole('button', { name: `Let state ${name} go` }).click();
  assert.equal(await page.locator('.pinned').count(), 0);
  // The page keeps no drawing contexts of the pinned views. React itself may keep the last one until it draws again.
  const session = await page.context().newCDPSession(page);
  await frames(page);
  await session.send('HeapProfiler.collectGarbage');
  const held = await page.evaluate(() => window.pinned_contexts.filter((one) => one.deref() !== undefined).length);
  assert.ok(held <= 1, `${held} of 2 are held`);
  await all_back();
});

test('a shipped plant that reads files beside it is pinned as it is', async () => {
  await open_model(page, 'oak');
  await leave_fields(page);
  await page.keyboard.press('p');
  await page.waitForFunction(
    () =>
      document.querySelectorAll('.pinned').length === 1 && document.querySelectorAll('.pinned .view-note').length === 0,
    null,
    { timeout: 90000 },
  );
  await page.getByRole('button', { name: 'Let state A go' }).click();
});

test('axe finds nothing serious, light and dark', async () => {
  await open_model(page, 'sunflower');
  for (const theme of ['light', 'dark']) {
    await page.emulateMedia({ colorScheme: theme });
    await leave_fields(page);
    await page.keyboard.press('p');
    await page.keyboard.press('n');
    await pictures('.nine', 9);
    assert.deepEqual(await serious_faults(page, { colours_only: theme === 'dark' }), [], theme);
    await page.keyboard.press('Escape');
    await page.getByRole('button', { name: 'Let state A go' }).click();
  }
  await page.emulateMedia({ colorScheme: null });
});

test('nothing was complained about on the way', () => {
  assert.deepEqual(
    page.faults.filter((fault) => !/WebGL|GL Driver|CONTEXT_LOST/i.test(fault)),
    [],
  );
});
