// SPDX-License-Identifier: Apache-2.0
// The page of the studio under a user's actions, in a real browser with the real server. Checks counts, and no times.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import path from 'node:path';
import { after, before, test } from 'node:test';

import { box_faults, faint_texts, serious_faults } from './boxes.mjs';
import {
  choose,
  drag,
  field,
  leave_fields,
  open_file,
  pick,
  point_at,
  retype,
  row,
  slider,
  step,
  type_into,
  undo_all,
} from './hands.mjs';
import {
  kAxe,
  kept,
  open_page,
  ready,
  settled,
  start_browser,
  start_server,
  still,
  temporary_folder,
  text_of,
  undo_count,
  validator,
  visit,
  write_document,
} from './support.mjs';

const kSmall = `\ufeff// A sapling.\r\n{\r\n\t"meristem": 1, /* the form */\r\n\t"name": "Sapling",\r\n\t"seed": 4,\r\n\t"variables": {\r\n\t\t"size": {"value": 0.12, "min": 0.05, "max": 0.25, "unit": "m", "doc": "Length of the leaves."},\r\n\t\t"bend": {"value": 30, "min": 0, "max": 90, "doc": "How they bend."}\r\n\t},\r\n\t"components": {\r\n\t\t"tree": {"type": "tree", "length": 1.5, "radius": 0.02}, // the stem\r\n\t\t"leaf": {"type": "leaf", "length": "size", "width": "size/2", "curl": "bend + 5*rand(-1,1)", "colour": "#587a30"}\r\n\t},\r\n\t"links": [{"from": "tree", "to": "leaf", "kind": "branch", "count": 12, "angle": 60}]\r\n}\r\n`;

let place, server, browser, context, page;

before(async () => {
  place = await temporary_folder();
  await write_document(place.folder, 'small.json', kSmall);
  server = await start_server(place.folder, path.join(place.folder, 'small.json'));
  browser = await start_browser();
  context = await browser.newContext({ viewport: { width: 1280, height: 720 }, acceptDownloads: true });
  page = await open_page(context, server.address);
});

after(async () => {
  await browser?.close();
  await server?.stop();
  await place?.remove();
});

const reopen = () => open_file(page, 'small.json');

test('the document is shown as it is: name, handles, outline, plant', async () => {
  assert.equal(await page.getByRole('heading', { level: 1 }).innerText(), 'Sapling');
  assert.equal(await page.locator('.handle').count(), 2);
  assert.deepEqual(await page.locator('.outline-group').first().locator('.outline-title').allInnerTexts(), [
    'tree',
    'leaf',
  ]);
  assert.equal(await text_of(page), kSmall);
  const { batches } = await page.evaluate(() => window.studio.view.counts);
  assert.ok(batches >= 2);
});

test('a drag of 40 moves is one step, and the camera stays where it was', async () => {
  const camera = await page.evaluate(() => JSON.stringify(window.studio.view.orbit.state));
  const steps = await undo_count(page);
  await step(page, () => drag(page, slider(page, 'size'), [80, 0], { across: 0.2, steps: 40 }));
  assert.equal((await undo_count(page)) - steps, 1);
  assert.equal(await page.evaluate(() => JSON.stringify(window.studio.view.orbit.state)), camera);
});

test('dragging a field: Shift is fine, Escape puts back, and that is no step', async () => {
  await reopen();
  const across = async (pixels, lets_go) => {
    await leave_fields(page);
    await drag(page, field(page, 'bend'), [pixels, 0], { across: 0.2, lets_go });
  };
  await across(40, false);
  await page.keyboard.press('Escape');
  await page.mouse.up();
  await settled(page);
  assert.equal(await text_of(page), kSmall);
  assert.equal(await undo_count(page), 0);
  await step(page, () => across(40, true));
  const value = () =>
    page.evaluate(() => window.studio.document.state.get().variables.find((one) => one.name === 'bend').value);
  const coarse = (await value()) - 30;
  assert.ok(coarse > 1);
  await page.keyboard.down('Shift');
  await step(page, () => across(40, true));
  await page.keyboard.up('Shift');
  const fine = (await value()) - 30 - coarse;
  assert.ok(fine > 0 && fine < coarse / 5, `${fine} against ${coarse}`);
  assert.equal(await undo_count(page), 2);
});

test('undo of everything gives the first bytes, with mark, CRLF, comments and tabs', async () => {
  await reopen();
  const into = (path, name, text) =>
    step(page, () =>
      type_into(
        page,
        name === null
          ? row(page, path).locator('.text-field').first()
          : row(page, path).getByRole('textbox', { name, exact: true }),
        text,
      ),
    );
  await choose(page, 'leaf');
  await into('components.leaf.fold', 'fold', '12');
  await into('components.leaf.colour', null, '#334455');
  await choose(page, 'tree');
  await into('components.tree.radius', 'radius', '0.03');
  await choose(page, 'tree → leaf');
  await into('links[0].count', 'count', '20');
  await choose(page, 'Output');
  await into('output.samples', 'samples', '48');
  await step(page, () => type_into(page, field(page, 'Seed'), '9'));
  assert.equal(await undo_count(page), 6);
  const changed = await text_of(page);
  assert.ok(changed.includes('// the stem\r\n') && changed.includes('/* the form */'));
  await leave_fields(page);
  for (let k = 0; k < 6; k += 1) await page.keyboard.press('Control+z');
  await page.waitForFunction(() => window.studio.document.state.get().undo.done.length === 0);
  assert.equal(await text_of(page), kSmall);
  for (let k = 0; k < 6; k += 1) await page.keyboard.press('Control+Shift+z');
  await page.waitForFunction(() => window.studio.document.state.get().undo.undone.length === 0);
  assert.equal(await text_of(page), changed);
  await settled(page);
});

test('a curve: points are dragged, added, moved by keys and removed, each as one step', async () => {
  await reopen();
  await choose(page, 'tree');
  const taper = row(page, 'components.tree.taper');
  const points = taper.locator('.curve-point');
  await step(page, () => pick(page, taper, 'Set'));
  const before = await undo_count(page);
  const curve = () => page.evaluate(() => window.studio.document.state.get().tree.value.components.tree.taper.curve);
  const first = await curve();
  await step(page, () => drag(page, points.first(), [0, 20], { steps: 20 }));
  assert.ok((await curve())[0][1] < first[0][1]);
  await step(page, async () => {
    await point_at(page, taper.locator('svg[role=group]'), 0.43, 0.2);
    await page.mouse.dblclick(...(await centre(taper.locator('svg[role=group]'), 0.43, 0.2)));
  });
  assert.equal((await curve()).length, first.length + 1);
  const chosen = (await curve())[1];
  await step(page, () => page.keyboard.press('ArrowUp'));
  assert.ok((await curve())[1][1] > chosen[1]);
  await step(page, () => type_into(page, taper.getByRole('textbox', { name: 'taper, y of point 2' }), '0.25'));
  assert.equal((await curve())[1][1], 0.25);
  await step(page, () => taper.getByRole('button', { name: 'Remove the point of taper' }).click());
  assert.equal((await curve()).length, first.length);
  assert.equal((await undo_count(page)) - before, 5);
  // Escape during a drag restores the point.
  const text = await text_of(page);
  await drag(page, points.first(), [0, -15], { lets_go: false });
  await page.keyboard.press('Escape');
  await page.mouse.up();
  await settled(page);
  assert.equal(await text_of(page), text);
  await leave_fields(page);
  await undo_all(page);
  assert.equal(await text_of(page), kSmall);
});

const centre = async (target, across, down) => {
  const box = await target.boundingBox();
  return [box.x + across * box.width, box.y + down * box.height];
};

test('1,000 rapid edits: the last value wins', async () => {
  await reopen();
  // Presses arrow keys without waiting for their effects.
  const size = field(page, 'size');
  await size.click();
  const press = (key, times) => Promise.all(Array.from({ length: times }, () => page.keyboard.press(key)));
  for (let k = 0; k < 5; k += 1) {
    await press('ArrowUp', 92);
    await press('ArrowDown', 92);
  }
  await press('ArrowUp', 80);
  await page.waitForFunction(() => Object.keys(window.studio.dragged.get()).length === 0);
  await settled(page);
  assert.match(await text_of(page), /"size": \{"value": 0\.2,/);
  const { sent } = await page.evaluate(() => window.studio.connection.counts);
  assert.ok(sent < 2500, `${sent} requests`);
  await leave_fields(page);
  await undo_all(page);
  assert.equal(await text_of(page), kSmall);
  await settled(page);
});

test('expressions, ranges and arithmetic are typed into fields, a fault stands under its row', async () => {
  await reopen();
  await choose(page, 'tree');
  const length = row(page, 'components.tree.length').getByRole('textbox', { name: 'length', exact: true });
  await step(page, () => type_into(page, length, '3/2+0.25'));
  assert.match(await text_of(page), /"length": 1\.75,/);
  await type_into(page, length, 'size*nothing');
  const fault = page.locator('[data-path="components.tree.length"] .fault-line');
  await fault.waitFor();
  assert.match(await fault.innerText(), /nothing/);
  await leave_fields(page);
  await undo_all(page);
  await settled(page);
});

test('typing faulty text keeps the plant, marks the fault, and completion knows the tables', async () => {
  await reopen();
  await page.keyboard.press('t');
  const editor = page.getByRole('textbox', { name: 'Text of the document' });
  await editor.waitFor();
  const before_it = await page.evaluate(() => window.studio.view.counts.batches);
  await retype(page, '"width"', '"widht"');
  await page.locator('.fault-list button').first().waitFor();
  assert.match(await page.locator('.fault-list').innerText(), /width/);
  assert.equal(await page.evaluate(() => window.studio.view.counts.batches), before_it);
  await leave_fields(page);
  await undo_all(page);
  await settled(page);
  assert.equal(await text_of(page), kSmall);
  await page.getByRole('button', { name: 'Inspector' }).click();
});

test('a reload offers unsaved work with what differs, and gives it back with its undo list', async () => {
  await reopen();
  await step(page, () => type_into(page, field(page, 'bend'), '77'));
  const text = await text_of(page);
  await kept(page);
  await page.reload();
  await ready(page);
  const banner = page.locator('[data-banner="kept"]');
  await banner.waitFor();
  await banner.getByRole('button', { name: 'Show what differs' }).click();
  assert.match(await banner.locator('.added').innerText(), /77/);
  await banner.getByRole('button', { name: 'Restore' }).click();
  await settled(page);
  assert.equal(await text_of(page), text);
  assert.equal(await undo_count(page), 1);
  await undo_all(page);
  assert.equal(await text_of(page), kSmall);
  await settled(page);
});

test('work is kept also where another plant is opened at once', async () => {
  await reopen();
  await write_document(place.folder, 'other.json', kSmall.replace('Sapling', 'Other'));
  await type_into(page, field(page, 'bend'), '71');
  await open_file(page, 'other.json');
  assert.equal(await page.getByRole('heading', { level: 1 }).innerText(), 'Other');
  await page.getByText('Unsaved changes of small.json are kept').waitFor();
  await page.keyboard.press('Control+o');
  await page.getByRole('dialog').locator('.file', { hasText: 'small.json' }).click();
  await page.locator('[data-banner="kept"]').getByRole('button', { name: 'Restore' }).click();
  await settled(page);
  assert.match(await text_of(page), /"bend": \{"value": 71,/);
  await undo_all(page);
  assert.equal(await text_of(page), kSmall);
});

test('undo in a field takes back what is typed there, and no step', async () => {
  await reopen();
  await step(page, () => type_into(page, field(page, 'bend'), '44'));
  await choose(page, 'Document');
  const name = row(page, 'name').getByRole('textbox');
  await name.click();
  await page.keyboard.press('End');
  await page.keyboard.type('s');
  assert.equal(await name.inputValue(), 'Saplings');
  await page.keyboard.press('Control+z');
  assert.equal(await name.inputValue(), 'Sapling');
  assert.equal(await undo_count(page), 1);
  await page.keyboard.press('Escape');
  await leave_fields(page);
  await undo_all(page);
});

test('panels are made wider by their edges, by hand and by keys, and stay so', async () => {
  const left = page.locator('.left');
  const edge = page.getByRole('separator', { name: 'Width of handles and outline' });
  const width = async () => (await left.boundingBox()).width;
  const first = await width();
  await drag(page, edge, [60, 0]);
  assert.equal(await width(), first + 60);
  await edge.focus();
  await page.keyboard.press('ArrowLeft');
  assert.equal(await width(), first + 44);
  await page.reload();
  await ready(page);
  assert.equal(await width(), first + 44);
  await edge.dblclick();
  assert.equal(await width(), first);
});

test('a killed server loses nothing', async () => {
  const other = await start_server(place.folder, path.join(place.folder, 'small.json'), '--port', '0');
  const { port } = new URL(other.address);
  const lone = await open_page(context, other.address);
  await step(lone, () => type_into(lone, field(lone, 'bend'), '66'));
  await kept(lone);
  await other.stop('SIGKILL');
  await lone.getByText('The server is gone.').waitFor();
  assert.match(await text_of(lone), /"bend": \{"value": 66,/);
  // Typing continues without the server.
  await leave_fields(lone);
  await lone.keyboard.press('t');
  await retype(lone, 'Sapling', 'Whip');
  await kept(lone);
  const text = await text_of(lone);
  const again = await start_server(place.folder, path.join(place.folder, 'small.json'), '--port', port);
  await visit(lone, again.address);
  await lone.locator('[data-banner="kept"]').getByRole('button', { name: 'Restore' }).click();
  await settled(lone);
  assert.equal(await text_of(lone), text);
  await lone.close();
  await again.stop();
});

test('saving asks where someone else has changed the file', async () => {
  await reopen();
  await step(page, () => type_into(page, field(page, 'bend'), '50'));
  await write_document(place.folder, 'small.json', kSmall.replace('30', '31'));
  await page.keyboard.press('Control+s');
  await page.locator('[data-banner="conflict"]').waitFor();
  assert.match(await readFile(path.join(place.folder, 'small.json'), 'utf8'), /31/);
  await page.getByRole('button', { name: 'Save anyway' }).click();
  await page.waitForFunction(() => !window.studio.document.is_changed);
  assert.equal(await readFile(path.join(place.folder, 'small.json'), 'utf8'), await text_of(page));
  await write_document(place.folder, 'small.json', kSmall);
});

test('exported GLB is accepted by the validator and has the triangles that there are', async () => {
  await reopen();
  await page.keyboard.press('Control+e');
  await page.getByRole('radio', { name: /glb/ }).first().check();
  const arrives = page.waitForEvent('download');
  await page.getByRole('dialog').getByRole('button', { name: 'Export', exact: true }).click();
  const file = path.join(place.folder, 'got.glb');
  await (await arrives).saveAs(file);
  const report = await validator.validateBytes(new Uint8Array(await readFile(file)));
  assert.equal(report.issues.numErrors, 0, JSON.stringify(report.issues.messages));
  const { triangles } = await page.evaluate(() => window.studio.growth.get().grown);
  assert.equal(report.info.totalTriangleCount, triangles);
  await page.getByRole('button', { name: 'Close' }).click();
});

test('the keyboard alone opens a plant, turns a handle, chooses a component and undoes', async () => {
  await reopen();
  const press = (...keys) => keys.reduce((all, key) => all.then(() => page.keyboard.press(key)), Promise.resolve());
  await leave_fields(page);
  const focused = () =>
    page.evaluate(
      () => document.activeElement?.getAttribute('aria-label') ?? document.activeElement?.textContent ?? '',
    );
  for (let k = 0; k < 60 && (await focused()) !== 'size, slider'; k += 1) await press('Tab');
  assert.equal(await focused(), 'size, slider');
  await press('ArrowRight', 'ArrowRight');
  await settled(page);
  assert.notEqual(await text_of(page), kSmall);
  for (let k = 0; k < 60 && !(await focused()).startsWith('tree'); k += 1) await press('Tab');
  await press('ArrowDown', 'Enter');
  assert.equal(await page.evaluate(() => window.studio.chosen.get()), 'components.leaf');
  for (let k = 0; k < 4 && (await undo_count(page)) > 0; k += 1) {
    await press('Control+z');
    await settled(page);
  }
  assert.equal(await text_of(page), kSmall);
  await press('?');
  await page.getByRole('dialog').waitFor();
  await press('Escape');
  await page.getByRole('dialog').waitFor({ state: 'detached' });
  await press('Control+m');
  await page.locator('.model').first().waitFor();
  await page.keyboard.type('mint');
  await press('Tab', 'Enter');
  await page.waitForFunction(() => window.studio.document.state.get().model === 'mint', null, { timeout: 20000 });
  await settled(page);
});

/// The views to check, with the actions that open and close them.
const kViews = [
  ['an outline', () => choose(page, 'Document')],
  ['a component', () => choose(page, 'leaf')],
  ['a link', () => choose(page, 'tree → leaf')],
  ['the scene', () => choose(page, 'Scene')],
  [
    'the text',
    () => page.getByRole('button', { name: 'Text', exact: true }).click(),
    () => page.getByRole('button', { name: 'Inspector', exact: true }).click(),
  ],
  ...[
    ['export', 'Control+e', 'dialog'],
    ['keys', '?', 'dialog'],
    ['models', 'Control+m', '.model'],
    ['files', 'Control+o', '.file'],
    ['a name to save under', 'Control+Shift+s', 'dialog'],
  ].map(([name, keys, shown]) => [
    name,
    async () => {
      await page.keyboard.press(keys);
      await page.locator(shown).first().waitFor(); // lists come from the server
    },
    () => page.keyboard.press('Escape'),
  ]),
];

test('axe finds nothing serious, light and dark', async () => {
  await reopen();
  for (const theme of ['light', 'dark']) {
    await page.emulateMedia({ colorScheme: theme });
    for (const [name, come, go] of kViews) {
      await leave_fields(page);
      await come();
      await still(page);
      assert.deepEqual(await serious_faults(page, { colours_only: theme === 'dark' }), [], `${theme}, ${name}`);
      await go?.();
    }
  }
  await page.emulateMedia({ colorScheme: null });
});

test('the theme button goes round, and the choice stays', async () => {
  const shown = () => page.evaluate(() => document.documentElement.dataset.theme);
  const button = page.getByRole('button', { name: /^Theme: / });
  await button.click();
  assert.equal(await shown(), 'light');
  await button.click();
  assert.equal(await shown(), 'dark');
  await page.reload();
  await ready(page);
  assert.equal(await shown(), 'dark');
  await button.click();
  assert.equal(await shown(), 'light');
});

test('what is drawn goes when it is gone, and comes back after a lost context', async () => {
  await reopen();
  // Buffers are counted after the drawing.
  const counts = () =>
    page.evaluate(async () => {
      await window.studio.view.drawn();
      return window.studio.view.counts;
    });
  const first = await counts();
  for (let k = 0; k < 5; k += 1) await step(page, () => type_into(page, field(page, 'size'), `0.1${k + 3}`));
  const later = await counts();
  for (const name of ['meshes', 'instance_sets', 'batches', 'geometries', 'materials', 'pictures'])
    assert.ok(later[name] <= first[name] + 1, `${name}: ${first[name]} ${later[name]}`);
  const packets = await page.evaluate(() => {
    const lost = document.querySelector('.view canvas').getContext('webgl2').getExtension('WEBGL_lose_context');
    lost.loseContext();
    setTimeout(() => lost.restoreContext(), 100);
    return window.studio.connection.counts.packets;
  });
  await page.waitForFunction((known) => window.studio.connection.counts.packets > known, packets);
  await settled(page);
  assert.equal((await counts()).batches, later.batches);
});

test('a colour edit crosses in under 2 KB', async () => {
  await reopen();
  await choose(page, 'leaf');
  await step(page, () => type_into(page, row(page, 'components.leaf.colour').locator('.text-field'), '#885522'));
  const { last_packet_bytes } = await page.evaluate(() => window.studio.connection.counts);
  assert.ok(last_packet_bytes < 2048, `${last_packet_bytes} bytes`);
});

test('texts of a document are shown as texts', async () => {
  const evil = kSmall
    .replace('"Sapling"', '"<img src=x onerror=window.harm=1>"')
    .replace('Length of the leaves.', '<script>window.harm=1</script>');
  await write_document(place.folder, 'evil.json', evil);
  await open_file(page, 'evil.json');
  assert.equal(await page.getByRole('heading', { level: 1 }).innerText(), '<img src=x onerror=window.harm=1>');
  assert.equal(await page.evaluate(() => window.harm), undefined);
});

test('all has room on small and large screens, and can be read in both themes', async () => {
  const axe = await readFile(kAxe, 'utf8');
  await open_file(page, 'small.json');
  await choose(page, 'leaf');
  const panels = [
    ['growth', 's'],
    ['timeline', 'k'],
    ['board', 'b'],
  ]; // what a key opens over or beside the view, and closes
  for (const [width, height] of [
    [2560, 1440],
    [1280, 720],
  ]) {
    await page.setViewportSize({ width, height });
    for (const colorScheme of ['dark', 'light']) {
      await page.emulateMedia({ colorScheme });
      for (const [name, key] of panels) {
        await leave_fields(page);
        await page.keyboard.press(key);
        await page.evaluate(() => window.studio.view.drawn());
        assert.deepEqual(await box_faults(page), [], `${name}, ${width}, ${colorScheme}`);
        if (height < 800 && colorScheme === 'dark') assert.deepEqual(await faint_texts(page, axe), [], name);
        await page.keyboard.press(key);
      }
    }
  }
  const wrong = await page.addStyleTag({
    content: '.view-axes { right: auto; left: 12px; } .top-bar h1 { font-size: 9px; }',
  });
  const faults = (await box_faults(page)).join('\n');
  assert.match(faults, /one over the other: div\.view-tools.*view-axes/);
  assert.match(faults, /tiny: span.*"Sapling"/);
  await wrong.evaluate((element) => element.remove());
});

test('nothing was complained about on the way', () => {
  assert.deepEqual(
    page.faults.filter((fault) => !/WebGL|GL Driver|CONTEXT_LOST|Failed to load resource|Refused to/i.test(fault)),
    [],
  );
});

test('first visit: the oak is there with three hints', async () => {
  const fresh = await browser.newContext({ viewport: { width: 1280, height: 720 } });
  const lone = await start_server(place.folder);
  const first = await open_page(fresh, lone.address);
  assert.equal(await first.getByRole('heading', { level: 1 }).innerText(), 'Oak');
  assert.equal(await first.locator('.hints li').count(), 3);
  assert.deepEqual(await box_faults(first), []);
  await fresh.close();
  await lone.stop();
});
