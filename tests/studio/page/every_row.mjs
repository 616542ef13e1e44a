// SPDX-License-Identifier: Apache-2.0
// Sets one row of each kind of each component type through the inspector's own fields, and asks `meristem check`.

const kCrown = { profile: [[0.1, 0.6], [0.7, 1.2], [0, 2]] };
/// What types need besides rows that can be made up.
const kNeeded = {
  colonize: { crown: kCrown, points: 50, step: 0.1, influence: 0.6, kill: 0.2 },
  cloud: { crown: kCrown },
  lsystem: { grammar: ['#axiom', '!(0.03) F(0.3)'] },
};

/// One component of each type with its required rows.
function document_of_all(tables) {
  const first = (row) => row.default ?? { number: row.usual?.[1] ?? 1, integer: Math.round(row.usual?.[1] ?? 1), text: 'x', choice: row.choices?.[0] }[row.kind];
  const components = {};
  for (const [type, facts] of Object.entries(tables.components)) {
    const made = { type };
    for (const row of tables.tables[facts.table].rows) if (row.required) made[row.name] = first(row);
    components[`the_${type}`] = { ...made, ...kNeeded[type] };
  }
  return components;
}

const kTyped = { number: (row) => String(nice(row)), integer: (row) => String(Math.round(nice(row))) };

/// A number within the usual range that is not the default.
function nice(row) {
  const [low, high] = row.usual ?? [0, 1];
  const value = Number((low + 0.6 * (high - low)).toPrecision(2));
  return value === row.default ? Number((low + 0.3 * (high - low)).toPrecision(2)) : value;
}

/// Acts on the editor of a row as a hand would; false where this kind is set elsewhere.
async function set_row(page, path, row) {
  const element = page.locator(`[data-path="${path}"]`);
  if (kTyped[row.kind]) {
    const field = element.locator('.number-field input').first();
    await field.fill(kTyped[row.kind](row));
    await field.press('Enter');
    return true;
  }
  if (row.kind === 'boolean') await element.getByRole('switch').click();
  else if (row.kind === 'choice') {
    const other = row.choices.find((one) => one !== row.default) ?? row.choices[0];
    await element.getByRole('combobox').selectOption(other);
  } else if (row.kind === 'colour') {
    const field = element.locator('.text-field').first();
    await field.fill('#a0b0c0');
    await field.press('Enter');
  } else if (row.kind === 'vector') {
    const field = element.locator('.number-field input').first();
    await field.fill('0.5');
    await field.press('Enter');
  } else if (['curve', 'points', 'positions', 'selection', 'colours', 'condition', 'formula', 'lines', 'box', 'integers'].includes(row.kind)) {
    await element.hover();
    await element.getByRole('button', { name: /^More for/ }).click();
    await page.getByRole('menuitem', { name: 'Set', exact: true }).click();
  } else return false;
  return true;
}

const errors = (page) =>
  page.evaluate(() => window.studio.document.state.get().faults.filter((one) => one.severity === 'error').map((one) => `${one.path}: ${one.message}`));

const step_count = (page) => page.evaluate(() => window.studio.document.state.get().undo.done.length);

/// Sets a row and says what became of it: "set", "refused" by a rule between rows, or what is wrong.
async function try_row(page, id, row) {
  const path = `components.${id}.${row.name}`;
  const before = await step_count(page);
  if (!(await set_row(page, path, row))) return 'elsewhere';
  const is_done = await page
    .waitForFunction((known) => window.studio.document.state.get().undo.done.length > known, before, { timeout: 30000 })
    .then(() => true, () => false);
  if (!is_done) return 'nothing was set';
  const value = await page.evaluate(([one, name]) => window.studio.document.state.get().tree.value.components[one][name], [id, row.name]);
  if (value === undefined) return 'not in the text';
  if ((await errors(page)).length === 0) return 'set';
  await page.evaluate(() => window.studio.undo());
  return 'refused';
}

export async function set_every_row(page, tables, folder, { save_and_check }) {
  const told = { rows: 0, kinds: new Set(), faults: [], faulty_bases: [] };
  const components = document_of_all(tables);
  const all = tables.tables[tables.all_components].rows;
  for (const [type, facts] of Object.entries(tables.components)) {
    const id = `the_${type}`;
    const document = { meristem: 1, components: { [id]: components[id] } };
    await page.evaluate((text) => window.studio.open({ text, path: null }), JSON.stringify(document, null, 2));
    await page.evaluate((path) => window.studio.choose(path), `components.${id}`);
    if ((await errors(page)).length > 0) {
      told.faulty_bases.push(`${type}: ${(await errors(page))[0]}`);
      continue;
    }
    const seen = new Set();
    for (const row of [...tables.tables[facts.table].rows, ...all]) {
      const path = `components.${id}.${row.name}`;
      if (seen.has(row.kind) || row.required || (await page.locator(`[data-path="${path}"]`).count()) === 0) continue;
      const outcome = await try_row(page, id, row);
      if (outcome === 'set') {
        seen.add(row.kind);
        told.kinds.add(row.kind);
        told.rows += 1;
      } else if (outcome !== 'elsewhere' && outcome !== 'refused') {
        told.faults.push(`${path}: ${outcome}`);
      }
    }
    const { check, text } = await save_and_check(page, folder, `${id}.json`);
    if (check.code !== 0) told.faults.push(`${type}: ${check.stderr}${check.stdout}\n${text}`);
  }
  return told;
}
