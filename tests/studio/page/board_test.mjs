// SPDX-License-Identifier: Apache-2.0
// The board: its drawing of a document, its actions, and the selection that all panels share.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import path from 'node:path';
import { after, before, test } from 'node:test';
import {
  add_by_mouse,
  carry,
  chosen,
  click_node,
  draw_link,
  hang_by_mouse,
  middle,
  node,
  open_board,
  rename_by_mouse,
  set_kind_by_mouse,
  tool,
} from './board_hands.mjs';
import { serious_faults } from './boxes.mjs';
import { choose, leave_fields, open_file, open_model, step, undo_all } from './hands.mjs';
import {
  changes,
  kSource,
  open_page,
  settled,
  start_browser,
  start_server,
  temporary_folder,
  text_of,
  undo_count,
  write_document,
} from './support.mjs';

const kFlower = `// A flower.\r
{\r
\t"meristem": 1,\r
\t"variables": {"petals": {"value": 7, "min": 3, "max": 12, "doc": "How many."}},\r
\t"components": {\r
\t\t"view": {"type": "camera"},\r
\t\t// What all stands on.\r
\t\t"stem": {"type": "tree", "length": 0.5, "radius": 0.008},\r
\t\t"leaf": {"type": "leaf", "length": 0.1, "colour": "#55782f"}, // along the stem\r
\t\t"ring": {"type": "wreath", "number": "petals", "diameter": 0.02, "angle": 70},\r
\t\t"petal": {"type": "leaf", "length": 0.08, "colour": "#e8a50c"}\r
\t},\r
\t"links": [\r
\t\t["view", "stem"],\r
\t\t{"from": "stem", "to": "leaf", "kind": "branch", "count": 5},\r
\t\t["stem", "ring"],\r
\t\t["ring", "petal"] // the ring's\r
\t]\r
}\r
`;
const kRecursion = {
  meristem: 1,
  components: {
    A: { type: 'camera' },
    B: { type: 'simple', shape: 'cylinder', size: [0.1, 0.4, 0.1] },
    C: { type: 'hydra', number: 3, angle: 75 },
    D: { type: 'simple', shape: 'cylinder', size: [0.08, 0.24, 0.08], recursion: 3 },
    E: { type: 'simple', shape: 'sphere', size: [0.12, 0.12, 0.12] },
  },
  links: [['A', 'B'], ['B', 'C'], ['C', 'D'], ['D', 'D'], { from: 'D', to: 'E', kind: 'leaf' }],
};
/// Components without links to them: the board shows them in the order of the document.
const kStones = `{\r
\t"meristem": 1,\r
\t"components": {\r
\t\t// the first\r
\t\t"stone": {"type": "simple", "shape": "cube"}, // square\r
\t\t"ball": {"type": "simple", "shape": "sphere"},\r
\t\t// small\r
\t\t"pebble": {"type": "simple", "shape": "sphere", "size": [0.1, 0.1, 0.1]}\r
\t}\r
}\r
`;
/// Twenty balls in four rows, of one component.
const kBalls = {
  meristem: 1,
  components: {
    field: { type: 'field', rows: 4, plants: 5, row_spacing: 2, spacing: 2, turned: false },
    ball: { type: 'simple', shape: 'sphere', size: [1, 1, 1], colours: ['#335577', '#ddaa66'], colour_at: 'i/n' },
  },
  links: [['field', 'ball']],
};

const kPlot = { meristem: 1, components: { tree: { type: 'document', file: 'tulip' } }, links: [] };

let place, server, browser, context, page;

before(async () => {
  place = await temporary_folder();
  await write_document(place.folder, 'flower.json', kFlower);
  await write_document(place.folder, 'stones.json', kStones);
  for (const [name, document] of [
    ['recursion', kRecursion],
    ['balls', kBalls],
    ['plot', kPlot],
  ])
    await write_document(place.folder, `${name}.json`, JSON.stringify(document));
  server = await start_server(place.folder, path.join(place.folder, 'flower.json'));
  browser = await start_browser();
  context = await browser.newContext({
    viewport: { width: 1280, height: 900 },
    permissions: ['clipboard-read', 'clipboard-write'],
  });
  page = await open_page(context, server.address);
  await page.getByRole('button', { name: 'Start', exact: true }).click();
  await open_board(page);
});

after(async () => {
  await browser?.close();
  await server?.stop();
  await place?.remove();
});

const nodes = () => page.locator('.board-node').evaluateAll((all) => all.map((one) => one.dataset.node));
const lines = (selector) => page.locator(`.board-lines ${selector}`).count();
const reopen = () => open_file(page, 'flower.json');
const said = () => page.evaluate(() => JSON.parse(JSON.stringify(window.studio.document.state.get().tree.value)));
const links = async () => (await said()).links;

/// Does one step of the undo list and checks that undoing it restores the first bytes.
async function is_one_step(act) {
  const [text, count] = [await text_of(page), await undo_count(page)];
  await changes(page, act);
  await settled(page);
  const [after_it, chose] = [await text_of(page), await chosen(page)];
  assert.equal(await undo_count(page), count + 1);
  await leave_fields(page);
  await page.keyboard.press('Control+z');
  await page.waitForFunction((known) => window.studio.document.state.get().text === known, text);
  await page.keyboard.press('Control+Shift+z');
  await page.waitForFunction((known) => window.studio.document.state.get().text === known, after_it);
  return { after_it, chose };
}

test('components stand below each other with counts, notes and the four kinds of line', async () => {
  assert.deepEqual(await nodes(), ['view', 'stem', 'leaf', 'ring', 'petal']);
  assert.equal(await lines('.board-line.branch'), 1);
  assert.equal(await lines('.board-line.child'), 3);
  assert.match(await node(page, 'petal').textContent(), /petal leaf, 7 instances/);
  assert.match(await node(page, 'leaf').textContent(), /, 5 instances/);
  assert.equal(await node(page, 'stem').getAttribute('data-tip'), 'What all stands on.');
  assert.equal(await node(page, 'leaf').getAttribute('data-tip'), 'along the stem');
});

test('a recursion shows its first component twice, with doubled lines', async () => {
  await open_file(page, 'recursion.json');
  assert.deepEqual(await nodes(), ['A', 'B', 'C', 'D', 'E', 'D@3']);
  assert.equal(await lines('.board-line.doubled'), 1);
  assert.equal(await lines('.board-line.leaf'), 1);
});

test('a grammar and what it places are linked, and a document without a camera has one', async () => {
  await open_model(page, 'fern');
  const { implied, components } = await page.evaluate(() => ({
    implied: window.studio.document.state.get().implied,
    components: Object.keys(window.studio.document.state.get().tree.value.components),
  }));
  assert.equal(await lines('.board-line.placed'), implied.length);
  assert.ok(implied.length > 0);
  assert.ok((await nodes()).length >= components.length);
  await open_file(page, 'balls.json');
  assert.deepEqual(await nodes(), ['camera', 'field', 'ball']);
});

test('what is chosen on the board is chosen in outline, inspector and text, and the other way round', async () => {
  await reopen();
  await click_node(page, 'petal');
  assert.equal(await page.locator('#inspector-title').innerText(), 'petal\nleaf');
  await page.keyboard.press('ArrowUp');
  assert.equal(await chosen(page), 'components.ring');
  // Inspector to text and back.
  await page.getByRole('group', { name: 'Side panel' }).getByRole('button', { name: 'Text' }).click();
  await click_node(page, 'leaf');
  const line = page.locator('.cm-activeLine');
  await page.waitForFunction(() => document.querySelector('.cm-activeLine')?.textContent.includes('"leaf"'));
  await page.locator('.cm-line', { hasText: '"stem": {' }).click();
  await page.waitForFunction(() => document.querySelector('.board-node[aria-selected=true]')?.dataset.node === 'stem');
  assert.ok(await line.isVisible());
  await page.getByRole('group', { name: 'Side panel' }).getByRole('button', { name: 'Inspector' }).click();
  // Outline to board.
  await page
    .getByRole('group', { name: 'Outline or board' })
    .getByRole('button', { name: 'Outline', exact: true })
    .click();
  await choose(page, 'ring → petal');
  await open_board(page);
  assert.equal(await lines('.board-line.chosen'), 1);
  // Click a line.
  const hit = page.locator('[data-line="1"] .board-hit');
  const box = await hit.boundingBox();
  await page.mouse.click(box.x + box.width / 2, box.y + box.height / 2);
  assert.equal(await chosen(page), 'links[1]');
});

test('components are added below the chosen one, by mouse, as one step each', async () => {
  await reopen();
  const { after_it } = await is_one_step(() => add_by_mouse(page, 'ring', 'hydra'));
  assert.deepEqual(await links(), [
    ['view', 'stem'],
    { from: 'stem', to: 'leaf', kind: 'branch', count: 5 },
    ['stem', 'ring'],
    ['ring', 'petal'],
    ['ring', 'hydra'],
  ]);
  assert.ok(
    after_it.includes(
      '"petal": {"type": "leaf", "length": 0.08, "colour": "#e8a50c"},\r\n\t\t"hydra": {"type": "hydra"}\r\n\t},',
    ),
  );
  assert.ok(after_it.includes('["ring", "petal"], // the ring\'s\r\n\t\t["ring", "hydra"]\r\n\t]'));
  await is_one_step(() => add_by_mouse(page, 'stem', 'leaf'));
  assert.deepEqual((await links())[3], { from: 'stem', to: 'leaf_2', kind: 'branch' });
});

test('all that the palette offers can be added, and has a picture', async () => {
  await reopen();
  await click_node(page, 'stem');
  await tool(page, 'Add').click();
  const types = await page.locator('.dialog [data-add]').evaluateAll((all) => all.map((one) => one.dataset.add));
  await page.waitForFunction(() =>
    [...document.querySelectorAll('.dialog .model img')].every((one) => one.complete && one.naturalWidth > 0),
  );
  assert.equal(await page.locator('.dialog .no-picture').count(), 0);
  await page.keyboard.press('Escape');
  // A document and a skeleton need a file that only their author knows.
  for (const type of types.filter((one) => !['document', 'skeleton'].includes(one))) {
    await add_by_mouse(page, 'stem', type, 'Child');
    await page
      .waitForFunction(
        () =>
          window.studio.document.state.get().faults.length === 0 ||
          window.studio.document.state.get().faults.every((one) => one.severity !== 'error'),
        null,
        { timeout: 10000 },
      )
      .catch(async () => {
        assert.fail(
          `${type}: ${JSON.stringify(await page.evaluate(() => window.studio.document.state.get().faults.map((one) => one.message)))}`,
        );
      });
    await leave_fields(page);
    await page.keyboard.press('Control+z');
    await page.waitForFunction(() => window.studio.document.state.get().undo.done.length === 0);
  }
  assert.equal(await text_of(page), kFlower);
});

test('links are drawn from node to node; a circle is refused at the edge, with the reason', async () => {
  await reopen();
  await draw_link(page, 'petal', 'stem', false);
  assert.equal(await lines('.board-line.dragged.refused'), 1);
  assert.match(await node(page, 'stem').getAttribute('class'), /refused/);
  await page.mouse.up();
  await page.locator('.board-word.fault').waitFor();
  assert.match(
    await page.locator('.board-word.fault').innerText(),
    /stem > ring > petal > stem would form an endless circle. A recursion of at least 2 in stem/,
  );
  assert.equal(await lines('.board-line.refused'), 1);
  assert.equal(await text_of(page), kFlower);
  assert.equal(await undo_count(page), 0);
  // No link leads to the camera.
  await draw_link(page, 'leaf', 'view');
  assert.match(await page.locator('.board-word.fault').innerText(), /camera/);
  assert.equal(await text_of(page), kFlower);
  const { chose } = await is_one_step(() => draw_link(page, 'leaf', 'petal'));
  assert.deepEqual((await links())[2], ['leaf', 'petal']);
  assert.equal(chose, 'links[2]');
});

test('what the library refuses is refused at the edge too, and the text stays', async () => {
  await open_file(page, 'recursion.json');
  const text = await text_of(page);
  // E is a leaf of the recursion on D; a link from it back to B, which recurses once only, is a circle.
  await draw_link(page, 'E', 'C');
  await page.locator('.board-word.fault').waitFor();
  assert.match(await page.locator('.board-word.fault').innerText(), /endless circle/);
  assert.equal(await text_of(page), text);
});

test('links change kind, order and ends; links and components go', async () => {
  await reopen();
  await set_kind_by_mouse(page, 'ring', 'Crown');
  assert.deepEqual((await links())[2], { from: 'stem', to: 'ring', kind: 'crown' });
  await changes(page, () => page.locator('.board-tools').getByRole('button', { name: 'Child', exact: true }).click());
  assert.deepEqual((await links())[2], ['stem', 'ring']);
  // The ring before the leaf: by the mouse and back by the keyboard.
  await is_one_step(async () =>
    carry(page, await middle(node(page, 'ring')), [
      (await middle(node(page, 'leaf')))[0] - 90,
      (await middle(node(page, 'leaf')))[1] + 34,
    ]),
  );
  assert.deepEqual(
    (await links()).map((one) => one.to ?? one[1]),
    ['stem', 'ring', 'leaf', 'petal'],
  );
  await click_node(page, 'ring');
  await changes(page, () => page.keyboard.press('Alt+ArrowRight'));
  assert.deepEqual(
    (await links()).map((one) => one.to ?? one[1]),
    ['stem', 'leaf', 'ring', 'petal'],
  );
  await hang_by_mouse(page, 'petal', 'stem');
  assert.deepEqual((await links())[3], ['stem', 'petal']);
  await click_node(page, 'leaf');
  await is_one_step(async () => {
    await click_node(page, 'leaf');
    await page.keyboard.press('Delete');
  });
  assert.ok(!(await text_of(page)).includes('leaf": {'));
  await undo_all(page);
  assert.equal(await text_of(page), kFlower);
});

test('components change places among themselves, and their comments go along', async () => {
  await open_file(page, 'stones.json');
  const ids = async () => Object.keys((await said()).components);
  const beside =
    (await page.locator('.board-canvas').getAttribute('data-direction')) === 'down'
      ? ['ArrowLeft', 'ArrowRight']
      : ['ArrowUp', 'ArrowDown'];
  await click_node(page, 'stone');
  await is_one_step(async () => {
    await node(page, 'stone').focus();
    await page.keyboard.press(`Alt+${beside[1]}`);
  });
  assert.deepEqual(await ids(), ['ball', 'stone', 'pebble']);
  assert.ok(
    (await text_of(page)).includes('// the first\r\n\t\t"stone": {"type": "simple", "shape": "cube"}, // square\r\n'),
    await text_of(page),
  );
  // By the mouse: the pebble before all.
  const [x, y] = await middle(node(page, 'ball'));
  const before_it = beside[0] === 'ArrowLeft' ? [x - 60, y + 34] : [x + 70, y - 24];
  await is_one_step(async () => carry(page, await middle(node(page, 'pebble')), before_it));
  assert.deepEqual(await ids(), ['pebble', 'ball', 'stone']);
  assert.deepEqual(
    (await nodes()).filter((one) => one !== 'camera'),
    ['pebble', 'ball', 'stone'],
  );
  // By the menu, and in the document, where the links give the positions on the board.
  await click_node(page, 'stone');
  await page
    .locator('.board-tools')
    .getByRole('button', { name: /^More for/ })
    .click();
  await changes(page, () => page.getByRole('menuitem', { name: 'Earlier in the document', exact: true }).click());
  assert.deepEqual(await ids(), ['pebble', 'stone', 'ball']);
  await leave_fields(page);
  await undo_all(page);
  assert.equal(await text_of(page), kStones);
  await reopen();
  await click_node(page, 'petal');
  await is_one_step(async () => {
    await node(page, 'petal').focus();
    await page.keyboard.press('Alt+Shift+ArrowLeft');
    if ((await ids()).at(-1) === 'petal') await page.keyboard.press('Alt+Shift+ArrowUp');
  });
  assert.deepEqual((await ids()).slice(-2), ['petal', 'ring']);
  assert.deepEqual((await links()).length, 4);
  await leave_fields(page);
  await undo_all(page);
  assert.equal(await text_of(page), kFlower);
});

test('deleting takes along what stands on nothing else, or leaves it on the parent', async () => {
  await reopen();
  await is_one_step(async () => {
    await click_node(page, 'stem');
    await page.keyboard.press('Delete');
  });
  assert.deepEqual(Object.keys((await said()).components), ['view']);
  assert.ok(!(await text_of(page)).includes('What all stands on'));
  await undo_all(page);
  await click_node(page, 'ring');
  await page
    .locator('.board-tools')
    .getByRole('button', { name: /^More for/ })
    .click();
  await changes(page, () => page.getByRole('menuitem', { name: 'Delete alone', exact: true }).click());
  assert.deepEqual(await links(), [
    ['view', 'stem'],
    { from: 'stem', to: 'leaf', kind: 'branch', count: 5 },
    ['stem', 'petal'],
  ]);
  await leave_fields(page);
  await undo_all(page);
  assert.equal(await text_of(page), kFlower);
});

test('renaming follows all references, says that chance is drawn anew, and undo gives the first bytes', async () => {
  await reopen();
  await click_node(page, 'ring');
  await rename_by_mouse(page, 'corolla');
  assert.deepEqual((await links()).slice(2), [
    ['stem', 'corolla'],
    ['corolla', 'petal'],
  ]);
  await page.locator('.toast', { hasText: 'chance' }).waitFor();
  // A name in use is refused.
  await page.keyboard.press('F2');
  await page.locator('#board-name').fill('leaf');
  await page.locator('#board-name').press('Enter');
  await page.locator('.toast.fault').waitFor();
  assert.equal(await undo_count(page), 1);
  await leave_fields(page);
  await undo_all(page);
  assert.equal(await text_of(page), kFlower);
});

test('notes are comments of the document', async () => {
  await reopen();
  await click_node(page, 'petal');
  await page.keyboard.press('n');
  await page.locator('#board-note').fill('Yellow.\nSeven of them.');
  await changes(page, () => page.keyboard.press('Control+Enter'));
  assert.ok((await text_of(page)).includes('\t\t// Yellow.\r\n\t\t// Seven of them.\r\n\t\t"petal"'));
  await page.waitForFunction(() => document.querySelector('[data-node=petal]')?.dataset.tip?.includes('Seven'));
  await click_node(page, 'leaf');
  await page.keyboard.press('n');
  assert.equal(await page.locator('#board-note').inputValue(), 'along the stem');
  await page.locator('#board-note').fill('');
  await changes(page, () => page.keyboard.press('Control+Enter'));
  assert.ok((await text_of(page)).includes('"colour": "#55782f"},\r\n'));
  await leave_fields(page);
  await undo_all(page);
  assert.equal(await text_of(page), kFlower);
});

test('duplicates stand on the same parents by the same links, with the layout of the first', async () => {
  await reopen();
  const { chose } = await is_one_step(async () => {
    await click_node(page, 'leaf');
    await page.keyboard.press('Control+d');
  });
  assert.deepEqual((await links()).slice(1, 3), [
    { from: 'stem', to: 'leaf', kind: 'branch', count: 5 },
    { from: 'stem', to: 'leaf_2', kind: 'branch', count: 5 },
  ]);
  assert.ok(
    (await text_of(page)).includes(
      '"leaf_2": {"type": "leaf", "length": 0.1, "colour": "#55782f"}, // along the stem\r\n',
    ),
  );
  assert.equal(chose, 'components.leaf_2');
});

test('parts are copied from one document into another, with their variables and notes', async () => {
  await reopen();
  await click_node(page, 'ring');
  await page.keyboard.press('Control+c');
  await page.locator('.toast', { hasText: 'Copied ring' }).waitFor();
  const other = await open_page(context, server.address);
  await open_file(other, 'recursion.json');
  await open_board(other);
  await click_node(other, 'B');
  await changes(other, () => other.keyboard.press('Control+v'));
  await settled(other);
  const document = await other.evaluate(() =>
    JSON.parse(JSON.stringify(window.studio.document.state.get().tree.value)),
  );
  assert.deepEqual(Object.keys(document.components), ['A', 'B', 'C', 'D', 'E', 'ring', 'petal']);
  assert.deepEqual(document.variables, { petals: { value: 7, min: 3, max: 12, doc: 'How many.' } });
  assert.deepEqual(document.links.slice(2, 4), [
    ['B', 'ring'],
    ['ring', 'petal'],
  ]);
  assert.equal(await undo_count(other), 1);
  await other.close();
});

test('parts of shipped plants come with all that stands on them', async () => {
  await reopen();
  await click_node(page, 'stem');
  await page.keyboard.press('a');
  await page.getByRole('dialog').getByRole('button', { name: 'Parts of shipped plants' }).click();
  await page.locator('.dialog [data-add="sunflower"]').click();
  await is_one_step(() => page.locator('[data-part="disc"]').click());
  assert.deepEqual(Object.keys((await said()).components).slice(-4), ['disc', 'bud', 'floret', 'anthers']);
  assert.deepEqual(Object.keys((await said()).variables), ['petals', 'head', 'bloom']);
  await settled(page);
  assert.equal(await page.evaluate(() => window.studio.document.state.get().good), true);
});

test('folding, hiding and showing alone are not saved', async () => {
  await reopen();
  const batches = () => page.evaluate(() => window.studio.view.plant.seen.map((one) => one.component));
  await click_node(page, 'ring');
  await page.keyboard.press('Space');
  assert.deepEqual(await nodes(), ['view', 'stem', 'leaf', 'ring']);
  await page.keyboard.press('Space');
  await page.keyboard.press('s');
  assert.deepEqual([...new Set(await batches())], ['petal']);
  await page.keyboard.press('s');
  assert.ok((await batches()).includes('leaf'));
  await click_node(page, 'leaf');
  await page.keyboard.press('h');
  assert.ok(!(await batches()).includes('leaf'));
  await page.keyboard.press('h');
  assert.equal(await text_of(page), kFlower);
  assert.equal(await undo_count(page), 0);
});

test('20 clicks in the view tell which instance it is, with the values that it has', async () => {
  await open_file(page, 'balls.json');
  await page.getByRole('button', { name: 'Top', exact: true }).click();
  await settled(page);
  const places = await page.evaluate(() => {
    const { plant, orbit } = window.studio.view;
    const { buffers } = plant;
    const box = document.querySelector('.view canvas').getBoundingClientRect();
    const set = plant.seen.find((one) => one.component === 'ball');
    const frames = set.batch.frames.image.data;
    const camera = orbit.camera;
    const points = [];
    for (let k = 0; k < 20; k += 1) {
      const v = camera.position
        .clone()
        .set(frames[12 * k + 3], frames[12 * k + 7] + 0.5, frames[12 * k + 11])
        .project(camera);
      points.push([box.left + ((v.x + 1) / 2) * box.width, box.top + ((1 - v.y) / 2) * box.height]);
    }
    return buffers && points;
  });
  for (const [k, [x, y]] of places.entries()) {
    await page.mouse.click(x, y);
    await page.waitForFunction((number) => window.studio.instance.found.get()?.i === number, k, { timeout: 5000 });
    const found = await page.evaluate(() => window.studio.instance.found.get());
    assert.equal(found.n, 20);
    assert.deepEqual(
      found.values.map((one) => [one.path, Math.round(100 * one.value)]),
      [['components.ball.colour_at', 5 * k]],
    );
  }
  assert.match(await page.locator('.instance').innerText(), /Instance 19 of 20/);
  assert.equal(await chosen(page), 'components.ball');
});

test('instances are clicked into omit and only, as one step each', async () => {
  await open_file(page, 'balls.json');
  await page.getByRole('button', { name: 'Top', exact: true }).click();
  await settled(page);
  const click_ball = async (k) => {
    const [x, y] = await page.evaluate((number) => {
      const { plant, orbit } = window.studio.view;
      const box = document.querySelector('.view canvas').getBoundingClientRect();
      const frames = plant.seen.find((one) => one.component === 'ball').batch.frames.image.data;
      const v = orbit.camera.position
        .clone()
        .set(frames[12 * number + 3], frames[12 * number + 7] + 0.5, frames[12 * number + 11])
        .project(orbit.camera);
      return [box.left + ((v.x + 1) / 2) * box.width, box.top + ((1 - v.y) / 2) * box.height];
    }, k);
    await page.mouse.click(x, y);
    await page.waitForFunction((number) => window.studio.instance.found.get()?.i === number, k);
  };
  await click_ball(3);
  await page.getByRole('button', { name: 'Leave out…' }).click();
  await click_ball(7);
  await click_ball(12);
  await step(page, () => page.getByRole('button', { name: 'Take over' }).click());
  assert.deepEqual((await said()).components.ball.omit, [3, 7, 12]);
  assert.equal(await undo_count(page), 1);
  assert.equal(await page.evaluate(() => window.studio.growth.get().grown.placed.ball), 17);
});

test('whole plants are put together, entered and left', async () => {
  await reopen();
  await click_node(page, 'view');
  await page.keyboard.press('a');
  await page.getByRole('dialog').getByRole('button', { name: 'Whole plants' }).click();
  await changes(page, () => page.locator('.dialog [data-add="tulip"]').click());
  assert.deepEqual((await said()).components.tulip, { type: 'document', file: 'tulip' });
  await settled(page);
  await node(page, 'tulip').dblclick();
  await page.waitForFunction(() => window.studio.document.state.get().model === 'tulip');
  await page.locator('.board-trail').waitFor();
  await settled(page);
  await page.locator('.board-trail button').click();
  await page.waitForFunction(() => window.studio.document.state.get().path === 'flower.json');
  // The unsaved changes are back.
  await page.waitForFunction(() => window.studio.document.state.get().text.includes('"tulip"'));
  assert.equal(await page.locator('.board-trail').count(), 0);
});

test('the plant of a component is chosen from the shipped ones with their pictures', async () => {
  await open_file(page, 'plot.json');
  const text = await text_of(page);
  await click_node(page, 'tree');
  const file = page.locator('.inspector [data-path="components.tree.file"]');
  await file.locator('img.thumbnail').waitFor();
  await file.getByRole('button', { name: 'Choose a plant for file' }).click();
  const dialog = page.getByRole('dialog');
  await dialog.locator('[data-add="lilac"] img').waitFor();
  assert.ok(await dialog.locator('.file', { hasText: 'flower.json' }).isVisible());
  await dialog.getByRole('searchbox').fill('lilac');
  await is_one_step(() => dialog.locator('[data-add="lilac"]').click());
  assert.equal((await said()).components.tree.file, 'lilac');
  await file.getByRole('button', { name: 'Choose a plant for file' }).click();
  await changes(page, () => dialog.locator('.file', { hasText: 'flower.json' }).click());
  assert.equal((await said()).components.tree.file, 'flower.json');
  await leave_fields(page);
  await undo_all(page);
  assert.equal(await text_of(page), text);
});

test('a new plant begins with a camera', async () => {
  await page.getByRole('button', { name: 'New plant', exact: true }).click();
  await page.waitForFunction(() => window.studio.document.state.get().text.includes('"New plant"'));
  assert.deepEqual(await nodes(), ['view']);
});

test('the board of each shipped plant has all of its components', async () => {
  for (const name of ['garden', 'sunflower']) {
    const text = await readFile(path.join(kSource, `models/${name}.json`), 'utf8');
    const document = JSON.parse(text.replace(/^\s*\/\/.*$/gm, ''));
    await page.evaluate((one) => window.studio.open({ text: one, path: null }), text);
    await page.waitForFunction((known) => window.studio.document.state.get().text === known, text);
    const all = await nodes();
    for (const id of Object.keys(document.components)) assert.ok(all.includes(id), `${name}: ${id}`);
    assert.equal(await lines('[data-line]'), document.links.length);
    await page
      .getByRole('button', { name: 'Cancel' })
      .click({ timeout: 2000 })
      .catch(() => undefined);
  }
});

for (const theme of ['light', 'dark']) {
  test(`axe finds nothing serious on the board, ${theme}`, async () => {
    await reopen();
    await page.emulateMedia({ colorScheme: theme });
    await click_node(page, 'ring');
    for (const opens of [false, true]) {
      if (opens) await page.keyboard.press('a');
      assert.deepEqual(await serious_faults(page, { colours_only: theme === 'dark' }), []);
      if (opens) await page.keyboard.press('Escape');
    }
  });
}

test('nothing was complained about on the way', () => {
  assert.deepEqual(
    page.faults.filter((fault) => !/WebGL|GL Driver/i.test(fault)),
    [],
  );
});
