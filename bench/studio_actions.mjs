// SPDX-License-Identifier: Apache-2.0
// Random actions of a user in the studio. Each action takes the page and draws its decisions from `chance`. An action
// that is impossible at the moment returns false. Actions use only the mouse and the keyboard, and no functions of the
// page. Actions that save also take the files of the server's folder (studio_soak.mjs).
import {
  choose,
  leave_fields,
  open_file,
  open_model,
  row,
  save_as,
  save_here,
  start_new,
  type_into,
} from '../tests/studio/page/hands.mjs';
import { patient, settled } from '../tests/studio/page/support.mjs';

export const kModels = [
  'oak',
  'pear-espalier',
  'slender',
  'sunflower',
  'box-hedge',
  'tulip',
  'fern',
  'caladium',
  'low-poly-shrub',
  'mint',
];
/// The small document that is open while memory is measured. No action saves it.
export const kRestFile = 'small.json';
const kPatience = { timeout: patient(5000) };
/// Names of files with letters that take two, three and four bytes, and with characters that are special in shells and
/// addresses.
export const kFileNames = ['plain.json', 'Ähre.json', '樹 木.json', '🌳🌿.json', "it's 100% #1 & more.json"];
/// Names of plants, with the same kinds of letters.
export const kPlantNames = ['Ähre für Jürgen', '樹木', '🌳 with a "quoted" \\ word', 'Сосна'];

/// Random numbers from 0 to 1 from a seed (mulberry32), and functions that draw with them.
export class Chance {
  constructor(seed) {
    this.state_ = seed >>> 0;
  }

  next() {
    this.state_ = (this.state_ + 0x6d2b79f5) >>> 0;
    let mixed = Math.imul(this.state_ ^ (this.state_ >>> 15), this.state_ | 1);
    mixed ^= mixed + Math.imul(mixed ^ (mixed >>> 7), mixed | 61);
    return ((mixed ^ (mixed >>> 14)) >>> 0) / 4294967296;
  }
  happens(share) {
    return this.next() < share;
  }
  whole(low, high) {
    return low + Math.floor(this.next() * (high - low + 1));
  }
  one_of(all) {
    return all[Math.min(all.length - 1, Math.floor(this.next() * all.length))];
  }
}

/// Returns a random visible element. Null if no element is visible.
async function any(chance, all) {
  const share = chance.next(); // drawn in any case, so that the numbers after it stay
  const count = await all.count();
  return count === 0 ? null : all.nth(Math.min(count - 1, Math.floor(share * count)));
}

async function press(page, key, times = 1) {
  for (let k = 0; k < times; k += 1) await page.keyboard.press(key);
}

async function pull(page, chance, target) {
  await target.scrollIntoViewIfNeeded(kPatience);
  const box = await target.boundingBox();
  if (!box) return false;
  const [moves, reach, lets_go] = [chance.whole(3, 30), chance.next() - 0.5, chance.happens(0.7)];
  const [x, y] = [box.x + box.width * (0.2 + 0.6 * chance.next()), box.y + box.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  for (let k = 1; k <= moves; k += 1) await page.mouse.move(x + (reach * 160 * k) / moves, y + (k % 2));
  if (!lets_go) await page.keyboard.press('Escape');
  await page.mouse.up();
  return true;
}

async function view_point(page, chance) {
  const box = await page.locator('.centre .view > canvas').boundingBox();
  return [box.x + box.width * (0.3 + 0.4 * chance.next()), box.y + box.height * (0.15 + 0.6 * chance.next())];
}

/// Shows the outline and the inspector if another panel hides them.
async function show_inspector(page) {
  if ((await page.locator('.left.of-board').count()) > 0)
    await page
      .getByRole('group', { name: 'Outline or board' })
      .getByRole('button', { name: 'Outline', exact: true })
      .click(kPatience);
  if ((await page.locator('.right.of-inspector').count()) === 0)
    await page
      .getByRole('group', { name: 'Side panel' })
      .getByRole('button', { name: 'Inspector', exact: true })
      .click(kPatience);
}

async function choose_component(page, chance) {
  await show_inspector(page);
  const one = await any(chance, page.locator('.outline-choice'));
  await one?.click(kPatience);
}

async function open_another(page, chance) {
  const model = chance.one_of([...kModels, 'own.json']);
  if (model === 'own.json') {
    await open_file(page, model);
    return true;
  }
  await open_model(page, model);
  const banner = page.locator('[data-banner="kept"]');
  const is_restored = chance.happens(0.3);
  if (await banner.isVisible())
    await banner.getByRole('button', { name: is_restored ? 'Restore' : 'Discard' }).click(kPatience);
  return true;
}

async function pull_a_handle(page, chance) {
  const one = await any(chance, page.locator('.handles input[type=range]'));
  return one !== null && pull(page, chance, one);
}

async function pull_a_row(page, chance) {
  await choose_component(page, chance);
  const one = await any(chance, page.locator('.inspector .row input[type=range]'));
  return one !== null && pull(page, chance, one);
}

async function type_a_number(page, chance) {
  await choose_component(page, chance);
  const one = await any(chance, page.locator('.inspector .row[data-kind=number] input[inputmode=decimal]'));
  const [factor, kind] = [0.6 + 0.8 * chance.next(), chance.next()];
  if (!one) return false;
  await one.click(kPatience);
  const value = Number(await one.inputValue());
  const text =
    kind < 0.7 && Number.isFinite(value)
      ? String(Number((value * factor).toPrecision(3)))
      : kind < 0.85
        ? '1/3'
        : chance.one_of(['0.1 + 0.01*i', 'no_such_name', '2*']);
  await press(page, 'Control+a');
  await page.keyboard.type(text);
  await page.keyboard.press(chance.happens(0.85) ? 'Enter' : 'Escape');
  return true;
}

async function undo_and_redo(page, chance) {
  await leave_fields(page);
  await press(page, 'Control+z', chance.whole(1, 8));
  await press(page, 'Control+Shift+Z', chance.whole(0, 4));
  return true;
}

async function click_the_plant(page, chance) {
  const [x, y] = await view_point(page, chance);
  await page.mouse.click(x, y);
  const tool = page.locator('.shoot-tool');
  await tool.waitFor({ timeout: 700 }).catch(() => undefined);
  const [action, acts] = [chance.one_of(['Cut', 'Bend', 'Tie', 'Mark']), chance.happens(0.7)];
  if (!(await tool.isVisible())) return true;
  await tool.getByRole('button', { name: action, exact: true }).first().click(kPatience);
  const main = tool.locator('.shoot-act .button.main');
  if (acts && (await main.isEnabled(kPatience))) await main.click(kPatience);
  return true;
}

async function walk_the_tree(page, chance) {
  await page.locator('.centre .view > canvas').focus();
  await page.keyboard.press('Enter');
  const tool = page.locator('.shoot-tool');
  await tool.waitFor({ timeout: 1500 }).catch(() => undefined);
  const keys = Array.from({ length: chance.whole(3, 15) }, () =>
    chance.one_of(['ArrowLeft', 'ArrowRight', 'ArrowRight', 'ArrowUp', 'ArrowDown', 'PageUp', 'PageDown', 'End']),
  );
  const end = chance.one_of(['Enter', 'Escape']);
  if (!(await tool.isVisible())) return false;
  for (const key of keys) await page.keyboard.press(key);
  await page.keyboard.press('c');
  await page.keyboard.press(end);
  return true;
}

async function see_growth(page, chance) {
  await leave_fields(page);
  await page.keyboard.press('s');
  const steps = page.locator('.growth-panel');
  await steps.waitFor(kPatience);
  const slider = page.getByRole('slider', { name: 'Step of growth' });
  const [back, on] = [chance.whole(1, 25), chance.whole(0, 10)];
  await slider.waitFor({ timeout: patient(3000) }).catch(() => undefined);
  if (await slider.isVisible()) {
    await slider.focus();
    await press(page, 'ArrowLeft', back);
    await press(page, 'ArrowRight', on);
  }
  for (let k = 0; k < 2; k += 1) await (await any(chance, page.locator('.growth-parts .chip')))?.click(kPatience);
  await settled(page);
  if (chance.happens(0.8) && (await steps.isVisible())) {
    await leave_fields(page);
    await page.keyboard.press('s');
  }
  return true;
}

async function scrub_time(page, chance) {
  await leave_fields(page);
  const timeline = page.locator('.timeline');
  if (!(await timeline.isVisible())) await page.keyboard.press('k');
  await timeline.waitFor(kPatience);
  await page.getByRole('slider', { name: 'Time that is shown' }).focus();
  for (let k = chance.whole(3, 12); k > 0; k -= 1)
    await page.keyboard.press(chance.one_of(['ArrowRight', 'Shift+ArrowRight', 'ArrowLeft', 'End', 'Home']));
  if (chance.happens(0.5)) {
    await leave_fields(page);
    await page.keyboard.press('Shift+K');
    await page.waitForTimeout(chance.whole(200, 1200));
    await page.keyboard.press('Shift+K');
  }
  await leave_fields(page);
  if (chance.happens(0.8)) await page.keyboard.press('k');
  return true;
}

async function open_panels(page, chance) {
  await leave_fields(page);
  for (let k = chance.whole(2, 6); k > 0; k -= 1) {
    await page.keyboard.press(chance.one_of(['t', 'g', 'o', 'm', 'b', 'w', 'e', 'f', '1', '3', '7']));
    if (chance.happens(0.5)) await page.waitForTimeout(chance.whole(50, 400));
  }
  if (chance.happens(0.5)) await page.getByRole('button', { name: /^Theme/ }).click(kPatience);
  return true;
}

async function type_text(page, chance) {
  await leave_fields(page);
  const editor = page.getByRole('textbox', { name: 'Text of the document' });
  if (!(await editor.isVisible())) await page.keyboard.press('t');
  await editor.click(kPatience);
  await page.keyboard.press(chance.one_of(['Control+End', 'Control+Home', 'PageDown']));
  await page.keyboard.type(chance.one_of([' ', '\n', '"', '// a note', '}']));
  await page.waitForTimeout(chance.whole(50, 500));
  const is_taken_back = chance.happens(0.9);
  if (is_taken_back) await press(page, 'Control+z', 2);
  await leave_fields(page);
  await page.keyboard.press('t');
  return true;
}

async function look_at_strips(page, chance) {
  const one = await any(chance, page.locator('.handle'));
  const [takes, closes] = [chance.happens(0.4), chance.happens(0.8)];
  if (!one) return false;
  await one.hover(kPatience);
  const button = one.getByRole('button', { name: /^Plants over/ });
  if (!(await button.isVisible())) return false;
  await button.click(kPatience);
  await page
    .waitForFunction(() => document.querySelectorAll('.strip img.still').length > 1, null, { timeout: patient(8000) })
    .catch(() => undefined);
  if (takes) await (await any(chance, page.locator('.strip button')))?.click(kPatience);
  if (closes) await button.click(kPatience);
  return true;
}

async function throw_nine(page, chance) {
  await leave_fields(page);
  await page.keyboard.press('n');
  const dialog = page.getByRole('dialog');
  await dialog.waitFor(kPatience);
  await page.waitForTimeout(chance.whole(100, 2500));
  const takes = chance.happens(0.4);
  const plant = await any(chance, dialog.getByRole('button', { name: /^Plant \d/ }));
  if (takes && plant) await plant.click(kPatience);
  return true;
}

async function pin_a_state(page, chance) {
  await leave_fields(page);
  await page.keyboard.press('p');
  await page.waitForTimeout(chance.whole(100, 1500));
  const one = await any(chance, page.locator('.pinned').getByRole('button', { name: /^Let state/ }));
  if (chance.happens(0.7)) await one?.click(kPatience);
  return true;
}

async function move_the_camera(page, chance) {
  const [x, y] = await view_point(page, chance);
  await page.mouse.move(x, y);
  await page.mouse.down({ button: chance.happens(0.3) ? 'right' : 'left' });
  for (let k = 1; k <= chance.whole(3, 20); k += 1) await page.mouse.move(x + 8 * k, y + 3 * k);
  await page.mouse.up();
  await page.mouse.up({ button: 'right' });
  await page.mouse.wheel(0, chance.whole(-300, 300));
  if (chance.happens(0.5)) await page.mouse.dblclick(x, y);
  return true;
}

async function move_grips(page, chance) {
  await show_inspector(page);
  await choose(page, 'Scene');
  const adds = chance.one_of(['Box', 'Lamp', 'Pole', '', '']);
  if (adds !== '') await page.locator('.scene-tools').getByRole('button', { name: adds, exact: true }).click(kPatience);
  const list = page.locator('.gizmo-card select');
  await list.waitFor({ timeout: 2000 }).catch(() => undefined);
  if (!(await list.isVisible())) return false;
  const names = await list
    .locator('option')
    .evaluateAll((all) => all.map((one) => one.value).filter((one) => one !== ''));
  if (names.length === 0) return false;
  await list.selectOption(chance.one_of(names));
  const grip = await any(chance, page.locator('.gizmo-grip'));
  await grip?.focus();
  for (let k = chance.whole(1, 8); k > 0; k -= 1)
    await page.keyboard.press(chance.one_of(['ArrowUp', 'ArrowRight', 'ArrowLeft', 'Shift+ArrowUp', 'PageDown']));
  return true;
}

async function export_files(page, chance) {
  await leave_fields(page);
  await page.keyboard.press('Control+e');
  const dialog = page.getByRole('dialog');
  await dialog.waitFor(kPatience);
  const format = await any(chance, dialog.locator('.format').filter({ hasNotText: /path tracer|\.(png|jpg)/ }));
  await format?.click(kPatience);
  const button = dialog.getByRole('button', { name: 'Export', exact: true });
  if (await button.isEnabled(kPatience)) {
    await button.click(kPatience);
    await dialog
      .locator('.made-file')
      .waitFor({ timeout: chance.happens(0.8) ? patient(20000) : 50 })
      .catch(() => undefined);
  }
  return true;
}

async function work_on_the_board(page, chance) {
  await leave_fields(page);
  if (!(await page.locator('.board-canvas').isVisible())) await page.keyboard.press('b');
  await page.locator('.board-canvas').waitFor(kPatience);
  const node = await any(chance, page.locator('.board-canvas [data-node]'));
  const keys = Array.from({ length: chance.whole(1, 4) }, () =>
    chance.one_of(['Control+d', 'Control+c', 'Control+v', 'Delete', 'h', 'Space', 'ArrowDown', 'ArrowRight']),
  );
  if (node && (await node.isVisible())) {
    await node.click({ ...kPatience, force: true });
    for (const key of keys) await page.keyboard.press(key);
  }
  await leave_fields(page);
  await page.keyboard.press('b');
  return true;
}

async function draw_anew(page, chance) {
  await leave_fields(page);
  if (chance.happens(0.5)) await page.keyboard.press('r');
  else if (await page.getByRole('button', { name: 'Surprise me', exact: true }).isVisible())
    await page.getByRole('button', { name: 'Surprise me', exact: true }).click(kPatience);
  return true;
}

async function hide_and_show(page, chance) {
  await show_inspector(page);
  const item = await any(
    chance,
    page.locator('.outline-item').filter({ has: page.getByRole('button', { name: /^Draw / }) }),
  );
  if (!item) return false;
  await item.hover(kPatience);
  await item.getByRole('button', { name: /^Draw / }).click(kPatience);
  return true;
}

/// Types the document's name in the inspector.
export async function name_the_plant(page, name) {
  await leave_fields(page);
  await show_inspector(page);
  await choose(page, 'Document');
  await type_into(page, row(page, 'name').getByRole('textbox'), name);
}

async function rename_the_plant(page, chance) {
  await name_the_plant(page, chance.one_of(kPlantNames));
  return true;
}

async function start_a_new_one(page, chance) {
  await start_new(page);
  const name = chance.one_of(kPlantNames);
  if (chance.happens(0.7)) await name_the_plant(page, name);
  return true;
}

const answer_of = (chance) => (chance.happens(0.8) ? 'Save anyway' : 'Do not save');

async function save_under_a_name(page, chance) {
  return save_as(page, chance.one_of(kFileNames), answer_of(chance));
}

/// Saves to the file that was opened or saved before.
async function save_it_here(page, chance) {
  const [name, answer] = [chance.one_of(kFileNames), answer_of(chance)];
  const { path } = await page.evaluate(() => window.studio.document.state.get());
  return path === null || path === kRestFile ? save_as(page, name, answer) : save_here(page, answer);
}

/// Saves after another program has written the file.
async function save_over_others(page, chance, files) {
  const answer = answer_of(chance);
  const { path } = await page.evaluate(() => window.studio.document.state.get());
  if (path === null || path === kRestFile) return false;
  const other = `{"meristem": 1, "name": "Written by another program", "seed": ${chance.whole(1, 9999)}}\n`;
  await files.write(path, other);
  return save_here(page, answer);
}

async function save_change_and_save(page, chance) {
  const [name, answer] = [chance.one_of(kFileNames), answer_of(chance)];
  if (!(await save_as(page, name, answer))) return false;
  await leave_fields(page);
  await press(page, 'r', chance.whole(1, 3));
  await settled(page);
  return save_here(page, answer);
}

async function reopen_a_file(page, chance, files) {
  const share = chance.next();
  const names = await files.documents();
  if (names.length === 0) return false;
  const name = names[Math.min(names.length - 1, Math.floor(share * names.length))];
  await open_file(page, name);
  await files.compare_opened(page, name);
  return true;
}

/// The actions with their relative frequencies.
export const kActions = [
  [6, open_another],
  [12, pull_a_handle],
  [12, pull_a_row],
  [12, type_a_number],
  [10, undo_and_redo],
  [8, click_the_plant],
  [6, walk_the_tree],
  [5, see_growth],
  [5, scrub_time],
  [10, open_panels],
  [4, type_text],
  [4, look_at_strips],
  [2, throw_nine],
  [3, pin_a_state],
  [6, move_the_camera],
  [6, move_grips],
  [4, export_files],
  [4, work_on_the_board],
  [4, draw_anew],
  [4, hide_and_show],
  [3, rename_the_plant],
  [3, start_a_new_one],
  [4, save_under_a_name],
  [6, save_it_here],
  [2, save_over_others],
  [3, save_change_and_save],
  [4, reopen_a_file],
];

export function next_action(chance) {
  let left = chance.next() * kActions.reduce((sum, [often]) => sum + often, 0);
  for (const [often, action] of kActions) {
    left -= often;
    if (left < 0) return action;
  }
  return kActions[0][1];
}
