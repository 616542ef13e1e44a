// SPDX-License-Identifier: Apache-2.0
// The sunflower of the manual, built on the board in its five steps. It is built once with the mouse, with numbers in
// the rows of the inspector, and once with the keyboard alone, with numbers in the text. Both must equal the shipped
// plant.
import assert from 'node:assert/strict';
import { createHash } from 'node:crypto';
import { readFile, writeFile } from 'node:fs/promises';
import path from 'node:path';
import { after, before, test } from 'node:test';

import {
  add_by_keyboard,
  add_by_mouse,
  chosen,
  click_node,
  go_to,
  hang_by_mouse,
  name_variable,
  open_board,
  rename_by_keyboard,
  rename_by_mouse,
  retype_by_keyboard,
  set_kind_by_mouse,
  tab_to,
} from './board_hands.mjs';
import { choose } from './hands.mjs';
import { at_path, below, RowHand } from './row_hands.mjs';
import {
  changes,
  frames,
  kSource,
  meristem,
  open_page,
  start_browser,
  start_server,
  still,
  temporary_folder,
  text_of,
  undo_count,
} from './support.mjs';

let place, server, browser, shipped, tables;

/// The components of each step: name, parent at first, and type.
const kSteps = [
  [
    'a leaf with its stalk',
    [
      ['petiole', 'view', 'tree'],
      ['blade', 'petiole', 'leaf'],
    ],
  ],
  [
    'the bottom of the head',
    [
      ['receptacle', 'view', 'revolution'],
      ['whorl', 'receptacle', 'hydra'],
      ['bract', 'whorl', 'leaf'],
    ],
  ],
  [
    'rays and florets',
    [
      ['ring', 'receptacle', 'wreath'],
      ['ray', 'ring', 'leaf'],
      ['disc', 'receptacle', 'phiball'],
      ['bud', 'disc', 'revolution'],
      ['floret', 'disc', 'revolution'],
      ['anthers', 'disc', 'revolution'],
    ],
  ],
  [
    'the stem',
    [
      ['stem', 'view', 'tree'],
      ['neck', 'stem', 'horn'],
    ],
  ],
];

const read = (text) => JSON.parse(text.replace(/^\s*\/\/.*$/gm, ''));

before(async () => {
  place = await temporary_folder();
  server = await start_server(place.folder);
  browser = await start_browser();
  shipped = read(await readFile(path.join(kSource, 'models/sunflower.json'), 'utf8'));
  tables = JSON.parse((await meristem('components', '--json')).stdout);
});

after(async () => {
  await browser?.close();
  await server?.stop();
  await place?.remove();
});

/// Sorts components, variables and links, because users write them in any order.
function in_order(document) {
  const sorted = (object) => Object.fromEntries(Object.entries(object).sort(([a], [b]) => (a < b ? -1 : 1)));
  const links = [...document.links]
    .map((link) => JSON.stringify(link))
    .sort()
    .map((link) => JSON.parse(link));
  return {
    ...sorted(document),
    components: sorted(Object.fromEntries(Object.entries(document.components).map(([id, one]) => [id, sorted(one)]))),
    variables: sorted(document.variables),
    links,
  };
}

async function hash_of_plant(name, document) {
  const file = path.join(place.folder, `${name}.json`);
  await writeFile(file, JSON.stringify(in_order(document)));
  const { code, stderr } = await meristem('grow', file, '-o', path.join(place.folder, `${name}.glb`), '-q');
  assert.equal(code, 0, stderr);
  return createHash('sha256')
    .update(await readFile(path.join(place.folder, `${name}.glb`)))
    .digest('hex');
}

async function assert_is_shipped(page) {
  const built = read(await text_of(page));
  assert.deepEqual(in_order(built), in_order(shipped));
  assert.equal(await hash_of_plant('plant', built), await hash_of_plant('plant', shipped));
}

async function new_page() {
  const context = await browser.newContext({ viewport: { width: 1280, height: 900 } });
  const page = await open_page(context, server.address);
  await page.getByRole('button', { name: 'Start', exact: true }).click();
  return page;
}

const begins_anew = (page) =>
  page.waitForFunction(
    () => window.studio.document.state.get().text.includes('"New plant"') && window.studio.growth.get().shown,
  );

/// Sets all rows of the shipped document for the chosen part, by mouse and keyboard.
async function give_rows(page, at, said, ...names) {
  const hand = new RowHand(page, tables);
  const is_given = (row) => row.name !== 'type' && row.name !== 'meristem' && said[row.name] !== undefined;
  let rows = names.flatMap((name) => tables.tables[name].rows.filter(is_given));
  // Some rows exist only beside others, such as a latitude beside a sun.
  for (let round = 0; rows.length > 0; round += 1) {
    const waiting = [];
    for (const row of rows) {
      if (await at_path(page, below(at, row.name)).isVisible())
        await hand.give(below(at, row.name), row, said[row.name]);
      else waiting.push(row);
    }
    assert.ok(waiting.length < rows.length || round < 100, `no rows for ${waiting.map((one) => one.name)} of ${at}`);
    if (waiting.length === rows.length) await frames(page);
    rows = waiting;
  }
}

const give_component = (page, id) =>
  give_rows(
    page,
    `components.${id}`,
    shipped.components[id],
    tables.components[shipped.components[id].type].table,
    tables.all_components,
  );

test('with the mouse', async () => {
  const page = await new_page();
  await page.getByRole('button', { name: 'New plant', exact: true }).click();
  await begins_anew(page);
  // The growth of intermediate plants is tested elsewhere.
  await page.getByRole('button', { name: 'Pause growing' }).click();
  // The document, its handles, its scene.
  await choose(page, 'Document');
  await give_rows(
    page,
    '',
    { name: shipped.name, description: shipped.description, licence: shipped.licence, seed: shipped.seed },
    tables.document,
  );
  for (const [name, said] of Object.entries(shipped.variables)) {
    await changes(page, () => page.getByRole('button', { name: 'Add a handle', exact: true }).click());
    await page.waitForFunction(() => window.studio.chosen.get().startsWith('variables.handle'));
    await name_variable(page, name);
    await give_rows(page, `variables.${name}`, said, tables.variable);
  }
  for (const [title, part] of [
    ['Scene', 'scene'],
    ['Output', 'output'],
  ]) {
    await choose(page, title);
    await give_rows(
      page,
      part,
      shipped[part],
      tables.tables[tables.document].rows.find((one) => one.name === part).table,
    );
  }
  await open_board(page);
  await click_node(page, 'view');
  await give_component(page, 'view');
  for (const [, parts] of kSteps) {
    for (const [id, below_id, type] of parts) {
      await add_by_mouse(page, below_id, type, 'Child');
      await rename_by_mouse(page, id);
      await give_component(page, id);
    }
  }
  // The leaf moves to the stem, and then the head to the neck.
  await hang_by_mouse(page, 'petiole', 'stem');
  await set_kind_by_mouse(page, 'petiole', 'Branch');
  await hang_by_mouse(page, 'receptacle', 'neck');
  await assert_is_shipped(page);
  const steps = await undo_count(page);
  assert.ok(steps > 150, `${steps} steps`);
  assert.deepEqual(
    page.faults.filter((fault) => !/WebGL|GL Driver/i.test(fault)),
    [],
  );
  await page.context().close();
});

test('with the keyboard alone', async () => {
  const page = await new_page();
  await tab_to(page, '[aria-label="New plant"]');
  await page.keyboard.press('Enter');
  await begins_anew(page);
  await tab_to(page, '[aria-label="Pause growing"]');
  await page.keyboard.press('Enter');
  await page.keyboard.press('b');
  await page.locator('.board-canvas').waitFor();
  for (const [, parts] of kSteps) {
    for (const [id, below_id, type] of parts) {
      await go_to(page, below_id === 'view' ? 'view' : below_id === 'stem' ? 'stem' : below_id);
      await page.keyboard.press('Enter');
      await add_by_keyboard(page, type, 'Child');
      await go_to(page, type);
      await rename_by_keyboard(page, id);
      assert.equal(await chosen(page), `components.${id}`);
    }
  }
  // Links from the stem to the petiole and from the neck to the receptacle replace the links from the camera.
  for (const [from, to] of [
    ['stem', 'petiole'],
    ['neck', 'receptacle'],
  ]) {
    await go_to(page, from);
    await page.keyboard.press('l');
    await go_to(page, to);
    await changes(page, () => page.keyboard.press('Enter'));
    await delete_link_by_keyboard(page, `view → ${to}`);
  }
  await page.keyboard.press('t');
  await page.locator('.cm-content').waitFor();
  for (const [id, said] of Object.entries(shipped.components)) {
    await retype_by_keyboard(
      page,
      id === 'view' ? '"view": {"type": "camera"}' : `"${id}": {"type": "${said.type}"}`,
      `"${id}": ${JSON.stringify(said)}`,
    );
  }
  const { name, description, licence, seed, variables, scene, output } = shipped;
  const head = JSON.stringify({ name, description, licence, seed, variables, scene, output }).slice(1, -1);
  await retype_by_keyboard(page, '"name": "New plant"', head.replace(/"seed":\d+,/, ''));
  await retype_by_keyboard(page, '"seed": 1', `"seed": ${seed}`);
  // Leaves the text: Tab indents there unless Escape is pressed before. Then changes the kind of a link with the keys
  // of the board. The first Escape may close a list of completions.
  await page.keyboard.press('Escape');
  await still(page);
  await page.keyboard.press('Escape');
  await page.keyboard.press('Tab');
  await go_to(page, 'petiole');
  await page.keyboard.press('Enter');
  await choose_link_by_keyboard(page);
  await tab_to(page, '.board-tools [aria-label^="Kind of the link"] button:nth-child(2)');
  await changes(page, () => page.keyboard.press('Enter'));
  // The usual kind of a link from a horn would set receptacles along it.
  await go_to(page, 'receptacle');
  await page.keyboard.press('Enter');
  await choose_link_by_keyboard(page);
  await tab_to(page, '.board-tools [aria-label^="Kind of the link"] button:nth-child(1)');
  await changes(page, () => page.keyboard.press('Enter'));
  await assert_is_shipped(page);
  await page.context().close();
});

/// Presses arrow keys until the focused element has this text.
async function arrow_to(page, words) {
  for (const key of ['ArrowDown', 'ArrowUp']) {
    for (let k = 0; k < 40; k += 1) {
      if (await page.evaluate((wanted) => document.activeElement.textContent.startsWith(wanted), words)) return;
      await page.keyboard.press(key);
    }
  }
  throw new Error(`the arrow keys do not come to ${words}`);
}

/// Removes a link of the outline by the board's tools.
async function delete_link_by_keyboard(page, title) {
  await page.keyboard.press('b');
  await tab_to(page, '.outline-choice');
  await arrow_to(page, title);
  await page.keyboard.press('Enter');
  await page.keyboard.press('b');
  await tab_to(page, '[aria-label="Delete the link"]');
  await changes(page, () => page.keyboard.press('Enter'));
}

/// Chooses the link above the chosen component, by its menu.
async function choose_link_by_keyboard(page) {
  await tab_to(page, '.board-tools [aria-haspopup=menu]', 'Shift+Tab');
  await page.keyboard.press('Enter');
  await page.locator('.menu').waitFor();
  await arrow_to(page, 'Choose its link');
  await page.keyboard.press('Enter');
}
