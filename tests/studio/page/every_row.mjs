// SPDX-License-Identifier: Apache-2.0
// Gives each kind of row of each component type, of links, scene, output and limits a value by hand. The documents of
// tests/rows together contain every row. Each value is removed before it is set, so that each document must have its
// first content in the end.
import { cp, readdir, readFile } from 'node:fs/promises';
import path from 'node:path';

import { at_path, below, kNested, RowHand, table_of_element, unfold } from './row_hands.mjs';
import { kSource, meristem } from './support.mjs';

const kFolder = path.join(kSource, 'tests/rows');
/// Further documents for rows that are missing in tests/rows.
const kMore = path.join(kSource, 'tests/studio/page/documents');

/// The documents by name, beside the files that they read.
export async function put_documents(folder) {
  await cp(kFolder, path.join(folder, 'rows'), { recursive: true });
  await cp(path.join(kSource, 'tests/fuzz/corpus/image/rgba.png'), path.join(folder, 'fuzz/corpus/image/rgba.png'));
  await cp(kMore, path.join(folder, 'rows'), { recursive: true });
  const names = (await readdir(path.join(folder, 'rows'))).filter((one) => one.endsWith('.json')).sort();
  return Promise.all(
    names.map(async (name) => ({
      name: `rows/${name}`,
      said: JSON.parse((await readFile(path.join(folder, 'rows', name), 'utf8')).replace(/(^|\s)\/\/.*$/gm, '')),
    })),
  );
}

/// The owners of rows with their tables: component types, the rows of all components, links, parts of the document.
export function owners_of(tables) {
  const head = tables.tables[tables.document];
  const part = (name) => tables.tables[head.rows.find((one) => one.name === name).table];
  return {
    ...Object.fromEntries(Object.entries(tables.components).map(([type, { table }]) => [type, tables.tables[table]])),
    'every component': tables.tables[tables.all_components],
    ...Object.fromEntries(Object.entries(tables.links).map(([kind, table]) => [`link ${kind}`, tables.tables[table]])),
    link: tables.tables[tables.link],
    scene: part('scene'),
    output: part('output'),
    limits: tables.tables[tables.limits],
    document: { rows: head.rows.filter((one) => one.table === undefined && !one.kinds && one.name !== 'meristem') },
  };
}

/// The subjects of a document's rows: the title in the outline, the path, and the tables with their owners.
function subjects_of(document, tables) {
  const owners = owners_of(tables);
  const { components = {}, links = [] } = document.said;
  const found = [];
  const add = (title, at, said, ...names) =>
    found.push({ title, at, said, tables: names.map((owner) => ({ owner, rows: owners[owner]?.rows ?? [] })) });
  for (const [id, said] of Object.entries(components)) add(id, `components.${id}`, said, said.type, 'every component');
  for (const [k, said] of links.entries())
    if (!Array.isArray(said)) add(`${said.from} → ${said.to}`, `links[${k}]`, said, 'link', `link ${said.kind ?? ''}`);
  for (const part of ['scene', 'output', 'limits'])
    if (document.said[part]) add(part[0].toUpperCase() + part.slice(1), part, document.said[part], part);
  add('Document', '', document.said, 'document');
  // Links may have equal names; then the first in the outline is taken.
  return found.filter((one, k) => found.findIndex((other) => other.title === one.title) === k);
}

const is_object = (value) => typeof value === 'object' && value !== null && !Array.isArray(value);

/// Returns all rows that are given below a value, with the folds that must be opened for them.
function* given_rows(tables, rows, said, at, folds) {
  for (const row of rows) {
    const value = said[row.name];
    if (value === undefined || row.name === 'type') continue;
    const here = below(at, row.name);
    const is_written_out =
      !kNested.includes(row.kind) || (row.kind === 'list' ? Array.isArray(value) : is_object(value));
    if (!is_written_out) continue; // in short form, as a number instead of an object
    yield { row, value, at: here, folds };
    const inside = [...folds, here];
    if (row.kind === 'object') yield* given_rows(tables, tables.tables[row.table].rows, value, here, inside);
    if (row.kind === 'map')
      for (const [name, one] of Object.entries(value))
        if (is_object(one))
          yield* given_rows(tables, tables.tables[row.table].rows, one, below(here, name), [
            ...inside,
            below(here, name),
          ]);
    if (row.kind === 'list')
      for (const [k, one] of value.entries())
        yield* given_rows(tables, table_of_element(tables, row, one).rows, one, below(here, k), [
          ...inside,
          below(here, k),
        ]);
  }
}

/// Returns all rows of a document, cheapest first for each owner and kind.
function rows_of(document, tables) {
  const best = new Map();
  for (const subject of subjects_of(document, tables)) {
    for (const { owner, rows } of subject.tables) {
      for (const found of given_rows(tables, rows, subject.said, subject.at, [])) {
        if (['from', 'to'].includes(found.row.name)) continue;
        const key = `${owner}: ${found.row.kind}`;
        // Lines that are written as one text are read back as lines.
        const is_odd = found.row.kind === 'lines' && !Array.isArray(found.value);
        const cost =
          JSON.stringify(found.value).length +
          20 * found.folds.length +
          (found.row.required ? 200 : 0) +
          (is_odd ? 1000 : 0);
        if (cost < (best.get(key)?.cost ?? Infinity)) best.set(key, { key, cost, document, subject, ...found });
      }
    }
  }
  return best;
}

/// Chooses one row for each wanted owner and kind, and for each other kind, from few documents. Takes the document with
/// the most missing rows next.
export function chosen_rows(documents, tables, wanted) {
  const given = documents.map((document) => [...rows_of(document, tables).values()]);
  const chosen = new Map();
  const kinds = new Set();
  const take = (is_new) => {
    for (;;) {
      const new_rows = given.map((rows) => rows.filter(is_new));
      const longest = new_rows.reduce((a, b) => (b.length > a.length ? b : a));
      if (longest.length === 0) return;
      for (const one of longest) {
        chosen.set(one.key, one);
        kinds.add(one.row.kind);
      }
    }
  };
  take((one) => wanted.includes(one.key) && !chosen.has(one.key));
  take((one) => !kinds.has(one.row.kind));
  return [...chosen.values()];
}

/// Sets all chosen rows of one document anew, and returns the faults.
export async function set_rows(page, rows, tables) {
  const hand = new RowHand(page, tables);
  const faults = [];
  for (const { key, subject, row, value, at, folds } of rows) {
    try {
      await page
        .locator('.outline-choice', { has: page.getByText(subject.title, { exact: true }) })
        .first()
        .click();
      for (const fold of folds) await unfold(page, fold);
      await at_path(page, at).waitFor({ timeout: 5000 });
      await hand.give_anew(at, row, value);
    } catch (fault) {
      faults.push(`${key} at ${at}: ${String(fault).slice(0, 400)}`);
    }
  }
  return { kinds: hand.kinds, faults };
}

/// Opens a document of the list. Its plant need not grow.
export async function open_document(page, name) {
  await page.keyboard.press('Control+o');
  for (const one of name.split('/'))
    await page
      .getByRole('dialog')
      .locator('.file', { has: page.getByText(one, { exact: true }) })
      .click();
  await page.waitForFunction(
    (path) => window.studio.document.state.get().path === path && document.querySelector('dialog') === null,
    name,
  );
}

/// Saves the open document and checks it by the program.
export async function check_saved(page, folder, name) {
  await page.keyboard.press('Control+s');
  await page.waitForFunction(() => !window.studio.document.is_changed);
  return meristem('check', path.join(folder, name));
}
