// SPDX-License-Identifier: Apache-2.0
// Actions of a user with mouse and keyboard. The page's own state is read for results, and its functions are never
// called.
import { changes, frames, kept_work, patient, settled, text_of } from './support.mjs';

export const slider = (page, name) => page.getByRole('slider', { name: `${name}, slider`, exact: true });
export const field = (page, name) => page.getByRole('textbox', { name, exact: true });
export const row = (page, path) => page.locator(`.inspector [data-path="${path}"]`);

/// Removes the focus, as a click beside all elements does.
export async function leave_fields(page) {
  await page.locator('.status').click({ position: { x: 300, y: 10 } });
}

/// Chooses a file of the server's folder in the dialog.
export async function choose_from_files(page, name) {
  await page.getByRole('button', { name: 'Open a file' }).click();
  for (const one of name.split('/'))
    await page
      .getByRole('dialog')
      .locator('.file', { has: page.getByText(one, { exact: true }) })
      .click();
  await page.getByRole('dialog').waitFor({ state: 'detached' });
}

/// Opens a file of the server's folder, and discards unsaved work on it.
export async function open_file(page, name) {
  const packets = await page.evaluate(() => window.studio.connection.counts.packets);
  await choose_from_files(page, name);
  await page.waitForFunction(
    ([path, known]) => {
      const { studio } = window;
      const { path: open, good } = studio.document.state.get();
      return (
        open === path &&
        (!good || studio.connection.counts.packets > known) &&
        studio.document.state.get().undo.done.length === 0
      );
    },
    [name, packets],
  );
  await settled(page);
  // The page removes kept work shortly after it was undone, so earlier work may be missing by now.
  const banner = page.locator('[data-banner="kept"]');
  while (!(await banner.isVisible())) {
    const kept = await kept_work(page, name);
    if (kept === null || kept.text === (await text_of(page))) return;
    await frames(page, 1);
  }
  await banner.getByRole('button', { name: 'Discard' }).click();
  await banner.waitFor({ state: 'detached' });
}

/// Begins a new plant.
export async function start_new(page) {
  await page.getByRole('button', { name: 'New plant' }).click();
  await page.waitForFunction(() => {
    const { path, model, undo } = window.studio.document.state.get();
    return path === null && model === null && undo.done.length === 0;
  });
  await settled(page);
}

/// Does something that saves. If the page asks because the file on the disk has changed, `answer` is the button to
/// press. Returns true if the file was saved. Throws if the page reports a failure.
async function saves(page, act, answer) {
  const last = await page.evaluate(() => Math.max(0, ...window.studio.toasts.shown.get().map((one) => one.id)));
  const outcome = async () => {
    const found = await page.waitForFunction((known) => {
      const { toasts, shell } = window.studio;
      const message = toasts.shown
        .get()
        .find(({ id, text, is_fault }) => id > known && (is_fault || text.startsWith('Saved ')));
      if (message) return message.text;
      return shell.get().conflict && 'conflict';
    }, last);
    return found.jsonValue();
  };
  await act();
  let said = await outcome();
  if (said === 'conflict') {
    const banner = page.locator('[data-banner="conflict"]');
    await banner.getByRole('button', { name: answer }).click();
    await banner.waitFor({ state: 'detached' });
    if (answer === 'Do not save') return false;
    said = await outcome();
  }
  if (!said.startsWith('Saved ')) throw new Error(`not saved: ${said}`);
  return true;
}

/// Saves a document that has a file.
export async function save_here(page, answer = 'Save anyway') {
  await leave_fields(page);
  return saves(page, () => page.keyboard.press('Control+s'), answer);
}

/// Saves under a name in the server's folder.
export async function save_as(page, name, answer = 'Save anyway') {
  await leave_fields(page);
  await page.keyboard.press('Control+Shift+s');
  const dialog = page.getByRole('dialog');
  const is_saved = await saves(
    page,
    () => type_into(page, dialog.getByRole('textbox', { name: 'Name' }), name),
    answer,
  );
  await dialog.waitFor({ state: 'detached' });
  return is_saved;
}

/// Opens a shipped plant from the list with their pictures.
export async function open_model(page, name) {
  await leave_fields(page);
  await page.keyboard.press('Control+m');
  await page.locator(`[data-model="${name}"]`).click();
  await page.waitForFunction(
    (wanted) => window.studio.document.state.get().model === wanted && window.studio.growth.get().shown,
    name,
    { timeout: patient(60_000) },
  );
  await settled(page);
}

/// Chooses an entry of the outline by its title: a component, a link, a part of the document.
export async function choose(page, title) {
  await page
    .locator('.outline-choice')
    .filter({ has: page.locator('.outline-title', { hasText: new RegExp(`^${title}$`) }) })
    .click();
}

/// Replaces the text of a field, and confirms it.
export async function type_into(page, target, text, key = 'Enter') {
  await target.click();
  await page.keyboard.press('Control+a');
  await page.keyboard.type(text);
  await page.keyboard.press(key);
}

/// Puts the mouse on an element at shares of its size.
export async function point_at(page, target, across = 0.5, down = 0.5) {
  await target.scrollIntoViewIfNeeded();
  const box = await target.boundingBox();
  const [x, y] = [box.x + across * box.width, box.y + down * box.height];
  await page.mouse.move(x, y);
  return { x, y, box };
}

/// Holds the mouse on an element and moves it in steps of whole pixels.
export async function drag(
  page,
  target,
  [right, down],
  { across = 0.5, from_top = 0.5, steps = 10, lets_go = true } = {},
) {
  const { x, y } = await point_at(page, target, across, from_top);
  await page.mouse.down();
  for (let k = 1; k <= steps; k += 1) await page.mouse.move(x + (right * k) / steps, y + (down * k) / steps);
  if (lets_go) await page.mouse.up();
}

/// Picks an entry of the menu of a row.
export async function pick(page, target, entry) {
  await target.hover();
  await target
    .getByRole('button', { name: /^More for/ })
    .first()
    .click();
  await page.getByRole('menuitem', { name: entry, exact: true }).click();
}

/// Does a step of the undo list, and waits until the text has the step and the plant shows it.
export async function step(page, act) {
  await changes(page, act);
  await settled(page);
}

/// Undoes by the keyboard until nothing is left to undo.
export async function undo_all(page) {
  const count = await page.evaluate(() => window.studio.document.state.get().undo.done.length);
  await page.keyboard.down('Control');
  await Promise.all(Array.from({ length: count }, () => page.keyboard.press('z')));
  await page.keyboard.up('Control');
  await page.waitForFunction(() => window.studio.document.state.get().undo.done.length === 0);
}

/// Finds a word in the editor of the text and replaces it.
export async function retype(page, word, replacement) {
  const editor = page.getByRole('textbox', { name: 'Text of the document' });
  await editor.click();
  await page.keyboard.press('Control+f');
  await type_into(page, page.locator('.cm-search input[name=search]'), word, 'Enter');
  await page.keyboard.press('Escape');
  await page.keyboard.insertText(replacement);
}
