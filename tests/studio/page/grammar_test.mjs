// SPDX-License-Identifier: Apache-2.0
// Grammars in the studio: no lost keys, faults at their lines, derivation step by step beside the plant.
import assert from 'node:assert/strict';
import { writeFile } from 'node:fs/promises';
import path from 'node:path';
import { after, before, test } from 'node:test';

import { serious_faults } from './boxes.mjs';
import { leave_fields, open_file, step, undo_all } from './hands.mjs';
import {
  open_page,
  set_theme,
  settled,
  start_browser,
  start_server,
  temporary_folder,
  text_of,
  undo_count,
  write_document,
} from './support.mjs';

const document_of = (grammar, more = '') => `{
  "meristem": 1,
  "components": {
    "weed": {"type": "lsystem", "steps": 3, "length": 0.2, "angle": 30, ${more}
      "grammar": [
${grammar.map((line) => `        ${JSON.stringify(line)}`).join(',\n')}
      ]}
  }
}
`;
const kWeed = ['// A weed.', '#axiom', 'A', '#rules', 'A -> F[+A][-A]FA', 'F -> FF'];

let place, server, browser, page;

before(async () => {
  place = await temporary_folder();
  await write_document(place.folder, 'weed.json', document_of(kWeed));
  server = await start_server(place.folder, path.join(place.folder, 'weed.json'));
  browser = await start_browser();
  page = await open_page(await browser.newContext({ viewport: { width: 1280, height: 800 } }), server.address);
  await page.getByRole('button', { name: 'Grammar', exact: true }).click();
});

after(async () => {
  await browser?.close();
  await server?.stop();
  await place?.remove();
});

const editor = () => page.getByRole('textbox', { name: 'Grammar of weed' });
const grammar = () => page.evaluate(() => window.studio.document.state.get().tree.value.components.weed.grammar);
const told = () => page.evaluate(() => window.studio.bench.derivation.state.get().told);
const word = async () => (await told()).modules.join('');

/// Waits for the derivation of a step.
async function derived(count) {
  await page.waitForFunction(
    (wanted) => {
      const { told: now, is_working } = window.studio.bench.derivation.state.get();
      return !is_working && now?.step === wanted;
    },
    count,
    { timeout: 20000 },
  );
}

test('the word of the document is told, with its counts', async () => {
  await derived(3);
  const { count, counts } = await told();
  assert.ok(count > 50);
  // Each of the three steps doubles F, and each A makes two, and three A.
  assert.equal(counts.find(([symbol]) => symbol === 'A')[1], 27);
  assert.match(await page.locator('.derivation-counts').innerText(), /A 27/);
});

test('a derivation goes step by step, and the plant with it; the document stays', async () => {
  const text = await text_of(page);
  const shown = () => page.evaluate(() => window.studio.growth.get().shown.triangles);
  const whole = await shown();
  await page.getByRole('button', { name: 'Axiom' }).click();
  await derived(0);
  assert.equal(await word(), 'A');
  await page.getByRole('button', { name: 'A step on' }).click();
  await derived(1);
  assert.equal(await word(), 'F[+A][-A]FA');
  await page.waitForFunction(
    (all) => window.studio.growth.get().shown.triangles < all && !window.studio.growth.get().working,
    whole,
  );
  await page.keyboard.press('PageUp');
  await derived(2);
  assert.equal(await word(), 'FF[+F[+A][-A]FA][-F[+A][-A]FA]FFF[+A][-A]FA');
  assert.equal(await text_of(page), text);
  // After *Keep*, the document has the step, as one step of the undo list.
  await step(page, () => page.getByRole('button', { name: 'Keep' }).click());
  assert.match(await text_of(page), /"steps": 2/);
  assert.equal(await undo_count(page), 1);
  await leave_fields(page);
  await undo_all(page);
  await settled(page);
  await derived(3);
});

test('a step too many says which limit, and nothing hangs', async () => {
  const field = page.getByRole('textbox', { name: 'Shown step' });
  await field.click();
  await page.keyboard.press('Control+a');
  await page.keyboard.type('200');
  await page.keyboard.press('Enter');
  await page.locator('.derivation .fault-line').waitFor();
  assert.match(await page.locator('.derivation .fault-line').innerText(), /modules/);
  await page.getByRole('button', { name: 'All steps of the document' }).click();
  await derived(3);
  await settled(page);
});

test('faults stand at their line and column, with what was nearest, while the plant stays', async () => {
  const before_it = await page.evaluate(() => window.studio.view.counts.batches);
  await editor().click();
  await page.keyboard.press('Control+Home');
  for (let k = 0; k < 3; k += 1) await page.keyboard.press('ArrowDown');
  await page.keyboard.press('End');
  await page.keyboard.press('Backspace');
  await page.keyboard.type('z');
  const list = page.getByRole('list', { name: 'Faults of the grammar' });
  await list.getByRole('button').first().waitFor();
  assert.match(await list.innerText(), /Line 4, column \d+: .*#rules/);
  await page.locator('.grammar-panel .cm-lintRange-error').first().waitFor();
  assert.equal(await page.evaluate(() => window.studio.view.counts.batches), before_it);
  await list.getByRole('button').first().click();
  assert.equal(await page.locator('.grammar-panel .cm-activeLine').first().innerText(), '#rulez');
  await leave_fields(page);
  await undo_all(page);
  await list.waitFor({ state: 'detached' });
  assert.equal(await text_of(page), document_of(kWeed));
});

test('the module under the pointer is marked in word and picture', async () => {
  await page.keyboard.press('f');
  await settled(page);
  await derived(3);
  // In the word: the first F.
  await page.locator('.editor.word .cm-content').hover({ position: { x: 16, y: 12 } });
  await page.waitForFunction(() => window.studio.bench.derivation.pointed.get()?.module === 0);
  await page.locator('.module-overlay line').first().waitFor({ state: 'attached' });
  assert.equal(await page.locator('.marked-module').innerText(), 'F');
  // In the picture: where a module in the middle was drawn.
  const [module, x, y] = await page.evaluate(() => {
    const { places } = window.studio.bench.derivation.state.get().told;
    const at = 7 * Math.floor(places.length / 14);
    const middle = [1, 2, 3].map((k) => (places[at + k] + places[at + k + 3]) / 2);
    const [left, top] = window.studio.view.eye.project(middle);
    const box = document.querySelector('.centre .view canvas').getBoundingClientRect();
    return [places[at], box.left + left, box.top + top];
  });
  await page.mouse.move(x + 3, y + 3);
  await page.mouse.move(x, y);
  await page.waitForFunction(() => window.studio.bench.derivation.pointed.get()?.by === 'view');
  const pointed = await page.evaluate(() => window.studio.bench.derivation.pointed.get().module);
  const modules = (await told()).modules;
  assert.equal(modules[pointed], 'F');
  assert.ok(Math.abs(pointed - module) < 60, `${pointed} for ${module}`);
  assert.equal(await page.locator('.marked-module').innerText(), 'F');
  await page.mouse.move(640, 790);
  await page.waitForFunction(() => window.studio.bench.derivation.pointed.get() === null);
});

test('a click in the view chooses the instance whose word is told', async () => {
  const three = JSON.stringify({
    meristem: 1,
    components: {
      ring: { type: 'hydra', number: 3, radius: 1 },
      weed: {
        type: 'lsystem',
        steps: 4,
        length: 0.2,
        angle: 30,
        width: 0.05,
        grammar: ['F', '#rules', 'F : 1 -> F[+F]F', 'F : 1 -> F[-F]FF'],
      },
    },
    links: [['ring', 'weed']],
  });
  await write_document(place.folder, 'three.json', three);
  await open_file(page, 'three.json');
  await derived(4);
  const instance = async () => (await told()).instance;
  assert.deepEqual([(await instance()).number, (await instance()).of], [0, 3]);
  const words = new Set([(await told()).modules.join('')]);
  // From above, the three are separate; a click at a segment of each chooses it.
  await page.getByRole('button', { name: 'Instance behind' }).click();
  await page.waitForFunction(() => window.studio.bench.derivation.state.get().told?.instance?.number === 1);
  words.add((await told()).modules.join(''));
  await page.getByRole('button', { name: 'Instance behind' }).click();
  await page.waitForFunction(() => window.studio.bench.derivation.state.get().told?.instance?.number === 2);
  words.add((await told()).modules.join(''));
  assert.equal(words.size, 3);
  const [x, y] = await page.evaluate(() => {
    const { places } = window.studio.bench.derivation.state.get().told;
    const [left, top] = window.studio.view.eye.project(
      [1, 2, 3].map((k) => places[k] + 0.3 * (places[k + 3] - places[k])),
    );
    const box = document.querySelector('.centre .view canvas').getBoundingClientRect();
    return [box.left + left, box.top + top];
  });
  const { key } = await instance();
  await page.getByRole('button', { name: 'Instance before' }).click();
  await page.waitForFunction(() => window.studio.bench.derivation.state.get().told?.instance?.number === 1);
  await page.mouse.click(x, y);
  await page.waitForFunction(
    (wanted) => window.studio.bench.derivation.state.get().told?.instance?.key === wanted,
    key,
  );
  assert.match(await page.locator('.derivation-instance').innerText(), /Instance 3 of 3/);
  await open_file(page, 'weed.json');
  await derived(3);
});

test('typing in a grammar of 20 kB loses no key', async () => {
  const rules = Array.from({ length: 900 }, (_, k) => `B(x) : x == ${k} -> F(${(k % 7) + 1})B(x+1)`);
  const long = [...kWeed, ...rules];
  assert.ok(long.join('\n').length > 20_000);
  await write_document(place.folder, 'long.json', document_of(long));
  await open_file(page, 'long.json');
  await editor().click();
  await page.keyboard.press('Control+End');
  await page.keyboard.press('Enter');
  const typed = 'C(x) : x > 3 -> F[+C(x-1)]F[-C(x-2)] // typed without a pause, key by key';
  const characters = typed.repeat(3);
  for (const key of characters) await page.keyboard.press(key === ' ' ? 'Space' : key, { delay: 0 });
  await page.waitForFunction(() => !window.studio.document.awaits_typed);
  const wanted = [...long];
  const line = (await grammar()).at(-1);
  // Brackets close automatically and are typed over, so the text is the typed text.
  assert.equal(line, characters);
  assert.deepEqual((await grammar()).slice(0, -1), wanted);
  await settled(page);
  assert.equal(
    await page.evaluate(() => window.studio.document.state.get().hash),
    await page.evaluate(
      async () =>
        (await window.studio.connection.request('splice', { base: window.studio.document.state.get().hash, patch: [] }))
          .hash,
    ),
  );
  await leave_fields(page);
  await undo_all(page);
  assert.equal(await text_of(page), document_of(long));
  await open_file(page, 'weed.json');
});

test('keys typed while an edit is on its way come after it', async () => {
  await editor().click();
  await page.keyboard.press('Control+End');
  // The inspector's edit and the keys happen at the same time.
  await page.evaluate(() => void window.studio.edit([{ set: 'components.weed.angle', value: 41 }], 'Set angle'));
  await page.keyboard.type('G+G-G');
  await page.waitForFunction(
    () => !window.studio.document.awaits_typed && Object.keys(window.studio.dragged.get()).length === 0,
  );
  assert.equal((await grammar()).at(-1), 'F -> FFG+G-G');
  assert.match(await text_of(page), /"angle": 41/);
  await leave_fields(page);
  await undo_all(page);
  await settled(page);
});

test('a grammar in a file is read, and taken into the document', async () => {
  await writeFile(path.join(place.folder, 'weed.l'), `${kWeed.join('\n')}\n`);
  const text = '{"meristem": 1, "components": {"weed": {"type": "lsystem", "steps": 2, "file": "weed.l"}}}';
  await write_document(place.folder, 'filed.json', text);
  await open_file(page, 'filed.json');
  await page.locator('.grammar-text', { hasText: 'A -> F[+A][-A]FA' }).waitFor();
  await derived(2);
  await step(page, () => page.getByRole('button', { name: 'Take it into the document' }).click());
  assert.deepEqual(await grammar(), kWeed);
  await editor().waitFor();
  await leave_fields(page);
  await undo_all(page);
  assert.equal(await text_of(page), text);
  await open_file(page, 'weed.json');
});

test('axe finds nothing serious in the grammar, light and dark', async () => {
  for (const theme of ['light', 'dark']) {
    await set_theme(page, theme);
    assert.deepEqual(await serious_faults(page, { colours_only: theme === 'dark' }), [], theme);
  }
  await page.emulateMedia({ colorScheme: null });
});

test('nothing was complained about on the way', () => {
  assert.deepEqual(
    page.faults.filter((fault) => !/WebGL|GL Driver/i.test(fault)),
    [],
  );
});
