// SPDX-License-Identifier: Apache-2.0
// A tour of the studio: each request that the protocol lists is sent at least once, and its answer is checked.
// The list of requests is read from the protocol's table. A new request makes the soak fail until the tour sends it.
import assert from 'node:assert/strict';
import { copyFile, readFile } from 'node:fs/promises';
import path from 'node:path';
import {
  choose_from_files,
  leave_fields,
  open_file,
  open_model,
  save_as,
  save_here,
  start_new,
  step,
  type_into,
  undo_all,
} from '../tests/studio/page/hands.mjs';
import { kSource, settled, text_of, write_document } from '../tests/studio/page/support.mjs';
import { kFileNames, kPlantNames, name_the_plant } from './studio_actions.mjs';

/// A small document in which each question of the page has an answer.
const kTourDocument = `// Ein Garten für die Probe: 樹, 🌳.
{
  "meristem": 1,
  "name": "Tour · 樹",
  "seed": 4,
  "variables": {"tall": {"value": 0.6, "min": 0.3, "max": 1, "doc": "Height of the box."}},
  "scene": {"sun": {"azimuth": 90, "altitude": 45}, "obstacles": [{"box": [[-3, 0, -2], [-2, "tall", -1]]}]},
  "animation": {"length": 4, "keys": {"leaf.curl": [[0, 0], [4, 60]]}},
  "components": {
    "view": {"type": "camera"},
    "tree": {"type": "colonize", "crown": {"sphere": {"centre": [0, 1, 0], "radius": 0.5}}, "points": 60, "step": 0.06, "influence": 0.8, "kill": 0.16, "iterations": 18},
    "pear": {"type": "organize", "frame": {"translate": [2, 0, 0]}, "iterations": 9, "operations": [{"do": "cut", "at": 8, "shoots": "leader", "above": 5}]},
    "weed": {"type": "lsystem", "frame": {"translate": [0, 0, 2]}, "grammar": ["F", "#rules", "F -> F[+F]F"], "steps": 2, "length": 0.1},
    "blade": {"type": "grassleaf", "frame": {"translate": [0, 0, 1]}, "midrib_points": [[0, 0], [0.1, 0.3], [0.3, 0.4]]},
    "clock": {"type": "sequence", "delay": 1},
    "leaf": {"type": "leaf", "frame": {"translate": [1, 0, 1]}, "length": 0.3, "width": 0.2, "texture": {"picture": {"colour": "bark.jpg"}}}
  },
  "links": [["view", "tree"], ["view", "pear"], ["view", "weed"], ["view", "blade"], ["view", "clock"], ["clock", "leaf"]]
}
`;
const kTourFile = 'tour 樹.json';
const kWhole = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0];

/// The names of the requests in the table of the protocol.
export async function protocol_requests() {
  const text = await readFile(path.join(kSource, 'apps/studio/protocol.md'), 'utf8');
  const table = /^## Requests of the page\n([\s\S]*?)\n\n(?!\|)(?=[^|\n])/m.exec(text)?.[1] ?? '';
  const names = [...table.matchAll(/^\| `([a-z_]+)`/gm)].map((found) => found[1]).filter((name) => name !== 'do');
  assert.ok(
    names.includes('open') && names.includes('sweep'),
    `the protocol's table of requests was not found: ${names}`,
  );
  return names;
}

/// Sends a request over the page's own connection, and returns the answer.
const ask = (page, what, members = {}) =>
  page.evaluate(
    async ([name, rest]) => {
      const { arrays, ...answer } = await window.studio.connection.request(name, rest);
      return answer;
    },
    [what, members],
  );

async function bytes_of(folder, name) {
  return readFile(path.join(folder, name), 'utf8');
}

async function roll_the_seed(page) {
  await leave_fields(page);
  await step(page, () => page.keyboard.press('r'));
}

async function starts_saves_and_saves_again(page, { folder }) {
  await start_new(page);
  await roll_the_seed(page);
  await save_as(page, kFileNames[1]);
  const first = await text_of(page);
  assert.equal(await bytes_of(folder, kFileNames[1]), first);
  await roll_the_seed(page);
  await save_here(page);
  assert.notEqual(await text_of(page), first);
  assert.equal(await bytes_of(folder, kFileNames[1]), await text_of(page));
}

async function saves_a_shipped_plant_and_saves_again(page, { folder }) {
  await open_model(page, 'low-poly-shrub');
  const shipped = await text_of(page);
  await save_as(page, kFileNames[3]);
  assert.equal(await bytes_of(folder, kFileNames[3]), shipped);
  await step(page, () => name_the_plant(page, kPlantNames[2]));
  const changed = await text_of(page);
  await save_here(page);
  assert.equal(await bytes_of(folder, kFileNames[3]), changed);
  await leave_fields(page);
  await undo_all(page);
  await save_here(page);
  assert.equal(await bytes_of(folder, kFileNames[3]), shipped);
}

async function saves_over_another_file(page, { folder }) {
  await write_document(folder, kFileNames[4], '{"meristem": 1}');
  await save_as(page, kFileNames[4], 'Do not save');
  assert.equal(await bytes_of(folder, kFileNames[4]), '{"meristem": 1}');
  await save_as(page, kFileNames[4], 'Save anyway');
  assert.equal(await bytes_of(folder, kFileNames[4]), await text_of(page));
}

async function reopens_what_was_saved(page, { folder }) {
  for (const name of [kFileNames[1], kFileNames[3]]) {
    await open_file(page, name);
    assert.equal(await text_of(page), await bytes_of(folder, name));
  }
}

async function restores_unsaved_work(page) {
  await open_file(page, kTourFile);
  await step(page, () => type_into(page, page.getByRole('textbox', { name: 'tall', exact: true }), '0.5'));
  const text = await text_of(page);
  await open_file(page, kFileNames[1]);
  await choose_from_files(page, kTourFile);
  await page.locator('[data-banner="kept"]').getByRole('button', { name: 'Restore' }).click();
  await settled(page);
  assert.equal(await text_of(page), text);
  await undo_all(page);
  await settled(page);
}

async function drags_a_handle(page) {
  const slider = page.getByRole('slider', { name: 'tall, slider', exact: true });
  await slider.scrollIntoViewIfNeeded();
  const box = await slider.boundingBox();
  await step(page, async () => {
    await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
    await page.mouse.down();
    for (let k = 1; k <= 10; k += 1) await page.mouse.move(box.x + box.width / 2 + 3 * k, box.y + box.height / 2);
    await page.mouse.up();
  });
}

async function loses_the_graphics_context(page) {
  const packets = await page.evaluate(() => {
    const lost = document.querySelector('.view canvas').getContext('webgl2').getExtension('WEBGL_lose_context');
    lost.loseContext();
    setTimeout(() => lost.restoreContext(), 100);
    return window.studio.connection.counts.packets;
  });
  await page.waitForFunction((known) => window.studio.connection.counts.packets > known, packets);
  await settled(page);
}

async function pauses_growth(page) {
  await page.getByRole('button', { name: 'Pause growing' }).click();
  await page.getByRole('button', { name: 'Go on growing' }).click();
  await settled(page);
}

/// No growth was stopped, so nothing changes.
async function continues_what_was_not_stopped(page) {
  const packets = () => page.evaluate(() => window.studio.connection.counts.packets);
  const before = await packets();
  await ask(page, 'continue');
  await settled(page);
  assert.equal(await packets(), before);
}

async function exports_the_text(page) {
  await leave_fields(page);
  await page.keyboard.press('Control+e');
  const dialog = page.getByRole('dialog');
  await dialog.locator('.format', { has: page.getByText('.json', { exact: true }) }).click();
  await dialog.getByRole('button', { name: 'Copy as command' }).click();
  await dialog.getByRole('button', { name: 'Export', exact: true }).click();
  const link = dialog.locator('.made-file a');
  await link.waitFor();
  const exported = await link.evaluate(async (one) => (await fetch(one.href)).text());
  assert.equal(exported, await text_of(page));
  await dialog.getByRole('button', { name: 'Close' }).click();
}

async function cancels_a_picture(page) {
  const refusal = await page.evaluate(async () => {
    const options = { width: 400, height: 400, samples: 4000 };
    const job = window.studio.connection.begin('export', { format: '.png', name: null, options });
    job.cancel();
    return job.answer.then(
      () => null,
      (fault) => fault.facts ?? String(fault),
    );
  });
  assert.equal(refusal?.cancelled, true, JSON.stringify(refusal));
}

async function draws_small_pictures(page) {
  const camera = { position: [0, 1, 5], target: [0, 1, 0], field_of_view: 30 };
  const { stills } = await ask(page, 'stills', {
    states: [{ tall: 0.4 }, { tall: 'nothing' }],
    width: 32,
    height: 32,
    camera,
  });
  assert.match(stills[0].picture, /^iVBORw0K/);
  assert.ok(stills[1].faults.length > 0);
  const { thumbnail } = await ask(page, 'picture', { file: 'bark.jpg', size: 32 });
  assert.ok(thumbnail.width > 32 && thumbnail.picture.length > 100);
}

async function asks_about_the_trees(page) {
  const { instance: first } = await ask(page, 'shoot', { component: 'pear' });
  assert.equal(first.shoot, 'main');
  const { instance: child } = await ask(page, 'shoot', {
    component: 'pear',
    of: { stem: 0, tree: 0, shoot: 'main', metamer: 1 },
    go: 'child',
  });
  assert.match(child.shoot, /^main\./);
  const { instance: seen } = await ask(page, 'instance', {
    component: 'pear',
    frame: kWhole,
    position: [2, 0.3, 0.01],
  });
  assert.equal(seen.shoot, 'main');
  const { operations } = await ask(page, 'operations', {
    component: 'pear',
    operation: 'components.pear.operations[0]',
  });
  assert.equal(operations.acts[0][2], 'cut');
  const { cloud } = await ask(page, 'cloud', { component: 'tree' });
  assert.equal(cloud.count, 60);
  const { overlays } = await ask(page, 'overlays', { parts: ['skeleton', 'sun'] });
  assert.equal(overlays.layers.length, 2);
}

async function asks_about_the_others(page) {
  const { derivation } = await ask(page, 'grammar', { component: 'weed', step: 1 });
  assert.deepEqual(derivation.modules, ['F', '[', '+', 'F', ']', 'F']);
  const { curves } = await ask(page, 'curves', { component: 'blade' });
  assert.equal(curves.midrib_points.length, 3);
  const { clocks } = await ask(page, 'clocks', { up_to: 4 });
  assert.deepEqual(
    clocks.map((one) => one.component),
    ['clock'],
  );
  const { stand } = await ask(page, 'stand', { component: 'pear' });
  assert.equal(stand.length, 12);
  const box = 'scene.obstacles[0].box[1][1]';
  const { numbers } = await ask(page, 'worked_out', { expressions: { [box]: '2*tall' } });
  const { value } = await page.evaluate(() =>
    window.studio.document.state.get().variables.find((one) => one.name === 'tall'),
  );
  assert.ok(Math.abs(numbers[box] - 2 * value) < 1e-6, `${numbers[box]} is not twice ${value}`);
}

async function takes_parts(page) {
  const { tree } = await ask(page, 'parts', { model: 'bush' });
  assert.ok(tree.components.leaf);
  const part = await ask(page, 'part', { components: ['leaf'] });
  assert.deepEqual(part.components, ['leaf']);
  assert.match(part.text, /bark\.jpg/);
}

async function measures_the_plant(page) {
  const { rows } = await ask(page, 'measure_rows');
  const { measures } = await ask(page, 'measures', { light: false });
  assert.ok(rows.every(({ name }) => name in measures));
  const { sweep } = await ask(page, 'sweep', { path: 'tree.iterations', values: [6, 18] });
  assert.ok(sweep[0].measures.length < sweep[1].measures.length, JSON.stringify(sweep));
}

/// The parts of the tour, in order. Each part begins in the state in which the previous part ended.
export const kTour = [
  starts_saves_and_saves_again,
  saves_a_shipped_plant_and_saves_again,
  saves_over_another_file,
  reopens_what_was_saved,
  restores_unsaved_work,
  drags_a_handle,
  loses_the_graphics_context,
  pauses_growth,
  continues_what_was_not_stopped,
  exports_the_text,
  cancels_a_picture,
  draws_small_pictures,
  asks_about_the_trees,
  asks_about_the_others,
  takes_parts,
  measures_the_plant,
];

/// Puts the files of the tour into the folder of the server.
export async function prepare_tour(folder) {
  await write_document(folder, kTourFile, kTourDocument);
  await copyFile(path.join(kSource, 'docs/gallery/bush.jpg'), path.join(folder, 'bark.jpg'));
}
