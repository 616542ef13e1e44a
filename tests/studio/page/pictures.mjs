// SPDX-License-Identifier: Apache-2.0
// Draws the pictures of the manual's chapter on the studio, as `./dev gallery studio` does: node
// tests/studio/page/pictures.mjs [FOLDER]
import { cp, mkdir, stat, writeFile } from 'node:fs/promises';
import path from 'node:path';
import process from 'node:process';
import { fileURLToPath } from 'node:url';

import { click_node, draw_link, open_board } from './board_hands.mjs';
import { choose, open_file, open_model, point_at, retype, row } from './hands.mjs';
import { kSource, open_page, start_browser, start_server, temporary_folder } from './support.mjs';

export const kMaxBytes = 250_000;
export const kFolder = path.join(kSource, 'docs/manual/studio');

/// The content of each picture, and the actions that lead to it: from the oak, which is open at first, or from a small
/// plant. `has_many` marks a picture of many small pictures, which look different on fewer pixels.
export const kPictures = [
  { name: 'oak', on_oak: true, theme: 'light', act: (page) => choose(page, 'tree') },
  {
    name: 'inspector',
    theme: 'dark',
    act: async (page) => {
      await open_model(page, 'sunflower');
      await choose(page, 'petiole');
    },
  },
  {
    name: 'curve',
    theme: 'light',
    act: async (page) => {
      await open_model(page, 'tulip');
      await choose(page, 'stem');
      await row(page, 'components.stem.taper').scrollIntoViewIfNeeded();
    },
  },
  {
    name: 'text',
    theme: 'light',
    act: async (page) => {
      await open_model(page, 'low-poly-oak');
      await page.keyboard.press('t');
      await retype(page, '"foliage*0.48', '"folaige*0.48');
      await page.locator('.fault-list button').first().click();
      await page.keyboard.press('f');
    },
  },
  {
    name: 'outline',
    theme: 'dark',
    act: async (page) => {
      await open_model(page, 'tulip');
      await choose(page, 'pistil');
      const silhouette = row(page, 'components.pistil.silhouette');
      await silhouette.hover();
      await silhouette.getByRole('button', { name: 'Enlarge silhouette' }).click();
      await page.locator('.drawer').waitFor();
      await page.keyboard.press('f');
    },
  },
  {
    name: 'grammar',
    theme: 'light',
    act: async (page) => {
      await open_model(page, 'low-poly-birch');
      await page.getByRole('button', { name: 'Grammar', exact: true }).click();
      await page.getByRole('button', { name: 'A step back' }).click();
      await page.waitForFunction(
        () =>
          window.studio.bench.derivation.state.get().step !== null &&
          !window.studio.bench.derivation.state.get().is_working,
      );
    },
  },
  {
    name: 'growth',
    theme: 'light',
    act: async (page) => {
      await open_model(page, 'slender');
      await page.keyboard.press('s');
      await page.waitForFunction(() => window.studio.bench.growth_look.state.get().steps !== null);
      await page.evaluate(() => window.studio.bench.growth_look.show_step(220));
      await page.waitForFunction(() => window.studio.growth.get().grown.step === 220);
      await page.getByRole('button', { name: 'Attraction points' }).click();
      await page.waitForFunction(() => window.studio.view.counts.overlays.points > 0);
    },
  },
  {
    name: 'strip',
    on_oak: true,
    theme: 'light',
    act: async (page) => {
      const handle = page.locator('.handle').first();
      await handle.hover();
      await handle.getByRole('button', { name: /^Plants over/ }).click();
      await page.waitForFunction(() => document.querySelectorAll('.strip img.still').length === 5, null, {
        timeout: 60_000,
      });
    },
  },
  {
    name: 'chance',
    on_oak: true,
    theme: 'dark',
    act: async (page) => {
      // Equal random numbers each time.
      await page.evaluate(() => {
        let state = 7;
        Math.random = () => {
          state = (state * 16807) % 2147483647;
          return state / 2147483647;
        };
      });
      await page.keyboard.press('n');
      await page.waitForFunction(() => document.querySelectorAll('.nine img.still').length === 9, null, {
        timeout: 60_000,
      });
    },
  },
  {
    name: 'time',
    theme: 'light',
    act: async (page) => {
      await open_file(page, 'primrose.json');
      await page.keyboard.press('k');
      const slider = page.getByRole('slider', { name: 'Time that is shown' });
      const box = await slider.boundingBox();
      await page.mouse.click(box.x + 0.7 * box.width, box.y + 8);
      await page.locator('[data-track="scape.length"] .lane-name').click();
      await page.locator('.track-editor').waitFor();
      await page.locator('.clock-block').first().waitFor({ state: 'attached' });
      await page.waitForTimeout(1000);
      await page.keyboard.press('f');
      await page.waitForFunction(() => !window.studio.growth.get().working, null, { timeout: 60_000 });
    },
  },
  {
    name: 'measures',
    on_oak: true,
    theme: 'dark',
    act: async (page) => {
      await page.getByRole('button', { name: 'Measures', exact: true }).click();
      await page.getByRole('combobox', { name: 'Handle over which is measured' }).selectOption('age');
      await page.getByRole('button', { name: 'Measure', exact: true }).click();
      await page.locator('.plot circle').nth(8).waitFor({ timeout: 120_000 });
      await page.waitForFunction(
        () => window.studio.bench.measures.state.get().told && !window.studio.bench.measures.state.get().is_working,
        null,
        { timeout: 60_000 },
      );
    },
  },
  {
    name: 'models',
    on_oak: true,
    has_many: true,
    theme: 'light',
    act: async (page) => {
      await page.keyboard.press('Control+m');
      await page.locator('.model img').first().waitFor();
      await page.waitForFunction(() =>
        [...document.querySelectorAll('.model img')].slice(0, 18).every((one) => one.complete),
      );
    },
  },
  {
    name: 'palette',
    has_many: true,
    theme: 'light',
    act: async (page) => {
      await page.getByRole('button', { name: 'New plant', exact: true }).click();
      await page.waitForFunction(() => window.studio.document.state.get().text.includes('"New plant"'));
      await open_board(page);
      await click_node(page, 'view');
      await page.keyboard.press('a');
      await page.waitForFunction(() =>
        [...document.querySelectorAll('.dialog .model img')]
          .slice(0, 18)
          .every((one) => one.complete && one.naturalWidth > 0),
      );
    },
  },
  {
    name: 'board-head',
    theme: 'light',
    act: async (page) => {
      await open_file(page, 'sunflower-head.json');
      await open_board(page);
      await click_node(page, 'disc');
    },
  },
  {
    name: 'board-refused',
    theme: 'dark',
    act: async (page) => {
      await open_file(page, 'sunflower-stem.json');
      await open_board(page);
      await draw_link(page, 'blade', 'stem');
    },
  },
  {
    name: 'board-sunflower',
    theme: 'light',
    act: async (page) => {
      await open_model(page, 'sunflower');
      await open_board(page);
      const box = await page.locator('.view canvas').boundingBox();
      await page.mouse.click(box.x + 0.43 * box.width, box.y + 0.56 * box.height);
      await page.locator('.instance').waitFor();
    },
  },
  {
    name: 'steer-house',
    theme: 'light',
    act: async (page) => {
      await open_file(page, 'yard.json');
      await choose(page, 'Scene');
      await page.locator('.view canvas').focus();
      for (let k = 0; k < 4; k += 1) await page.keyboard.press('-');
      await show_grips(page, 'obstacle 1, box');
    },
  },
  {
    name: 'steer-crown',
    theme: 'dark',
    act: async (page) => {
      await open_file(page, 'yard.json');
      await choose(page, 'tree');
      await page.locator('.view canvas').focus();
      await page.keyboard.press('1');
      await show_grips(page, 'crown, profile');
      await page.locator('[data-path="components.tree.crown"] > .fold-head > .fold-title').click();
      const profile = row(page, 'components.tree.crown.profile');
      await profile.hover();
      await profile.getByRole('button', { name: 'Enlarge profile' }).click();
      await page.locator('.drawer .curve-cloud').waitFor({ state: 'attached' });
      await page.keyboard.press('f');
    },
  },
  {
    name: 'steer-plan',
    theme: 'light',
    act: async (page) => {
      await open_model(page, 'pear-espalier');
      await choose(page, 'pear');
      await page.keyboard.press('o');
      await page.getByRole('button', { name: 'By year' }).click();
      await page.locator('.plan-entry').last().click();
      await page.waitForFunction(() => window.studio.bench.pruning.told.get()?.operations.places.length > 0);
    },
  },
  {
    name: 'steer-cut',
    theme: 'dark',
    act: async (page) => {
      await open_file(page, 'young-pear.json');
      await page.locator('.view canvas').focus();
      await page.keyboard.press('1');
      await page.evaluate(() => window.studio.view.drawn());
      const [x, y] = await page.evaluate(() => window.studio.view.eye.project([0, 0.5, 0.01]));
      const box = await page.locator('.view canvas').boundingBox();
      await page.mouse.click(box.x + x, box.y + y);
      await page.locator('.shoot-tool').waitFor();
    },
  },
  {
    name: 'steer-leaf',
    theme: 'light',
    act: async (page) => {
      await open_file(page, 'grass-measured.json');
      await choose(page, 'leaf');
      await page.getByRole('button', { name: 'Midrib and width…' }).click();
      await page.locator('.leaf-curves .curve-dots circle').first().waitFor();
      await page.keyboard.press('f');
    },
  },
  {
    name: 'steer-hedge',
    theme: 'dark',
    act: async (page) => {
      await open_model(page, 'box-hedge');
      await choose(
        page,
        await page.evaluate(
          () =>
            Object.entries(window.studio.document.state.get().tree.value.components).find(
              ([, one]) => one.type === 'organize',
            )[0],
        ),
      );
      await show_grips(page, /^operation 3, outside, box/);
    },
  },
];

/// Chooses a thing with grips in the list beside the view.
async function show_grips(page, label) {
  await page.locator('.gizmo-card').waitFor();
  const select = page.locator('.gizmo-card select');
  const names = await select.locator('option').allInnerTexts();
  const wanted = typeof label === 'string' ? label : names.filter((one) => label.test(one)).at(-1);
  await select.selectOption({ label: wanted });
  await page.locator('.gizmo-grip').first().waitFor();
}

/// The scene of the pictures about steering. It has plain numbers, so that everything has grips.
const kOwn = {
  yard: {
    meristem: 1,
    name: 'A tree beside a house',
    seed: 4,
    scene: {
      latitude: 51.5,
      sun: { day: 141, hour: 10 },
      obstacles: [
        {
          name: 'house',
          box: [
            [1.1, 0, -1.6],
            [3.4, 2.4, 1.2],
          ],
          colour: '#cfc4b2',
        },
      ],
    },
    components: {
      tree: {
        type: 'colonize',
        crown: {
          profile: [
            [0.2, 1],
            [1, 1.5],
            [1.25, 2.3],
            [0.8, 3.2],
            [0, 3.6],
          ],
        },
        points: 900,
        step: 0.06,
        influence: 0.8,
        kill: 0.16,
      },
      leaf: { type: 'leaf', length: 0.09, width: 0.05, rows: 2, colours: ['#3f6b26', '#5c8a35'] },
    },
    links: [{ from: 'tree', to: 'leaf', kind: 'branch', density: 30, divergence: 137.5, where: 'radius < 0.012' }],
  },
  'young-pear': {
    meristem: 1,
    name: 'A young pear',
    seed: 3,
    components: {
      pear: { type: 'organize', iterations: 11, resource: { alpha: 2.2 }, tip_radius: 0.006, colour: '#6b5b4a' },
    },
  },
};

/// Draws a picture in the best quality for its size, and returns its path.
async function draw(browser, address, out, { name, theme, act }, scale) {
  const context = await browser.newContext({
    viewport: { width: 1280, height: 760 },
    deviceScaleFactor: scale,
    colorScheme: theme,
  });
  const page = await open_page(context, address);
  await page.getByRole('button', { name: 'Start', exact: true }).click();
  await act(page);
  await point_at(page, page.locator('.status'), 0.5); // nothing is pointed at
  await page.waitForTimeout(1200);
  const file = path.join(out, `${name}.jpg`);
  for (let quality = 90; quality >= 50; quality -= 8) {
    await page.screenshot({ path: file, type: 'jpeg', quality, timeout: 120_000 });
    if ((await stat(file)).size < kMaxBytes) break;
  }
  await context.close();
  return file;
}

/// `scale` is the number of picture pixels per page pixel, along each side. It is 1 for pictures of many small
/// pictures.
export async function draw_all(browser, out, { scale = 1, tell = () => undefined } = {}) {
  const place = await temporary_folder();
  for (const [name, document] of Object.entries(kOwn))
    await writeFile(path.join(place.folder, `${name}.json`), JSON.stringify(document, null, 2));
  for (const file of ['grass-measured.json', 'grass-midribs.csv', 'grass-widths.csv'])
    await cp(path.join(kSource, 'docs/manual/figures', file), path.join(place.folder, file));
  for (const name of ['sunflower-head', 'sunflower-stem'])
    await cp(path.join(kSource, `docs/manual/figures/${name}.json`), path.join(place.folder, `${name}.json`));
  await cp(path.join(kSource, 'models/films/primrose.json'), path.join(place.folder, 'primrose.json'));
  const on_oak = await start_server(place.folder);
  const on_small = await start_server(place.folder, 'young-pear.json');
  await mkdir(out, { recursive: true });
  try {
    for (const picture of kPictures)
      tell(
        await draw(browser, (picture.on_oak ? on_oak : on_small).address, out, picture, picture.has_many ? 1 : scale),
      );
  } finally {
    await Promise.all([on_oak.stop(), on_small.stop()]);
    await place.remove();
  }
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const browser = await start_browser();
  await draw_all(browser, path.resolve(process.argv[2] ?? kFolder), { tell: (file) => console.log(file) }).finally(() =>
    browser.close(),
  );
}
