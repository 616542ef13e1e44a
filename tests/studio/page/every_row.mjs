// SPDX-License-Identifier: Apache-2.0
// Gives each kind of row of each component type, of links, scene, output and limits a value by hand. The documents of
// tests/rows say which: between them they give every row that there is. What is set is taken away first, so that in the
// end each document must say again what it said.
import { cp, readdir, readFile } from 'node:fs/promises';
import path from 'node:path';

import { choose } from './hands.mjs';
import { at_path, below, kNested, RowHand, table_of_element, unfold } from './row_hands.mjs';
import { kSource, meristem } from './support.mjs';

const kFolder = path.join(kSource, 'tests/rows');

/// The documents, by name, with the files that they read beside them.
export async function put_documents(folder) {
  await cp(kFolder, path.join(folder, 'rows'), { recursive: true });
  await cp(path.join(kSource, 'tests/fuzz/corpus/image/rgba.png'), path.join(folder, 'fuzz/corpus/image/rgba.png'));
  const names = (await readdir(kFolder)).filter((one) => one.endsWith('.json')).sort();
  return Promise.all(names.map(async (name) => ({ name: `rows/${name}`, said: JSON.parse(await readFile(path.join(kFolder, name), 'utf8')) })));
}

/// What of a document its rows are of: the title in the outline, the path, whose rows they are, and their tables.
function subjects_of(document, tables) {
  const { components = {}, links = [] } = document.said;
  const found = [];
  const all = tables.tables[tables.all_components];
  for (const [id, said] of Object.entries(components)) found.push({ title: id, at: `components.${id}`, owner: said.type, said, tables: [tables.tables[tables.components[said.type].table], all] });
  for (const [k, said] of links.entries()) {
    if (Array.isArray(said)) continue;
    const kind = said.kind ?? '';
    found.push({ title: `${said.from} → ${said.to}`, at: `links[${k}]`, owner: `link ${kind}`, said, tables: [tables.tables[tables.link], tables.tables[tables.links[kind]]] });
  }
  const head = tables.tables[tables.document];
  for (const [part, title] of [['scene', 'Scene'], ['output', 'Output'], ['limits', 'Limits']]) {
    const table = part === 'limits' ? tables.limits : head.rows.find((one) => one.name === part).table;
    if (document.said[part]) found.push({ title, at: part, owner: part, said: document.said[part], tables: [tables.tables[table]] });
  }
  const plain = { rows: head.rows.filter((one) => one.table === undefined && !one.kinds && one.name !== 'meristem') };
  found.push({ title: 'Document', at: '', owner: 'document', said: document.said, tables: [plain] });
  // Of several links of the same name the outline's first is meant.
  return found.filter((one, k) => found.findIndex((other) => other.title === one.title) === k);
}

const is_object = (value) => typeof value === 'object' && value !== null && !Array.isArray(value);

/// All rows that are given below a value, with the folds that are opened on the way to them.
function* given_rows(tables, rows, said, at, folds) {
  for (const row of rows) {
    const value = said[row.name];
    if (value === undefined || row.name === 'type') continue;
    const here = below(at, row.name);
    const is_written_out = !kNested.includes(row.kind) || (row.kind === 'list' ? Array.isArray(value) : is_object(value));
    if (!is_written_out) continue; // in short, as a number in place of an object
    yield { row, value, at: here, folds };
    const inside = [...folds, here];
    if (row.kind === 'object') yield* given_rows(tables, tables.tables[row.table].rows, value, here, inside);
    if (row.kind === 'map') for (const [name, one] of Object.entries(value)) if (is_object(one)) yield* given_rows(tables, tables.tables[row.table].rows, one, below(here, name), [...inside, below(here, name)]);
    if (row.kind === 'list') for (const [k, one] of value.entries()) yield* given_rows(tables, table_of_element(tables, row, one).rows, one, below(here, k), [...inside, below(here, k)]);
  }
}

/// For each owner and kind one row: the one with least to type.
export function chosen_rows(documents, tables) {
  const best = new Map();
  for (const document of documents) {
    for (const subject of subjects_of(document, tables)) {
      const rows = subject.tables.filter(Boolean).flatMap((one) => one.rows);
      for (const found of given_rows(tables, rows, subject.said, subject.at, [])) {
        if (['from', 'to'].includes(found.row.name)) continue;
        const key = `${subject.owner}: ${found.row.kind}`;
        const cost = JSON.stringify(found.value).length + 20 * found.folds.length + (found.row.required ? 200 : 0) + (found.row.kind === 'lines' && !Array.isArray(found.value) ? 1000 : 0);
        if (cost < (best.get(key)?.cost ?? Infinity)) best.set(key, { key, cost, document, subject, ...found });
      }
    }
  }
  return [...best.values()];
}

/// Gives all chosen rows of one document anew, and says what is wrong with it then.
export async function set_rows(page, rows, tables) {
  const hand = new RowHand(page, tables);
  const faults = [];
  for (const { key, subject, row, value, at, folds } of rows) {
    await choose(page, subject.title);
    try {
      for (const fold of folds) await unfold(page, fold);
      await at_path(page, at).waitFor({ timeout: 5000 });
      await hand.give_anew(at, row, value);
    } catch (fault) {
      faults.push(`${key} at ${at}: ${String(fault).slice(0, 400)}`);
    }
  }
  return { kinds: hand.kinds, faults };
}

/// Saves the open document and has the program check it.
export async function check_saved(page, folder, name) {
  await page.keyboard.press('Control+s');
  await page.waitForFunction(() => !window.studio.document.is_changed);
  return meristem('check', path.join(folder, name));
}
