// SPDX-License-Identifier: Apache-2.0
// Editors of curves, polygons, silhouettes, axes, selections, colours and pictures, by hand: each gesture is one step,
// and undoing all of them gives the first bytes.
import assert from 'node:assert/strict';
import { cp } from 'node:fs/promises';
import path from 'node:path';
import { after, before, test } from 'node:test';

import { serious_faults } from './boxes.mjs';
import { choose, drag, leave_fields, open_file, pick, point_at, row, step, type_into, undo_all } from './hands.mjs';
import {
  kSource,
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

const kShapes = `{
  "meristem": 1, // shapes of all forms
  "components": {
    "view": {"type": "camera", "position": [0, 1, 4], "target": [0, 0.6, 0]},
    "stem": {"type": "tree", "length": 1, "radius": 0.03, "axis": [[0.05, 0.2, 0], [0.2, 0.5, 0], [0, 1, 0.1]], "taper": {"curve": [[0, 1], [0.5, 0.8], [1, 0.4]]}},
    "rod": {"type": "horn", "length": 0.5, "radius": 0.1, "section": "outline", "outline": [[1, 0], [0, 1], [-1, 0], [0, -1]]},
    "cup": {"type": "revolution", "silhouette": [[0.02, 0], [0.08, 0.1], [0.06, 0.2]], "colour": "#aa5533"},
    "leaf": {"type": "leaf", "length": 0.2, "width": 0.08, "colour": "#557733", "omit": [1]}
  },
  "links": [["view", "stem"], ["view", "rod"], ["view", "cup"], {"from": "stem", "to": "leaf", "kind": "branch", "count": 8}]
}
`;

let place, server, browser, page;

before(async () => {
  place = await temporary_folder();
  await write_document(place.folder, 'shapes.json', kShapes);
  await cp(path.join(kSource, 'tests/fuzz/corpus/image/rgba.png'), path.join(place.folder, 'bark.png'));
  await cp(path.join(kSource, 'tests/fuzz/corpus/image/rgba.png'), path.join(place.folder, 'wood.png'));
  server = await start_server(place.folder, path.join(place.folder, 'shapes.json'));
  browser = await start_browser();
  page = await open_page(await browser.newContext({ viewport: { width: 1280, height: 800 } }), server.address);
});

after(async () => {
  await browser?.close();
  await server?.stop();
  await place?.remove();
});

const said = (component) =>
  page.evaluate((name) => window.studio.document.state.get().tree.value.components[name], component);
const drawer = () => page.locator('.drawer');

/// Opens a row's editor large, below the view.
async function enlarge(component, name) {
  await choose(page, component);
  const target = row(page, `components.${component}.${name}`);
  await target.scrollIntoViewIfNeeded();
  await target.hover();
  await target.getByRole('button', { name: `Enlarge ${name}` }).click();
  await drawer().waitFor();
  await still(page);
}

/// Does what changes the text as one step of the undo list.
async function one_step(act) {
  const count = await undo_count(page);
  await step(page, act);
  assert.equal((await undo_count(page)) - count, 1);
}

async function all_back() {
  await leave_fields(page);
  await undo_all(page);
  assert.equal(await text_of(page), kShapes);
  await settled(page);
}

test('a polygon is closed, and keeps three points', async () => {
  await enlarge('rod', 'outline');
  const ring = drawer().locator('svg.plane');
  const points = ring.locator('.curve-point');
  assert.equal(await points.count(), 4);
  const line = (await ring.locator('.curve-line').first().getAttribute('points')).split(' ');
  assert.equal(line.length, 5);
  assert.equal(line[0], line[4]);
  await one_step(() => drag(page, points.first(), [-30, -20], { steps: 12 }));
  const [[x, y]] = (await said('rod')).outline;
  assert.ok(x < 1 && y > 0);
  await points.nth(3).focus();
  await one_step(() => page.keyboard.press('+'));
  assert.equal((await said('rod')).outline.length, 5);
  for (let left = 4; left >= 3; left -= 1) await one_step(() => page.keyboard.press('Delete'));
  await page.keyboard.press('Delete');
  assert.equal((await said('rod')).outline.length, 3);
  await all_back();
});

test('a silhouette shows both sides', async () => {
  await enlarge('cup', 'silhouette');
  const lines = drawer().locator('.curve-line');
  assert.equal(await lines.count(), 3);
  const mirror = await drawer().locator('.curve-line.mirror').getAttribute('points');
  assert.notEqual(mirror, await drawer().locator('.curve-line.line').getAttribute('points'));
  await drawer().locator('.curve-point').nth(1).focus();
  await one_step(() => page.keyboard.press('ArrowRight'));
  assert.ok((await said('cup')).silhouette[1][0] > 0.08);
  await one_step(() => type_into(page, drawer().getByRole('textbox', { name: 'silhouette, y of point 2' }), '0.12'));
  assert.equal((await said('cup')).silhouette[1][1], 0.12);
  await all_back();
});

test('the outline of a leaf stays within the limits of its two numbers, which are drawn', async () => {
  const text = kShapes.replace('"omit": [1]', '"polygon": [[0, 0], [0.6, 0.3], [0.5, 0.6], [0, 1]]');
  await write_document(place.folder, 'lobed.json', text);
  await open_file(page, 'lobed.json');
  await enlarge('leaf', 'polygon');
  const widest = drawer().locator('.curve-point').nth(1);
  for (const name of ['x-low', 'x-high'])
    assert.equal(await drawer().locator(`[data-limit="${name}"]`).count(), 1, name);
  await one_step(() => drag(page, widest, [400, 0], { steps: 12 }));
  assert.equal((await said('leaf')).polygon[1][0], 1, 'the largest half width');
  await one_step(() => drag(page, drawer().locator('.curve-point').nth(2), [12, 0])); // the fields show the point that was moved last
  await one_step(() => type_into(page, drawer().getByRole('textbox', { name: 'polygon, x of point 3' }), '1.445'));
  assert.equal((await said('leaf')).polygon[2][0], 1);
  await one_step(() => type_into(page, drawer().getByRole('textbox', { name: 'polygon, y of point 3' }), '1.2'));
  assert.equal((await said('leaf')).polygon[2][1], 1.2, 'along the leaf there is more room');
  await leave_fields(page);
  await undo_all(page);
  assert.equal(await text_of(page), text);
  await open_file(page, 'shapes.json');
});

test('a hand is drawn to the grid and to other points, unless Alt is held', async () => {
  await enlarge('stem', 'taper');
  const points = drawer().locator('.curve-point');
  // Move the middle point nearly to the height of the first, at 1.
  const [first, middle] = [await points.nth(0).boundingBox(), await points.nth(1).boundingBox()];
  const up = first.y - middle.y + 2;
  await point_at(page, points.nth(1));
  await page.mouse.down();
  const at = { x: middle.x + middle.width / 2, y: middle.y + middle.height / 2 };
  await page.mouse.move(at.x + 7, at.y + up, { steps: 4 });
  assert.ok((await drawer().locator('.curve-guides line').count()) > 0);
  await step(page, () => page.mouse.up());
  assert.equal((await said('stem')).taper.curve[1][1], 1);
  await page.keyboard.press('Control+z');
  await settled(page);
  await point_at(page, points.nth(1));
  await page.mouse.down();
  await page.keyboard.down('Alt');
  await page.mouse.move(at.x + 7, at.y + up, { steps: 4 });
  assert.equal(await drawer().locator('.curve-guides line').count(), 0);
  await step(page, () => page.mouse.up());
  await page.keyboard.up('Alt');
  assert.notEqual((await said('stem')).taper.curve[1][1], 1);
  await all_back();
});

test('an axis in space is seen from two sides, and a hand moves two of three numbers', async () => {
  await enlarge('stem', 'axis');
  const planes = drawer().locator('svg.plane');
  assert.equal(await planes.count(), 2);
  await one_step(() => drag(page, planes.nth(0).locator('.curve-point').nth(1), [20, 0], { steps: 8 }));
  const [, [x, y, z]] = (await said('stem')).axis;
  assert.ok(x > 0.2 && Math.abs(y - 0.5) < 0.05 && z === 0, `${x} ${y} ${z}`);
  await one_step(() => drag(page, planes.nth(1).locator('.curve-point').nth(1), [-20, 0], { steps: 8 }));
  const moved = (await said('stem')).axis[1];
  assert.ok(moved[0] === x && moved[2] > 0, moved.join(' '));
  await planes.nth(0).locator('.curve-point').nth(2).focus();
  await one_step(() => page.keyboard.press('+'));
  assert.equal((await said('stem')).axis.length, 4);
  await one_step(() => page.keyboard.press('Delete'));
  await one_step(() => type_into(page, drawer().getByRole('textbox', { name: 'axis 3, x', exact: true }), '0.3'));
  assert.equal((await said('stem')).axis[2][0], 0.3);
  await all_back();
});

test('instances are taken out and in by cells, drawn across and by keys', async () => {
  await choose(page, 'leaf');
  const cells = row(page, 'components.leaf.omit').locator('.cell');
  assert.equal(await cells.count(), 8);
  const box = async (k) => {
    const { x, y, width, height } = await cells.nth(k).boundingBox();
    return [x + width / 2, y + height / 2];
  };
  await one_step(async () => {
    await cells.nth(3).scrollIntoViewIfNeeded();
    await page.mouse.move(...(await box(3)));
    await page.mouse.down();
    for (const k of [4, 5, 6]) await page.mouse.move(...(await box(k)));
    await page.mouse.up();
  });
  assert.deepEqual((await said('leaf')).omit, [1, [3, 6]]);
  await cells.nth(1).focus();
  await one_step(() => page.keyboard.press(' '));
  assert.deepEqual((await said('leaf')).omit, [[3, 6]]);
  await page.keyboard.press('End');
  await one_step(() => page.keyboard.press('Enter'));
  assert.deepEqual((await said('leaf')).omit, [[3, 7]]);
  await all_back();
});

test('a colour is picked by hand, by keys and from the colours of the document', async () => {
  await choose(page, 'leaf');
  const colour = row(page, 'components.leaf.colour');
  await colour.getByRole('button', { name: 'colour, picker' }).click();
  const square = colour.locator('.colour-square');
  await one_step(() => drag(page, square, [20, -20], { steps: 15 }));
  const picked = (await said('leaf')).colour;
  assert.match(picked, /^#[0-9a-f]{6}$/);
  assert.notEqual(picked, '#557733');
  await square.focus();
  await one_step(() => page.keyboard.press('ArrowUp'));
  await one_step(() => colour.getByRole('button', { name: 'Take #aa5533 for colour' }).click());
  assert.equal((await said('leaf')).colour, '#aa5533');
  // Escape while the hand is down puts back.
  const text = await text_of(page);
  await square.focus();
  await drag(page, square, [-20, 10], { lets_go: false });
  await page.keyboard.press('Escape');
  await page.mouse.up();
  await settled(page);
  assert.equal(await text_of(page), text);
  await colour.getByRole('button', { name: 'colour, picker' }).click();
  await all_back();
});

test('pictures that the document names are seen in their rows and in the list of files', async () => {
  await choose(page, 'leaf');
  await page.locator('[data-path="components.leaf.texture"] > .fold-head > .fold-title').click();
  await page.locator('[data-path="components.leaf.texture.picture"] > .fold-head > .fold-title').click();
  const file = row(page, 'components.leaf.texture.picture.colour');
  await file.getByRole('button', { name: /^Choose a file/ }).click();
  await page.getByRole('dialog').locator('img.thumbnail').first().waitFor();
  await one_step(() => page.getByRole('dialog').locator('.file', { hasText: 'bark.png' }).click());
  assert.equal((await said('leaf')).texture.picture.colour, 'bark.png');
  await file.locator('img.thumbnail').waitFor();
  const { naturalWidth } = await file
    .locator('img.thumbnail')
    .evaluate((image) => ({ naturalWidth: image.naturalWidth }));
  assert.ok(naturalWidth > 0 && naturalWidth <= 96);
  await all_back();
});

test('a list of colours is had large: moved, added, taken out and picked by hand and by keys', async () => {
  const text = kShapes.replace(
    '"omit": [1]',
    '"omit": [1], "colours": ["#203010", "#557733", "#aabb66"], "colour_at": "i/n"',
  );
  await write_document(place.folder, 'colours.json', text);
  await open_file(page, 'colours.json');
  await enlarge('leaf', 'colours');
  const band = drawer().locator('.band-colour');
  const colours = async () => (await said('leaf')).colours;
  assert.equal(await band.count(), 3);
  const { width } = await band.first().boundingBox();
  await one_step(() => drag(page, band.first(), [2 * width, 0], { steps: 12 }));
  assert.deepEqual(await colours(), ['#557733', '#aabb66', '#203010']);
  await band.nth(2).focus();
  await one_step(() => page.keyboard.press('Alt+ArrowLeft'));
  assert.deepEqual(await colours(), ['#557733', '#203010', '#aabb66']);
  await one_step(() => page.keyboard.press('+'));
  assert.deepEqual(await colours(), ['#557733', '#203010', '#203010', '#aabb66']);
  await one_step(() => drag(page, drawer().locator('.colour-square'), [30, -10], { steps: 8 }));
  assert.notEqual((await colours())[2], '#203010');
  await one_step(() => type_into(page, drawer().getByRole('textbox', { name: 'colours 3' }), '#ff8800'));
  assert.equal((await colours())[2], '#ff8800');
  await band.nth(2).focus();
  await one_step(() => page.keyboard.press('Delete'));
  assert.deepEqual(await colours(), ['#557733', '#203010', '#aabb66']);
  // Escape while the hand is down puts back.
  const now = await text_of(page);
  await drag(page, band.first(), [width, 0], { steps: 6, lets_go: false });
  await page.keyboard.press('Escape');
  await page.mouse.up();
  await settled(page);
  assert.equal(await text_of(page), now);
  await leave_fields(page);
  await undo_all(page);
  assert.equal(await text_of(page), text);
  await open_file(page, 'shapes.json');
});

test('a picture is had large, with the pictures of the folder beside it', async () => {
  await choose(page, 'leaf');
  for (const at of ['texture', 'texture.picture']) {
    const fold = page.locator(`[data-path="components.leaf.${at}"] > .fold-head > .fold-title`);
    if ((await fold.getAttribute('aria-expanded')) === 'false') await fold.click();
  }
  const file = row(page, 'components.leaf.texture.picture.colour');
  await one_step(() => type_into(page, file.getByRole('textbox').first(), 'bark.png'));
  await file.hover();
  await file.getByRole('button', { name: 'Enlarge colour' }).click();
  await drawer().locator('.picture-preview img').waitFor();
  assert.match(await drawer().locator('figcaption').innerText(), /\d+ × \d+ pixels/);
  await drawer().locator('.file img.thumbnail').first().waitFor();
  await one_step(() => drawer().locator('.file', { hasText: 'wood.png' }).click());
  assert.equal((await said('leaf')).texture.picture.colour, 'wood.png');
  await all_back();
});

test('rows that exclude each other: setting one removes the other, as one step', async () => {
  const text = kShapes
    .replace(
      '"stem": {"type": "tree"',
      '"apple": {"type": "organize", "iterations": 3, "operations": [{"do": "cut", "at": 2, "shoots": "leader", "above": 4}]},\n    "stem": {"type": "tree"',
    )
    .replace('["view", "rod"]', '["view", "apple"], ["view", "rod"]');
  await write_document(place.folder, 'apple.json', text);
  await open_file(page, 'apple.json');
  await choose(page, 'apple');
  for (const at of ['operations', 'operations[0]'])
    await page.locator(`[data-path="components.apple.${at}"] > .fold-head > .fold-title`).click();
  const operation = async () => (await said('apple')).operations[0];
  const lateral = row(page, 'components.apple.operations[0].above_lateral');
  await one_step(() => type_into(page, lateral.getByRole('textbox').first(), '3'));
  assert.deepEqual(await operation(), { do: 'cut', at: 2, shoots: 'leader', above_lateral: 3 });
  await one_step(() =>
    type_into(page, row(page, 'components.apple.operations[0].from').getByRole('textbox').first(), '2'),
  );
  assert.deepEqual(await operation(), { do: 'cut', shoots: 'leader', above_lateral: 3, from: 2 });
  // Also if a value below a row is given for the first time.
  await page.locator('[data-path="components.apple.operations[0].to_bud"] > .fold-head > .fold-title').click();
  const bud = page.locator('[data-path="components.apple.operations[0].to_bud"] .fold-body .row').first();
  await one_step(() => pick(page, bud, 'Set'));
  assert.equal((await operation()).above_lateral, undefined);
  assert.notEqual((await operation()).to_bud, undefined);
  await leave_fields(page);
  await undo_all(page);
  assert.equal(await text_of(page), text);
  await open_file(page, 'shapes.json');
});

test('the large editor goes with Escape and with what it edits', async () => {
  await enlarge('cup', 'silhouette');
  await drawer().locator('.curve-point').first().focus();
  await page.keyboard.press('Escape');
  await drawer().waitFor({ state: 'detached' });
  await enlarge('leaf', 'colour');
  await open_file(page, 'shapes.json');
  await drawer().waitFor({ state: 'detached' });
});

test('axe finds nothing serious in the editors, light and dark', async () => {
  for (const theme of ['light', 'dark']) {
    await page.emulateMedia({ colorScheme: theme });
    for (const [component, name] of [
      ['stem', 'taper'],
      ['stem', 'axis'],
      ['rod', 'outline'],
      ['cup', 'silhouette'],
      ['leaf', 'colour'],
      ['leaf', 'omit'],
    ]) {
      await enlarge(component, name);
      assert.deepEqual(
        await serious_faults(page, { colours_only: theme === 'dark' }),
        [],
        `${theme}, ${component}.${name}`,
      );
    }
  }
  await page.emulateMedia({ colorScheme: null });
});

test('nothing was complained about on the way', () => {
  assert.deepEqual(
    page.faults.filter((fault) => !/WebGL|GL Driver/i.test(fault)),
    [],
  );
});
