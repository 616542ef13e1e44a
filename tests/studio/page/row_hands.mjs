// SPDX-License-Identifier: Apache-2.0
// Sets each kind of row of the inspector, with mouse and keyboard.
import assert from 'node:assert/strict';

import { type_into } from './hands.mjs';
import { changes } from './support.mjs';

/// Returns the row or the fold at a path.
export const at_path = (page, path) => page.locator(`.inspector [data-path="${path.replaceAll('"', '\\"')}"]`);

export const same = (a, b) => {
  try {
    assert.deepEqual(a, b);
    return true;
  } catch {
    return false;
  }
};

/// Returns the document as plain JSON.
export const said_in = (page) => page.evaluate(() => window.studio.document.state.get().tree.value);

/// Returns the value of the document at a path, or undefined.
async function said_at(page, path) {
  const steps = [...path.matchAll(/"([^"]*)"|[^.[\]"]+/g)].map((one) => one[1] ?? one[0]);
  const said = await page.evaluate(
    (way) => JSON.stringify(way.reduce((value, step) => value?.[step], window.studio.document.state.get().tree.value)),
    steps,
  );
  return said === undefined ? undefined : JSON.parse(said);
}

/// Types into a field that has another content. When no change is under way, the field shows the text's value.
async function type_value(page, target, text, key = 'Enter') {
  await page.waitForFunction(() => Object.keys(window.studio.dragged.get()).length === 0);
  if ((await target.inputValue()) === text) return;
  await changes(page, () => type_into(page, target, text, key));
}

async function pick_own(page, element, entry) {
  await element.hover();
  await element.locator(':scope > [aria-haspopup=menu], :scope > .fold-head > [aria-haspopup=menu]').click();
  await page.getByRole('menuitem', { name: entry, exact: true }).click();
}

const label_of = (row) => row.name.replaceAll('_', ' ');
const box_named = (element, name) => element.getByRole('textbox', { name, exact: true });

async function set_number(page, element, row, value) {
  const label = label_of(row);
  const is_range = Array.isArray(value);
  if (is_range || typeof value === 'object') {
    await changes(page, () => pick_own(page, element, is_range ? 'Range' : 'Range and expression'));
    const [first, last] = is_range ? value : value.range;
    await type_value(page, box_named(element, `${label}, first`), String(first));
    await type_value(page, box_named(element, `${label}, last`), String(last));
    if (!is_range) await type_value(page, box_named(element, `${label}, applied to the range`), value.apply);
    return;
  }
  // In the field of a number, an expression of numbers would be evaluated.
  if (typeof value === 'string') await changes(page, () => pick_own(page, element, 'Expression'));
  await type_value(page, element.getByRole('textbox').first(), String(value));
}

async function set_vector(page, element, row, value) {
  const names = row.kind === 'integers' ? value.map((_, k) => k + 1) : ['x', 'y', 'z'];
  for (const [k, one] of value.entries())
    await type_value(page, box_named(element, `${label_of(row)} ${names[k]}`), String(one));
}

async function set_written(page, element, value) {
  const field = element.locator('.text-field.code').first();
  if (!(await field.isVisible())) await element.getByRole('button', { name: 'As text' }).click();
  await changes(page, () => type_into(page, field, JSON.stringify(value), 'Control+Enter'));
}

async function set_positions(page, element, row, value) {
  const label = label_of(row);
  const rows = () => element.locator('.vector').count();
  while ((await rows()) < value.length)
    await changes(page, () => element.getByRole('button', { name: `Add a position to ${label}` }).click());
  while ((await rows()) > value.length)
    await changes(page, () =>
      element
        .getByRole('button', { name: /^Remove position/ })
        .last()
        .click(),
    );
  for (const [k, position] of value.entries()) {
    for (const [axis, one] of position.entries())
      await type_value(page, box_named(element, `${label} ${k + 1}, ${'xyz'[axis]}`), String(one));
  }
}

async function set_box(page, element, row, value) {
  for (const [k, corner] of value.entries()) {
    for (const [axis, one] of corner.entries())
      await type_value(
        page,
        box_named(element, `${label_of(row)}, ${k === 0 ? 'lower' : 'upper'} ${'xyz'[axis]}`),
        String(one),
      );
  }
}

async function set_colours(page, element, _row, value) {
  const fields = element.locator('.text-field');
  while ((await fields.count()) < value.length)
    await changes(page, () => element.getByRole('button', { name: /^Add a colour/ }).click());
  for (const [k, colour] of value.entries()) await type_value(page, fields.nth(k), colour);
}

async function set_selection(page, element, row, value) {
  const text = (entry) => (Array.isArray(entry) ? `${entry[0]}-${entry[1]}` : String(entry));
  for (const entry of value)
    await changes(page, () => type_into(page, box_named(element, `Add to ${label_of(row)}`), text(entry)));
}

/// Files beside the document are chosen in the list of files, and other files are typed.
async function set_file(page, element, _row, value) {
  if (value.includes('/')) return type_value(page, element.getByRole('textbox'), value);
  await element.getByRole('button', { name: /^Choose a file/ }).click();
  await changes(page, () =>
    page
      .getByRole('dialog')
      .locator('.file', { has: page.getByText(value, { exact: true }) })
      .click(),
  );
}

async function set_facing(page, element, row, value) {
  const chooser = element.getByRole('combobox');
  if (!Array.isArray(value)) return changes(page, () => chooser.selectOption(value));
  await changes(page, () => chooser.selectOption('direction'));
  await set_vector(page, element, row, value);
}

async function set_lines(page, element, value) {
  const field = element.getByRole('textbox');
  await field.click();
  await page.keyboard.press('Control+a');
  await page.keyboard.insertText(Array.isArray(value) ? value.join('\n') : value);
  await changes(page, () => page.keyboard.press('Control+Enter'));
}

const set_text = (page, element, _row, value) => type_value(page, element.getByRole('textbox').first(), String(value));
const set_curve = (page, element, _row, value) => set_written(page, element, value);

const kHands = {
  number: set_number,
  integer: set_number,
  boolean: (page, element) => changes(page, () => element.getByRole('switch').click()),
  choice: (page, element, _row, value) => changes(page, () => element.getByRole('combobox').selectOption(value)),
  text: set_text,
  condition: set_text,
  formula: set_text,
  colour: (page, element, _row, value) => type_value(page, element.locator('.text-field'), value),
  file: set_file,
  lines: (page, element, _row, value) => set_lines(page, element, value),
  vector: set_vector,
  integers: set_vector,
  facing: set_facing,
  box: set_box,
  colours: set_colours,
  curve: set_curve,
  points: set_curve,
  positions: set_positions,
  selection: set_selection,
};

/// The kinds that hold rows themselves.
export const kNested = ['object', 'list', 'map'];
export const kKinds = [...Object.keys(kHands), ...kNested];

/// Opens the fold at a path.
export async function unfold(page, path) {
  const title = at_path(page, path).locator(':scope > .fold-head > .fold-title');
  if ((await title.getAttribute('aria-expanded')) === 'false') await title.click();
}

const below = (path, step) =>
  typeof step === 'number'
    ? `${path}[${step}]`
    : /^[A-Za-z_]\w*$/.test(step)
      ? path === ''
        ? step
        : `${path}.${step}`
      : `${path}["${step}"]`;

/// Returns the table of the element of a list.
export function table_of_element(tables, row, element) {
  return tables.tables[row.kinds ? row.kinds.tables[element[row.kinds.key]] : row.table];
}

/// Edits one document that is open in a page.
export class RowHand {
  kinds = new Set(); // that were set
  constructor(page, tables) {
    this.page = page;
    this.tables = tables;
  }

  /// Removes the row if possible, and sets it to this value by mouse and keyboard.
  async give_anew(path, row, value) {
    const element = at_path(this.page, path);
    if (!row.required) await changes(this.page, () => pick_own(this.page, element, 'Unset'));
    await this.give(path, row, value);
  }

  async give(path, row, value) {
    this.kinds.add(row.kind);
    if (row.kind === 'object') return this.give_members(path, this.tables.tables[row.table], value);
    if (row.kind === 'list') return this.give_elements(path, row, value);
    if (row.kind === 'map') return this.give_names(path, row, value);
    const said = await said_at(this.page, path);
    if (same(said, value)) return undefined;
    const element = at_path(this.page, path);
    // The menu gives the default value.
    if (same(row.default, value))
      return changes(this.page, () => pick_own(this.page, element, said === undefined ? 'Set' : 'Set to default'));
    return kHands[row.kind](this.page, element, row, value);
  }

  async give_members(path, table, value) {
    await unfold(this.page, path);
    // In the order of the table, because later rows may have an effect only beside earlier rows.
    for (const row of table.rows)
      if (value[row.name] !== undefined) await this.give(below(path, row.name), row, value[row.name]);
    // A new element has one row of each group that requires one row.
    const extra = Object.keys((await said_at(this.page, path)) ?? {}).filter((name) => !(name in value));
    for (const name of extra)
      await changes(this.page, () => pick_own(this.page, at_path(this.page, below(path, name)), 'Unset'));
  }

  async give_elements(path, row, elements) {
    await unfold(this.page, path);
    const adder = at_path(this.page, path).locator(':scope > .fold-body > .add-line').getByRole('button');
    for (const [index, element] of elements.entries()) {
      await changes(this.page, async () => {
        await adder.click();
        if (row.kinds) await this.page.getByRole('menuitem', { name: element[row.kinds.key], exact: true }).click();
      });
      await this.give_members(below(path, index), table_of_element(this.tables, row, element), element);
    }
  }

  async give_names(path, row, value) {
    await unfold(this.page, path);
    const line = at_path(this.page, path).locator(':scope > .fold-body > .add-line');
    for (const [name, element] of Object.entries(value)) {
      await line.getByRole('textbox').fill(name);
      await changes(this.page, () => line.getByRole('button').click());
      await this.give_members(below(path, name), this.tables.tables[row.table], element);
    }
  }
}

export { below };
