// SPDX-License-Identifier: Apache-2.0
// The document over time: keys of rows, the timeline, clocks as blocks, moving through time and playing, frames.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import path from 'node:path';
import { after, before, test } from 'node:test';

import { serious_faults } from './boxes.mjs';
import { choose, drag, leave_fields, open_file, row, step, type_into, undo_all } from './hands.mjs';
import {
  frames,
  meristem,
  open_page,
  set_theme,
  settled,
  start_browser,
  start_server,
  temporary_folder,
  text_of,
  undo_count,
  write_document,
} from './support.mjs';

const kFilm = `{
  "meristem": 1,
  // How it opens.
  "animation": {"length": 4, "fps": 10, "keys": {
    "stem.length": [[0, 0.2], [4, 1, "smooth"]] // it grows
  }},
  "variables": {"opening": {"value": 20, "min": 0, "max": 90, "doc": "How far it is open."}},
  "components": {
    "view": {"type": "camera", "azimuth": 150, "altitude": 10},
    "stem": {"type": "tree", "length": 0.4, "radius": 0.01},
    "ring": {"type": "hydra", "number": 3, "radius": 0.01, "angle": "opening"},
    "clock": {"type": "sequence", "delay": [0.5, 2]},
    "petal": {"type": "leaf", "length": 0.1, "width": 0.05, "colour": "#dd4444"}
  },
  "links": [["view", "stem"], ["stem", "ring"], ["ring", "clock"], ["clock", "petal"]]
}
`;

let place, server, browser, page;

before(async () => {
  place = await temporary_folder();
  await write_document(place.folder, 'film.json', kFilm);
  server = await start_server(place.folder, path.join(place.folder, 'film.json'));
  browser = await start_browser();
  page = await open_page(
    await browser.newContext({ viewport: { width: 1280, height: 900 }, acceptDownloads: true }),
    server.address,
  );
  await page.getByRole('button', { name: 'Start', exact: true }).click();
  await leave_fields(page);
  await page.keyboard.press('k');
  await timeline().waitFor();
});

after(async () => {
  await browser?.close();
  await server?.stop();
  await place?.remove();
});

const timeline = () => page.locator('.timeline');
const lane = (name) => page.locator(`[data-track="${name}"]`);
const said = () => page.evaluate(() => JSON.parse(JSON.stringify(window.studio.document.state.get().tree.value)));
const keys = async (name) => (await said()).animation.keys[name];
const time = () => page.evaluate(() => window.studio.bench.time.time);
const height = () =>
  page.evaluate(
    () =>
      window.studio.view.plant.seen.length &&
      new Promise((done) => window.studio.view.drawn().then(() => done(window.studio.view.fitting_distance))),
  );

/// Waits until the server has answered the last time, with the request for all detail.
const all_time_is_sent = () =>
  page.waitForFunction(() => {
    const { time } = window.studio.bench;
    return time.moves_until_ === 0 && !time.sender_.is_sending_;
  });

/// Shows another time, and waits until the plant of this time is shown at rest. The growth's `shown` is another object for
/// each packet.
async function scrub_to(seconds) {
  await all_time_is_sent();
  await settled(page);
  if ((await time()) === seconds) return;
  await page.evaluate(() => {
    window.shown_before = window.studio.growth.get().shown;
  });
  await type_into(page, page.getByRole('textbox', { name: 'Time', exact: true }), String(seconds));
  await page.waitForFunction((wanted) => window.studio.bench.time.time === wanted, seconds);
  await all_time_is_sent();
  await page.waitForFunction(() => window.studio.growth.get().shown !== window.shown_before);
  await settled(page);
}

async function one_step(act) {
  const count = await undo_count(page);
  await step(page, act);
  assert.equal((await undo_count(page)) - count, 1);
}

async function all_back() {
  await leave_fields(page);
  await undo_all(page);
  assert.equal(await text_of(page), kFilm);
  await settled(page);
}

test('the time is scrubbed by hand and by keys, and the plant follows', async () => {
  const small = await height();
  await timeline().getByRole('slider', { name: 'Time that is shown' }).focus();
  await page.keyboard.press('End');
  await page.waitForFunction(() => window.studio.bench.time.time === 4);
  await page.waitForFunction((before) => window.studio.view.fitting_distance > 2 * before, small, { timeout: 20000 });
  await page.keyboard.press('ArrowLeft');
  assert.equal(await time(), 3.9);
  await page.keyboard.press('Home');
  await page.waitForFunction((before) => window.studio.view.fitting_distance < 1.1 * before, small, { timeout: 20000 });
  await drag(page, page.locator('.ruler'), [120, 0], { across: 0.25 });
  assert.ok((await time()) > 1);
  assert.equal(await undo_count(page), 0);
});

test('a row is keyed where the time stands; its number is that of the keys, and a hand changes the key', async () => {
  await scrub_to(2);
  await choose(page, 'stem');
  const length = row(page, 'components.stem.length');
  const shown = Number(await length.getByRole('textbox', { name: 'length', exact: true }).inputValue());
  assert.equal(shown, 0.6);
  const button = length.getByRole('button', { name: 'Key of length' });
  assert.match(await button.getAttribute('class'), /others/);
  await one_step(() => button.click());
  assert.deepEqual(await keys('stem.length'), [
    [0, 0.2],
    [2, 0.6, 'smooth'],
    [4, 1, 'smooth'],
  ]);
  assert.match(await button.getAttribute('class'), /here/);
  await one_step(() => type_into(page, length.getByRole('textbox', { name: 'length', exact: true }), '0.9'));
  assert.equal((await keys('stem.length'))[1][1], 0.9);
  // A drag is shown and is one step; the comments stay.
  await leave_fields(page);
  await one_step(() => drag(page, length.getByRole('textbox', { name: 'length', exact: true }), [-40, 0]));
  assert.ok((await keys('stem.length'))[1][1] < 0.9);
  assert.ok((await text_of(page)).includes('// How it opens.') && (await text_of(page)).includes('// it grows'));
  await one_step(() => button.click());
  assert.equal((await keys('stem.length')).length, 2);
  // A row without keys gets its first key; so do a colour and a handle.
  const radius = row(page, 'components.stem.radius');
  await radius.hover();
  await one_step(() => radius.getByRole('button', { name: 'Key of radius' }).click());
  assert.deepEqual(await keys('stem.radius'), [[2, 0.01]]);
  const handle = page.locator('[data-handle=opening]');
  await handle.hover();
  await one_step(() => handle.getByRole('button', { name: 'Key of opening' }).click());
  assert.deepEqual(await keys('opening'), [[2, 20]]);
  assert.equal(await page.locator('.timeline .lane-row[data-track]').count(), 3);
  assert.equal(await page.evaluate(() => window.studio.document.state.get().good), true);
  await all_back();
});

test('keys are moved in their lane, and their curve is drawn and changed', async () => {
  const key = (k) => lane('stem.length').locator('.key').nth(k);
  await one_step(() => drag(page, key(1), [-100, 0], { steps: 8 }));
  const moved = (await keys('stem.length'))[1][0];
  assert.ok(moved < 4 && moved > 2 && Math.abs(moved * 10 - Math.round(moved * 10)) < 1e-6, String(moved));
  await key(1).focus();
  await one_step(() => page.keyboard.press('ArrowRight'));
  assert.ok(Math.abs((await keys('stem.length'))[1][0] - moved - 0.1) < 1e-6);
  await lane('stem.length').locator('.lane-name').click();
  const editor = page.locator('[data-edited="stem.length"]');
  await editor.waitFor();
  assert.equal(await page.evaluate(() => window.studio.chosen.get()), 'components.stem');
  await one_step(() => drag(page, editor.locator('.curve-point').nth(0), [30, -20], { steps: 6 }));
  const [at, value] = (await keys('stem.length'))[0];
  assert.ok(at > 0 && value > 0.2, `${at} ${value}`);
  await editor.locator('.curve-point').nth(0).focus();
  await one_step(() => page.keyboard.press('+'));
  assert.equal((await keys('stem.length')).length, 3);
  await one_step(() => editor.getByRole('button', { name: 'Jump', exact: true }).click());
  assert.equal((await keys('stem.length')).filter((one) => one[2] === 'step').length, 1);
  await one_step(() => page.getByRole('button', { name: 'Remove the key of stem.length' }).click());
  await lane('stem.length').locator('.key').nth(0).focus();
  await one_step(() => page.keyboard.press('Delete'));
  await one_step(async () => {
    await lane('stem.length').locator('.key').nth(0).focus();
    await page.keyboard.press('Delete');
  });
  assert.equal((await said()).animation.keys, undefined);
  await all_back();
});

test('sequences are blocks that start with their clocks, and a hand moves their delay', async () => {
  const clocks = page.locator('[data-clock="clock"]');
  await clocks.locator('.clock-block').nth(2).waitFor({ state: 'attached' });
  const lefts = await clocks.locator('.clock-block').evaluateAll((all) => all.map((one) => parseFloat(one.style.left)));
  assert.deepEqual(
    lefts.map((one) => Math.round(one * 0.04 * 100) / 100),
    [0.5, 1.25, 2],
  );
  await one_step(() => drag(page, clocks.locator('.lane'), [100, 0], { across: 0.3, steps: 8 }));
  const { delay } = (await said()).components.clock;
  assert.ok(delay[0] > 0.5 && Math.abs(delay[1] - delay[0] - 1.5) < 1e-6, delay.join(' '));
  await page.waitForFunction(
    () => parseFloat(document.querySelector('[data-clock=clock] .clock-block').style.left) > 13,
  );
  await all_back();
});

test('playing goes on in its own time and stops; another document begins at 0', async () => {
  await scrub_to(0);
  await page.getByRole('button', { name: 'Play', exact: true }).click();
  await page.waitForFunction(() => window.studio.bench.time.time > 0.5, null, { timeout: 20000 });
  await page.getByRole('button', { name: 'Stop playing' }).click();
  const stood = await time();
  await settled(page);
  await frames(page, 20);
  assert.equal(await time(), stood);
  assert.equal(await undo_count(page), 0);
  await open_file(page, 'film.json');
  assert.equal(await time(), 0);
});

test('frames are recorded with progress, as many as the times say', async () => {
  await page.getByRole('button', { name: 'Record…' }).click();
  const dialog = page.getByRole('dialog');
  await dialog.getByRole('button', { name: 'PNG each' }).click();
  await type_into(page, dialog.getByRole('textbox', { name: 'To' }), '0.3');
  await dialog.getByRole('button', { name: '640 × 360' }).click();
  await type_into(page, dialog.getByRole('textbox', { name: 'Samples' }), '1');
  const download = page.waitForEvent('download');
  await dialog.getByRole('button', { name: 'Record 4 frames' }).click();
  const file = await (await download).path();
  await dialog.locator('.made-file').waitFor();
  const archive = await readFile(file);
  assert.equal(archive.toString('latin1').split('PK\x01\x02').length - 1, 4);
  assert.match(await dialog.locator('.made-file').innerText(), /film_000\.png/);
  await page.keyboard.press('Escape');
});

test('the camera goes into the document and comes back, and views are kept', async () => {
  const menu = async (entry) => {
    await page.locator('.view-tools').getByRole('button', { name: 'Camera' }).click();
    await page.getByRole('menuitem', { name: entry, exact: true }).click();
  };
  await page.getByRole('button', { name: 'Side', exact: true }).click();
  await one_step(() => menu('Set the document’s camera'));
  const { view } = (await said()).components;
  assert.equal(view.azimuth, undefined);
  assert.ok(
    view.position[0] > view.target[0] &&
      Math.abs(view.position[2] - view.target[2]) < 0.01 &&
      view.field_of_view === 32,
  );
  assert.equal(await page.evaluate(() => window.studio.document.state.get().good), true);
  await menu('Keep this view');
  await page.getByRole('button', { name: 'Front', exact: true }).click();
  const azimuth = () => page.evaluate(() => Math.round(window.studio.view.orbit.azimuth));
  assert.equal(await azimuth(), 180);
  await menu('View 1');
  assert.equal(await azimuth(), 90);
  await page.getByRole('button', { name: 'Top', exact: true }).click();
  await menu('Look as the document’s camera');
  assert.equal(await azimuth(), 90);
  await all_back();
});

test('a still is rendered with progress and shown in the page', async () => {
  await page.locator('.view-tools').getByRole('button', { name: 'Camera' }).click();
  await page.getByRole('menuitem', { name: 'Still…', exact: true }).click();
  const dialog = page.getByRole('dialog');
  await dialog.getByRole('button', { name: '640', exact: true }).click();
  await dialog.getByRole('button', { name: 'Quick', exact: true }).click();
  await dialog.getByRole('button', { name: 'Render', exact: true }).click();
  const picture = dialog.locator('.still-frame img');
  await picture.waitFor({ timeout: 60_000 });
  assert.equal(await picture.evaluate((image) => image.decode().then(() => image.naturalWidth)), 640);
  await page.keyboard.press('Escape');
});

test('axe finds nothing serious in the timeline, light and dark', async () => {
  await lane('stem.length').locator('.lane-name').click();
  await page.locator('.track-editor').waitFor();
  for (const theme of ['light', 'dark']) {
    await set_theme(page, theme);
    assert.deepEqual(await serious_faults(page, { colours_only: theme === 'dark' }), [], theme);
  }
  await page.emulateMedia({ colorScheme: null });
});

test('nothing was complained about on the way', async () => {
  assert.deepEqual(
    page.faults.filter((fault) => !/WebGL|GL Driver/i.test(fault)),
    [],
  );
  assert.equal((await meristem('check', path.join(place.folder, 'film.json'))).code, 0);
});
