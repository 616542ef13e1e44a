// SPDX-License-Identifier: Apache-2.0
// Steering growth: shoots are cut by a click, obstacles are moved by their grips, the sun by its dial, crowns by their
// outlines, and grass leaves by their curves. Each gesture is one step of the undo list.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';

import { box_faults, serious_faults } from './boxes.mjs';
import { choose, leave_fields, open_file, row, step, type_into, undo_all } from './hands.mjs';
import {
  meristem,
  open_page,
  settled,
  start_browser,
  start_server,
  temporary_folder,
  text_of,
  undo_count,
  write_document,
} from './support.mjs';

const kPear = `{
  "meristem": 1, // a tree to cut
  "name": "Pear",
  "components": {
    "pear": {"type": "organize", "iterations": 9, "lateral_threshold": 900, "jitter": 0, "resource": {"alpha": 1.3}, "tip_radius": 0.012}
  }
}
`;
const kTrees = `{
  "meristem": 1, // two trees to go along by keys
  "components": {
    "tree": {"type": "organize", "iterations": 7, "jitter": 0, "roots": [[0, 0, 0], [1.5, 0, 0]]}
  }
}
`;
const kYard = `{
  "meristem": 1,
  "name": "Yard",
  "scene": {
    "latitude": 50,
    "sun": {"day": 172, "hour": 12},
    "obstacles": [{"box": [[1, 0, -0.5], [2, 1.5, 0.5]], "name": "house"}],
    "supports": {"wire": [[-1, 1, 0], [1, 1, 0]]}
  },
  "components": {
    "tree": {"type": "colonize", "crown": {"profile": [[0.2, 0.6], [0.8, 1.2], [0, 2]]}, "points": 60, "step": 0.1, "influence": 1, "kill": 0.3}
  }
}
`;
const kLamp = `{
  "meristem": 1,
  "variables": {"far": {"value": 0.4, "min": 0, "max": 1}},
  "scene": {
    "lamps": [{"position": ["far", 0.5, "far*2"]}] // beside the stem
  },
  "components": {
    "stem": {"type": "tree", "length": 1, "radius": 0.02},
    "ball": {"type": "simple", "size": [0.1, 0.1, 0.1], "frame": {"translate": ["0.1*i", "far", 0]}}
  },
  "links": [{"from": "stem", "to": "ball", "kind": "branch", "count": 3}]
}
`;
const kGrass = `{
  "meristem": 1,
  "name": "Grass",
  "components": {"leaf": {"type": "grassleaf", "midrib": "midribs.csv", "widths": "widths.csv", "rank": 2, "unit": 0.01}}
}
`;
const kMidribs = `rank,x,y\n${[1, 2].flatMap((rank) => Array.from({ length: 9 }, (_, k) => `${rank},${(rank * k * k) / 10},${2 * k - 0.1 * k * k}`)).join('\n')}\n`;
const kWidths = `rank,s,r\n${[1, 2].flatMap((rank) => Array.from({ length: 6 }, (_, k) => `${rank},${k / 5},${1 - (k / 5) ** 3}`)).join('\n')}\n`;

let place, server, browser, page;

before(async () => {
  place = await temporary_folder();
  await write_document(place.folder, 'pear.json', kPear);
  await write_document(place.folder, 'trees.json', kTrees);
  await write_document(place.folder, 'yard.json', kYard);
  await write_document(place.folder, 'lamp.json', kLamp);
  await write_document(place.folder, 'grass.json', kGrass);
  await write_document(place.folder, 'midribs.csv', kMidribs);
  await write_document(place.folder, 'widths.csv', kWidths);
  server = await start_server(place.folder, 'pear.json');
  browser = await start_browser();
  page = await open_page(await browser.newContext({ viewport: { width: 1280, height: 720 } }), server.address);
  await page.getByRole('button', { name: 'Start', exact: true }).click();
});

after(async () => {
  await browser?.close();
  await server?.stop();
  await place?.remove();
});

const tree_of = async () => page.evaluate(() => window.studio.document.state.get().tree.value);

/// Returns the pixel of the page that shows a point of the world.
async function seen_at(point) {
  return page.evaluate(async (at) => {
    await window.studio.view.drawn(); // a panel may just have become wider
    const box = document.querySelector('.centre .view canvas').getBoundingClientRect();
    const [x, y] = window.studio.view.eye.project(at);
    return [box.left + x, box.top + y];
  }, point);
}

/// Clicks a shoot of the tree, and returns the page's data of the shoot.
async function click_shoot(point) {
  await page.mouse.click(...(await seen_at(point)));
  await page.locator('.shoot-tool').waitFor();
  return page.evaluate(() => window.studio.instance.found.get());
}

const tool = () => page.locator('.shoot-tool');
const acted = (path) =>
  page.waitForFunction(
    (wanted) =>
      window.studio.bench.pruning.told.get()?.operations.places.length > 0 &&
      window.studio.bench.pruning.looked_at.get()?.path === wanted,
    path,
  );

/// Returns the end of a metamer of the stem that is visible from the front.
const kOnStem = [0, 0.52, 0.01];

test('a click on a shoot takes hold of it, and a cut stands in the document and undoes', async () => {
  const nodes = await page.evaluate(() => window.studio.growth.get().grown.nodes);
  const shoot = await click_shoot(kOnStem);
  assert.equal(shoot.shoot, 'main');
  assert.equal(shoot.iteration, 9);
  assert.equal(shoot.metamer, 5);
  assert.equal(await page.locator('.pruning-overlay .goes').count(), 1);
  await step(page, () =>
    tool()
      .getByRole('button', { name: `Cut above ${shoot.metamer}` })
      .click(),
  );
  const [cut] = (await tree_of()).components.pear.operations;
  assert.deepEqual(cut, { do: 'cut', at: 9, shoots: 'main', above: shoot.metamer });
  assert.equal(await undo_count(page), 1);
  const left = await page.evaluate(() => window.studio.growth.get().grown.nodes);
  assert.ok(left < nodes, `${left} of ${nodes}`);
  // The command line reads the document that the page writes.
  await write_document(place.folder, 'cut.json', await text_of(page));
  const { stdout } = await meristem('measure', `${place.folder}/cut.json`);
  assert.match(stdout, /height/);
  await acted('components.pear.operations[0]');
  await undo_all(page);
  await settled(page);
  assert.equal(await text_of(page), kPear);
  assert.equal(await page.evaluate(() => window.studio.growth.get().grown.nodes), nodes);
});

test('a shoot is cut off at its base, and the whole tree is not', async () => {
  await click_shoot(kOnStem);
  await tool().getByRole('button', { name: 'At its base' }).click();
  assert.match(await tool().locator('.fault-line').innerText(), /Nothing would be left/);
  assert.ok(await tool().getByRole('button', { name: 'Cut off' }).isDisabled());
  await tool().getByRole('button', { name: 'Above' }).click();
  await type_into(page, tool().getByRole('textbox', { name: 'Metamers that stay' }), '6');
  await step(page, () => tool().getByRole('button', { name: 'Cut above 6' }).click());
  assert.equal((await tree_of()).components.pear.operations[0].above, 6);
  await undo_all(page);
  await settled(page);
  await page.evaluate(() => window.studio.bench.pruning.choice.merge({ cut_at: 'here' }));
});

test('a bend and marks are written with their numbers', async () => {
  const shoot = await click_shoot(kOnStem);
  await tool().getByRole('button', { name: 'Bend', exact: true }).first().click();
  await type_into(page, tool().getByRole('textbox', { name: 'Inclination' }), '40');
  await step(page, () => tool().locator('.shoot-act .button.main').click());
  await click_shoot([0, 0.21, 0.01]);
  await tool().getByRole('button', { name: 'Mark', exact: true }).first().click();
  await type_into(page, tool().getByRole('textbox', { name: 'State of the mark' }), 'spare');
  await step(page, () => tool().locator('.shoot-act .button.main').click());
  await click_shoot([0, 0.21, 0.01]);
  await tool().getByRole('button', { name: 'Tie', exact: true }).first().click();
  assert.match(await tool().locator('.fault-line').innerText(), /stem cannot be tied/);
  await tool().getByRole('button', { name: 'Mark', exact: true }).first().click();
  await type_into(page, tool().getByRole('textbox', { name: 'State of the mark' }), 'weak');
  await tool().getByRole('button', { name: 'Summer', exact: true }).click();
  await step(page, () => tool().locator('.shoot-act .button.main').click());
  const operations = (await tree_of()).components.pear.operations;
  assert.deepEqual(operations[0], {
    do: 'bend',
    at: 9,
    shoots: 'main',
    below: shoot.metamer,
    metamers: 3,
    inclination: 40,
  });
  assert.deepEqual(operations[1], { do: 'mark', at: 9, shoots: 'main', state: 'spare' });
  assert.equal(operations[2].season, 'summer');
  assert.equal(await undo_count(page), 3);
  await page.evaluate(() => window.studio.bench.pruning.choice.merge({ season: 'winter', action: 'cut' }));
});

test('the plan lists operations in order and by year; it moves, switches off and takes them away', async () => {
  await leave_fields(page);
  await page.keyboard.press('o');
  const items = page.locator('.plan-item');
  assert.equal(await items.count(), 3);
  assert.match(await items.nth(0).innerText(), /bend main/);
  await page.waitForFunction(() => /acted 1 time/.test(document.querySelector('.plan-item')?.textContent ?? ''));
  await items.nth(1).hover();
  await step(page, () => items.nth(1).getByRole('button', { name: 'Move operation 2 up' }).click());
  assert.equal((await tree_of()).components.pear.operations[0].do, 'mark');
  await items.nth(0).hover();
  await step(page, () => items.nth(0).getByRole('button', { name: 'Let operation 1 act' }).click());
  assert.equal((await tree_of()).components.pear.operations[0].off, true);
  await page.waitForFunction(() => /off/.test(document.querySelector('.plan-item')?.textContent ?? ''));
  await items.nth(2).hover();
  await step(page, () => items.nth(2).getByRole('button', { name: 'Remove operation 3' }).click());
  assert.equal(await items.count(), 2);
  // The inspector shows the rows of the chosen operation.
  await items.nth(1).locator('.plan-choice').click();
  await acted('components.pear.operations[1]');
  assert.equal(await page.locator('.pruning-overlay .act').count(), 1);
  const inclination = items.nth(1).locator('[data-path="components.pear.operations[1].inclination"]');
  await step(page, () => type_into(page, inclination.getByRole('textbox').first(), '20'));
  assert.equal((await tree_of()).components.pear.operations[1].inclination, 20);
  await page.getByRole('button', { name: 'By year' }).click();
  await page.locator('.plan-entry').first().waitFor();
  assert.match(await page.locator('.plan-years').innerText(), /Year 9/);
});

test('before and after stand side by side', async () => {
  await page.getByRole('button', { name: 'In order' }).click();
  const item = page.locator('.plan-item').nth(1);
  await item.hover();
  await item.getByRole('button', { name: 'Pin the state without operation 2 beside the view' }).click();
  await page.locator('.pinned').waitFor();
  await page.waitForFunction(() => !document.querySelector('.pinned .view-note'), null, { timeout: 20000 });
  assert.equal(
    await page.evaluate(
      () =>
        JSON.parse(window.studio.bench.pins.shown.get()[0].text.replace(/\/\/.*/, '')).components.pear.operations[1]
          .off,
    ),
    true,
  );
  await page.getByRole('button', { name: /^Let state A go/ }).click();
});

test('the tree before the last cuts is shown and goes again', async () => {
  const before_it = await text_of(page);
  await page.getByRole('button', { name: 'Before the last cuts' }).click();
  await page.waitForFunction(() => window.studio.growth.get().grown?.dragged === true);
  await page.getByRole('button', { name: 'After the last cuts' }).click();
  await settled(page);
  assert.equal(await text_of(page), before_it);
  assert.deepEqual(await serious_faults(page), []);
  await undo_all(page);
  await settled(page);
  assert.equal(await text_of(page), kPear);
  await leave_fields(page);
  await page.keyboard.press('o');
});

test('by the keyboard alone a shoot is chosen and cut, and undo gives the first bytes', async () => {
  await open_file(page, 'trees.json');
  await page.locator('.view canvas').focus();
  const press = async (key, { shoot, metamer, tree = 0 }) => {
    await page.keyboard.press(key);
    await page.waitForFunction(
      ([name, at, of]) => {
        const found = window.studio.instance.found.get();
        return found?.shoot === name && found.metamer === at && found.tree === of;
      },
      [shoot, metamer, tree],
      { timeout: 5000 },
    );
  };
  const said = async (what) =>
    page.waitForFunction((wanted) => document.querySelector('.shoot-said')?.textContent.includes(wanted), what, {
      timeout: 5000,
    });
  await press('Enter', { shoot: 'main', metamer: 1 });
  await said('main, tree 0, metamer 1 of 14. Order 0, 1.4 m long, 0.1 m from its base');
  await press('PageDown', { shoot: 'main', metamer: 1, tree: 1 });
  await press('PageUp', { shoot: 'main', metamer: 1 });
  await page.keyboard.press('ArrowLeft');
  await said('No shoot bears main');
  await press('ArrowRight', { shoot: 'main.2', metamer: 1 });
  await press('PageDown', { shoot: 'main.4', metamer: 1 });
  await press('ArrowLeft', { shoot: 'main', metamer: 4 });
  await press('ArrowRight', { shoot: 'main.4', metamer: 1 });
  await press('ArrowUp', { shoot: 'main.4', metamer: 2 });
  await press('End', { shoot: 'main.4', metamer: 6 });
  await press('ArrowDown', { shoot: 'main.4', metamer: 5 });
  assert.equal(await page.locator('.pruning-overlay .goes').count(), 1);
  assert.equal(await page.locator('.pruning-overlay .held-place').count(), 1);
  await page.keyboard.press('t');
  assert.equal(
    await tool().getByRole('button', { name: 'Tie', exact: true }).first().getAttribute('aria-pressed'),
    'true',
  );
  await page.keyboard.press('c');
  await step(page, () => page.keyboard.press('Enter'));
  assert.deepEqual((await tree_of()).components.tree.operations, [
    { do: 'cut', at: 7, shoots: 'main.4', tree: 0, above: 5 },
  ]);
  // The view has the focus again. Enter then holds the shoot in its present state.
  await tool().waitFor({ state: 'detached' });
  assert.equal(await page.evaluate(() => document.activeElement?.tagName), 'CANVAS');
  await press('Enter', { shoot: 'main.4', metamer: 5 });
  await page.keyboard.press('Control+z');
  await page.waitForFunction(() => window.studio.document.state.get().undo.done.length === 0);
  await settled(page);
  assert.equal(await text_of(page), kTrees);
  await page.keyboard.press('Escape');
  await tool().waitFor({ state: 'detached' });
  // The plan can hold the shoot as well.
  await page.keyboard.press('o');
  await page.getByRole('button', { name: /^Take hold of a shoot/ }).focus();
  await press('Enter', { shoot: 'main.4', metamer: 5 });
  await page.waitForFunction(() => document.activeElement?.classList.contains('shoot-walk'));
  assert.deepEqual(await serious_faults(page), []);
  await page.keyboard.press('Escape');
  await page.keyboard.press('o');
});

/// Returns a grip of the visible group, with the middle of its drawing.
const grip = (key) => page.locator(`.gizmo-grip[data-grip="${key}"]`);
async function drag_by(from, [dx, dy], { steps = 12, lets_go = true } = {}) {
  await page.mouse.move(...from);
  await page.mouse.down();
  for (let k = 1; k <= steps; k += 1) await page.mouse.move(from[0] + (dx * k) / steps, from[1] + (dy * k) / steps);
  if (lets_go) await page.mouse.up();
}
const middle_of = async (target) => {
  const box = await target.boundingBox();
  return [box.x + box.width / 2, box.y + box.height / 2];
};

test('an obstacle is seen, chosen by a click, and moved by its grips; a drag of many moves is one step', async () => {
  await open_file(page, 'yard.json');
  await page.locator('.view canvas').focus();
  for (const key of ['1', '-', '-', '-', '-']) await page.keyboard.press(key);
  await page.mouse.click(...(await seen_at([1.5, 0.4, 0.5])));
  assert.equal(await page.evaluate(() => window.studio.chosen.get()), 'scene');
  await grip('upper y').waitFor();
  const count = await undo_count(page);
  await step(page, async () => drag_by(await middle_of(grip('upper x').locator('rect')), [40, 0], { steps: 40 }));
  const box = (await tree_of()).scene.obstacles[0].box;
  assert.deepEqual(box[0], [1, 0, -0.5]);
  assert.ok(box[1][0] > 2.05 && box[1][1] === 1.5, JSON.stringify(box));
  assert.equal(await undo_count(page), count + 1);
  await undo_all(page);
  await settled(page);
  assert.equal(await text_of(page), kYard);
});

test('Escape puts a grip back, and the arrow keys move it', async () => {
  await drag_by(await middle_of(grip('upper x').locator('rect')), [30, 0], { lets_go: false });
  await page.waitForFunction(() => Object.keys(window.studio.dragged.get()).length > 0);
  await page.keyboard.press('Escape');
  await page.mouse.up();
  await settled(page);
  assert.equal(await text_of(page), kYard);
  await grip('move x').focus();
  await step(page, () => page.keyboard.press('ArrowLeft'));
  const [low, high] = (await tree_of()).scene.obstacles[0].box;
  assert.ok(low[0] < 1 && Math.abs(high[0] - low[0] - 1) < 1e-9, JSON.stringify([low, high]));
  await page.keyboard.press('PageDown');
  assert.equal(await page.evaluate(() => document.activeElement.dataset.grip), 'move y');
  await step(page, () => type_into(page, page.locator('.gizmo-card').getByRole('textbox', { name: /height/ }), '3'));
  assert.deepEqual(
    (await tree_of()).scene.obstacles[0].box.map((one) => one[1]),
    [0, 3],
  );
});

test('a turn keeps the middle of a box where it is', async () => {
  await grip('turn y').focus();
  await step(page, () => page.keyboard.press('ArrowRight'));
  const obstacle = (await tree_of()).scene.obstacles[0];
  assert.deepEqual(obstacle.rotate, [0, 5, 0]);
  assert.ok(obstacle.translate.some((one) => one !== 0));
  await undo_all(page);
  await settled(page);
});

test('boxes, lamps and poles are put into the scene with their grips', async () => {
  for (const name of ['Box', 'Lamp', 'Pole']) {
    await step(page, () => page.locator('.scene-tools').getByRole('button', { name, exact: true }).click());
    await page.locator('.gizmo-grip').first().waitFor();
  }
  const { obstacles, lamps, supports } = (await tree_of()).scene;
  assert.equal(obstacles.length, 2);
  assert.equal(lamps.length, 1);
  assert.equal(supports.pole.length, 2);
  await step(page, async () => {
    await page.locator('.gizmo-card select').selectOption({ label: 'support wire, point 2' });
    await grip('move y').focus();
    await page.keyboard.press('ArrowUp');
  });
  assert.ok((await tree_of()).scene.supports.wire[1][1] > 1);
  // The button brings a hidden thing into view.
  await page.locator('.gizmo-card select').selectOption({ label: 'obstacle 2, box' });
  const look = page.locator('.gizmo-card').getByRole('button', { name: /see all of it beside the plant/ });
  await page.locator('.view canvas').focus();
  for (let k = 0; k < 8; k += 1) await page.keyboard.press('+');
  await look.click();
  await look.waitFor({ state: 'detached' });
  await undo_all(page);
  await settled(page);
  assert.equal(await text_of(page), kYard);
});

test('a grip of an expression moves the variable that it is, or says what holds it', async () => {
  await open_file(page, 'lamp.json');
  await page.locator('.view canvas').focus();
  for (const key of ['1', '-', '-']) await page.keyboard.press(key);
  await choose(page, 'Scene');
  await page.locator('.gizmo-card select').selectOption({ label: 'lamp 1' });
  // If the value is one variable, the grip moves this variable and follows the mouse.
  const from = await middle_of(grip('move x').locator('.tip'));
  await drag_by(from, [50, 0], { steps: 20, lets_go: false });
  await page.waitForFunction(() => window.studio.dragged.get().far > 0.4);
  const held = await middle_of(grip('move x').locator('.tip'));
  assert.ok(Math.abs(held[0] - from[0]) > 20, `${from[0]} to ${held[0]}`);
  await step(page, () => page.mouse.up());
  const moved = await tree_of();
  assert.ok(moved.variables.far.value > 0.4 && moved.variables.far.value <= 1, JSON.stringify(moved.variables));
  assert.deepEqual(moved.scene.lamps[0].position, ['far', 0.5, 'far*2']);
  assert.equal(await undo_count(page), 1);
  assert.match(await page.evaluate(() => window.studio.document.state.get().undo.done.at(-1).label), /^Set far$/);
  await undo_all(page);
  await settled(page);
  // Moving a plain number beside it keeps the expressions.
  await grip('move y').focus();
  await step(page, () => page.keyboard.press('ArrowUp'));
  const [x, y, z] = (await tree_of()).scene.lamps[0].position;
  assert.ok(x === 'far' && y > 0.5 && z === 'far*2', JSON.stringify([x, y, z]));
  // Any other expression blocks the grip, with a message.
  const refused = page.locator('.gizmo-refused');
  assert.match(await grip('move z').getAttribute('class'), /refuses/);
  await drag_by(await middle_of(grip('move z').locator('.tip')), [30, 10]);
  assert.match(await refused.innerText(), /lamps\[0\]\.position\[2\] is the expression “far\*2”/);
  assert.equal(await undo_count(page), 1);
  assert.deepEqual(await serious_faults(page), []);
  await step(page, () => refused.getByRole('button', { name: 'Replace by its value 0.8' }).click());
  assert.deepEqual((await tree_of()).scene.lamps[0].position, ['far', y, 0.8]);
  await step(page, async () => {
    await grip('move z').focus();
    await page.keyboard.press('ArrowRight');
  });
  assert.notEqual((await tree_of()).scene.lamps[0].position[2], 0.8);
  await undo_all(page);
  await settled(page);
  assert.equal(await text_of(page), kLamp);
});

test('expressions that differ from instance to instance have grips at the first one', async () => {
  await choose(page, 'ball');
  await page.locator('.gizmo-card select').selectOption({ label: 'frame' });
  const y = page.locator('.gizmo-card').getByRole('textbox', { name: 'frame, y', exact: true });
  assert.equal(await y.inputValue(), '0.4');
  await step(page, () => type_into(page, y, '0.6'));
  assert.equal((await tree_of()).variables.far.value, 0.6);
  await type_into(page, page.locator('.gizmo-card').getByRole('textbox', { name: 'frame, x', exact: true }), '0.2');
  assert.match(await page.locator('.gizmo-refused').innerText(), /“0\.1\*i”/);
  assert.deepEqual((await tree_of()).components.ball.frame.translate, ['0.1*i', 'far', 0]);
  await undo_all(page);
  await settled(page);
  assert.equal(await text_of(page), kLamp);
  await open_file(page, 'yard.json');
  await choose(page, 'Scene');
});

test('the sun is dragged along its way for the hour and across for the day', async () => {
  const sky = page.locator('.sky');
  await sky.scrollIntoViewIfNeeded();
  const count = await undo_count(page);
  const at = await middle_of(page.locator('.sun circle').last());
  await step(page, () => drag_by(at, [-14, 4], { steps: 20 }));
  const { sun } = (await tree_of()).scene;
  // West of the meridian it is afternoon.
  assert.ok(sun.hour > 12.1, JSON.stringify(sun));
  assert.equal(await undo_count(page), count + 1);
  await page.locator('.sun').focus();
  await step(page, () => page.keyboard.press('ArrowDown'));
  assert.equal((await tree_of()).scene.sun.day, sun.day - 7);
  await step(page, () => page.keyboard.press('ArrowLeft'));
  assert.ok(Math.abs((await tree_of()).scene.sun.hour - (sun.hour - 0.5)) < 0.051);
  await step(page, () => type_into(page, page.getByRole('textbox', { name: 'Latitude of the sun' }), '35'));
  assert.equal((await tree_of()).scene.latitude, 35);
  // Each field stays within the limits of its row, which are drawn.
  for (const [name, limits, typed, legal] of [
    ['Latitude', '-90 90', '123', 90],
    ['Day', '1 366', '400', 366],
    ['Day', '1 366', '-3', 1],
    ['Hour', '0 24', '30', 24],
  ]) {
    assert.equal(
      await page.locator('.sun-field', { hasText: name }).locator('[data-limits]').getAttribute('data-limits'),
      limits,
      name,
    );
    await step(page, () => type_into(page, page.getByRole('textbox', { name: `${name} of the sun` }), typed));
    const { latitude, sun: now } = (await tree_of()).scene;
    assert.equal({ Latitude: latitude, Day: now.day, Hour: now.hour }[name], legal, `${name} ${typed}`);
  }
  assert.deepEqual(
    await page.evaluate(() => window.studio.document.state.get().faults.filter(({ severity }) => severity === 'error')),
    [],
  );
  await page.getByRole('checkbox', { name: 'Light the view by this sun' }).check();
  assert.deepEqual(await serious_faults(page), []);
  await undo_all(page);
  await settled(page);
  assert.equal(await text_of(page), kYard);
});

test('the position of a fixed sun and the date of a clock stay within their limits', async () => {
  for (const [file, sun, fields] of [
    [
      'fixed.json',
      '{"azimuth": 180, "altitude": 40}',
      [
        ['Altitude', '-90 90', '-120', ['altitude', -90]],
        ['Altitude', '-90 90', '-30', ['altitude', -30]],
        ['Azimuth', '-360 360', '500', ['azimuth', 0]],
      ],
    ],
    [
      'dated.json',
      '{"date": "2026-06-21", "time": 12, "longitude": 9, "utc_offset": 1}',
      [
        ['Day', '1 365', '500', ['date', '2026-12-31']],
        ['Time', '0 24', '25', ['time', 24]],
      ],
    ],
  ]) {
    const text = kYard.replace('{"day": 172, "hour": 12}', sun);
    await write_document(place.folder, file, text);
    await open_file(page, file);
    await choose(page, 'Scene');
    for (const [name, limits, typed, [row, legal]] of fields) {
      assert.equal(
        await page.locator('.sun-field', { hasText: name }).locator('[data-limits]').getAttribute('data-limits'),
        limits,
        name,
      );
      await step(page, () => type_into(page, page.getByRole('textbox', { name: `${name} of the sun` }), typed));
      assert.equal((await tree_of()).scene.sun[row], legal, `${name} ${typed}`);
    }
    await undo_all(page);
    await settled(page);
    assert.equal(await text_of(page), text);
  }
  await open_file(page, 'yard.json');
});

test('the profile of a crown is dragged in the view', async () => {
  await choose(page, 'tree');
  await page.locator('.gizmo-card').waitFor();
  await page.locator('.gizmo-card select').selectOption({ label: 'crown, profile' });
  await step(page, async () => drag_by(await middle_of(grip('point 2').locator('circle').last()), [40, 0]));
  const { profile } = (await tree_of()).components.tree.crown;
  assert.ok(profile[1][0] > 0.85, JSON.stringify(profile));
  assert.deepEqual(
    [profile[0], profile[2]],
    [
      [0.2, 0.6],
      [0, 2],
    ],
  );
  await undo_all(page);
  await settled(page);
  assert.equal(await text_of(page), kYard);
});

test('the outline of a crown is drawn over its attraction points, which follow a hand', async () => {
  await page.locator('[data-path="components.tree.crown"] > .fold-head > .fold-title').click();
  const profile = row(page, 'components.tree.crown.profile');
  const cloud = profile.locator('.curve-cloud');
  await cloud.waitFor({ state: 'attached' });
  assert.equal(await cloud.getAttribute('data-points'), '60');
  const points = await cloud.getAttribute('d');
  // They lie on one side of the axis and within the outline.
  const places = [...points.matchAll(/M(\S+) (\S+)h0/g)].map(([, radius, height]) => [Number(radius), Number(height)]);
  assert.ok(
    places.every(([radius, height]) => radius >= 0 && radius < 0.95 && height >= 0.6 && height <= 2),
    points,
  );
  await profile.scrollIntoViewIfNeeded();
  await drag_by(await middle_of(profile.locator('.curve-point').nth(1)), [14, 0], { lets_go: false });
  const follows = (wants_same) =>
    page.waitForFunction(
      ([known, same]) => (document.querySelector('.curve-cloud').getAttribute('d') === known) === same,
      [points, wants_same],
      { timeout: 20000 },
    );
  await follows(false);
  await page.keyboard.press('Escape');
  await page.mouse.up();
  await follows(true);
  await settled(page);
  assert.equal(await text_of(page), kYard);
});

test('a measured leaf is shown over its points, and drawn by hand', async () => {
  await open_file(page, 'grass.json');
  await choose(page, 'leaf');
  await page.getByRole('button', { name: 'Midrib and width…' }).click();
  const panel = page.getByRole('region', { name: 'Midrib and width' });
  await panel.locator('.curve-dots circle').first().waitFor();
  assert.equal(
    await panel.getByRole('group', { name: 'Midrib', exact: true }).locator('.curve-dots circle').count(),
    9,
  );
  assert.equal(await page.locator('.leaf-points').getAttribute('data-points'), '9');
  await step(page, () =>
    panel
      .getByRole('group', { name: 'Midrib', exact: true })
      .first()
      .getByRole('button', { name: 'Draw by hand' })
      .click(),
  );
  const leaf = (await tree_of()).components.leaf;
  assert.equal(leaf.midrib, undefined);
  assert.equal(leaf.midrib_points.length, 9);
  assert.ok(leaf.length > 0.1);
  await step(page, async () => {
    await panel.locator('.curve-point').nth(4).focus();
    await page.keyboard.press('ArrowUp');
  });
  assert.notDeepEqual((await tree_of()).components.leaf.midrib_points, leaf.midrib_points);
  assert.deepEqual(await box_faults(page), []);
  assert.deepEqual(await serious_faults(page), []);
  await undo_all(page);
  await settled(page);
  assert.equal(await text_of(page), kGrass);
});

test('nothing was complained about on the way', () => {
  assert.deepEqual(
    page.faults.filter((fault) => !/WebGL|GL Driver/i.test(fault)),
    [],
  );
});
