// SPDX-License-Identifier: Apache-2.0
// Actions of a user on the board, with the mouse and with the keyboard alone.
import { field, type_into } from './hands.mjs';
import { changes } from './support.mjs';

export const node = (page, id) => page.locator(`.board-canvas [data-node="${id}"]`);
export const tool = (page, name) => page.locator('.board-tools').getByRole('button', { name, exact: true });

export async function open_board(page) {
  if (await page.locator('.board-canvas').isVisible()) return;
  await page
    .getByRole('group', { name: 'Outline or board' })
    .getByRole('button', { name: 'Board', exact: true })
    .click();
  await page.locator('.board-canvas').waitFor();
}

export const chosen = (page) => page.evaluate(() => window.studio.chosen.get());

/// Clicks a node, in the middle of its visible part.
export async function click_node(page, id) {
  await node(page, id).click();
}

/// Adds a component below another one, by the button and its picture.
export async function add_by_mouse(page, below, type, kind = null) {
  await click_node(page, below);
  await tool(page, 'Add').click();
  const dialog = page.getByRole('dialog');
  if (kind !== null)
    await dialog
      .getByRole('group', { name: 'Kind of the link' })
      .getByRole('button', { name: kind, exact: true })
      .click();
  await changes(page, () => dialog.locator(`[data-add="${type}"]`).click());
  await page.waitForFunction(() => window.studio.chosen.get().startsWith('components.'));
}

export async function rename_by_mouse(page, name) {
  await page
    .locator('.board-tools')
    .getByRole('button', { name: /^More for/ })
    .click();
  await page.getByRole('menuitem', { name: 'Rename…', exact: true }).click();
  await page.locator('#board-name').fill(name);
  await changes(page, () => page.locator('.board-field').getByRole('button', { name: 'Rename' }).click());
  await page.waitForFunction((wanted) => window.studio.chosen.get() === `components.${wanted}`, name);
}

/// Returns the middle of an element, where the mouse can grab it.
export async function middle(target) {
  const box = await target.boundingBox();
  return [box.x + box.width / 2, box.y + box.height / 2];
}

/// Drags from one position to another.
export async function carry(page, [x1, y1], [x2, y2], lets_go = true) {
  await page.mouse.move(x1, y1);
  await page.mouse.down();
  for (let k = 1; k <= 8; k += 1) await page.mouse.move(x1 + ((x2 - x1) * k) / 8, y1 + ((y2 - y1) * k) / 8);
  if (lets_go) await page.mouse.up();
}

/// Draws a link from the edge of one node to another node.
export async function draw_link(page, from, to, lets_go = true) {
  await node(page, from).hover();
  await carry(page, await middle(page.locator(`[data-port="${from}"]`)), await middle(node(page, to)), lets_go);
}

/// Makes a component the child of another one, by dragging it there.
export async function hang_by_mouse(page, id, on) {
  const [x, y] = await middle(node(page, id));
  await changes(page, async () => carry(page, [x - 20, y], await middle(node(page, on))));
}

/// Chooses the link above a component and gives it this kind.
export async function set_kind_by_mouse(page, id, kind) {
  await click_node(page, id);
  await page
    .locator('.board-tools')
    .getByRole('button', { name: /^More for/ })
    .click();
  await page.getByRole('menuitem', { name: 'Choose its link', exact: true }).click();
  await changes(page, () => page.locator('.board-tools').getByRole('button', { name: kind, exact: true }).click());
}

// With the keyboard alone.

const keyboard_is_at = (page, selector) =>
  page.evaluate((wanted) => document.activeElement?.matches(wanted) ?? false, selector);

/// Presses Tab until an element has the focus.
export async function tab_to(page, selector, key = 'Tab') {
  for (let k = 0; k < 400; k += 1) {
    if (await keyboard_is_at(page, selector)) return;
    await page.keyboard.press(key);
  }
  throw new Error(`Tab does not come to ${selector}`);
}

/// Goes to a component by arrow keys, from the focused component.
export async function go_to(page, id) {
  await tab_to(page, '.board-node');
  const way = await page.evaluate((wanted) => {
    const nodes = [...document.querySelectorAll('.board-node')].map((one) => one.dataset.node);
    const { graph } = window.studio.board.actions;
    const above = (one) => graph.links.find((link) => link.to === one && link.recursion === null)?.from;
    const found = [wanted];
    while (above(found[0]) !== undefined) found.unshift(above(found[0]));
    return nodes.includes(wanted) ? found : null;
  }, id);
  if (!way) throw new Error(`there is no ${id} on the board`);
  const here = () => page.evaluate(() => document.activeElement.dataset.node);
  const down = (await page.locator('.board-canvas').getAttribute('data-direction')) === 'down';
  const [up, below, before, behind] = down
    ? ['ArrowUp', 'ArrowDown', 'ArrowLeft', 'ArrowRight']
    : ['ArrowLeft', 'ArrowRight', 'ArrowUp', 'ArrowDown'];
  while ((await here()) !== way[0]) {
    const at = await here();
    await page.keyboard.press(up);
    if ((await here()) === at) break;
  }
  for (const next of way) {
    if ((await here()) === next) continue;
    if (next !== way[0]) await page.keyboard.press(below);
    for (const key of [before, behind]) {
      for (let k = 0; k < 40 && (await here()) !== next; k += 1) {
        const at = await here();
        await page.keyboard.press(key);
        if ((await here()) === at) break;
      }
    }
    if ((await here()) !== next)
      throw new Error(
        `the arrow keys do not come to ${next}, but to ${await here()} of ${await page.locator('.board-node').evaluateAll((all) => all.map((one) => one.dataset.node))}`,
      );
  }
}

/// Adds a component below the focused component.
export async function add_by_keyboard(page, type, kind = null) {
  await page.keyboard.press('a');
  await page.getByRole('dialog').waitFor();
  if (kind !== null) {
    await tab_to(page, '[aria-label="Kind of the link"] button:first-child');
    while ((await page.evaluate(() => document.activeElement.textContent)) !== kind) await page.keyboard.press('Tab');
    await page.keyboard.press('Space');
    await tab_to(page, '.dialog input[type=search]', 'Shift+Tab');
  }
  await page.keyboard.type(type);
  await changes(page, () => page.keyboard.press('Enter'));
  await page.getByRole('dialog').waitFor({ state: 'detached' });
}

export async function rename_by_keyboard(page, name) {
  await page.keyboard.press('F2');
  await page.locator('#board-name').waitFor();
  await page.keyboard.press('Control+a');
  await page.keyboard.type(name);
  await changes(page, () => page.keyboard.press('Enter'));
  await page.waitForFunction(
    (wanted) => window.studio.chosen.get() === `components.${wanted}` && document.activeElement?.matches('.board-node'),
    name,
  );
}

/// Finds a piece of the text and replaces it.
export async function retype_by_keyboard(page, piece, replacement) {
  await tab_to(page, '.cm-content');
  await page.keyboard.press('Control+f');
  await page.locator('.cm-search input[name=search]').waitFor();
  await page.keyboard.press('Control+a');
  // The search begins when a key is released.
  await page.keyboard.insertText(piece.slice(0, -1));
  await page.keyboard.type(piece.slice(-1));
  await page.keyboard.press('Enter');
  await page.keyboard.press('Escape');
  await changes(page, () =>
    replacement === '' ? page.keyboard.press('Delete') : page.keyboard.insertText(replacement),
  );
}

/// Gives the chosen variable its name.
export async function name_variable(page, name) {
  await changes(page, () => type_into(page, field(page, 'Name'), name));
  await page.waitForFunction((wanted) => window.studio.chosen.get() === `variables.${wanted}`, name);
}
