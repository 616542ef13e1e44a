// SPDX-License-Identifier: Apache-2.0
// A click in the view chooses in the outline, the inspector and the text, and the other way round.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';

import { choose, open_file, row, step, type_into } from './hands.mjs';
import { open_page, settled, start_browser, start_server, temporary_folder, write_document } from './support.mjs';

const kNames = [...'abcdefghijklmnopqrst'];
/// Twenty balls on a floor, each a component of its own: five from west to east, four from north to south. The table
/// links them.
const place_of = (k) => [2 * (k % 5), 2 * Math.floor(k / 5)];
const kBalls = {
  meristem: 1,
  name: 'Balls',
  components: {
    floor: { type: 'places', table: 'places.csv', choose: 'ball' },
    ...Object.fromEntries(kNames.map((name) => [`ball_${name}`, { type: 'simple', shape: 'sphere', size: [1, 1, 1] }])),
  },
};
const kTable = `x,z,ball\n${kNames.map((name, k) => `${place_of(k).join(',')},ball_${name}`).join('\n')}\n`;
/// Five balls of one component in a row.
const kRow = {
  meristem: 1,
  name: 'Row',
  components: {
    line: {
      type: 'places',
      line: {
        points: [
          [0, 0],
          [8, 0],
        ],
        spacing: 2,
      },
    },
    ball: { type: 'simple', shape: 'sphere', size: [1, 1, 1] },
  },
  links: [['line', 'ball']],
};

let place, server, browser, page;

before(async () => {
  place = await temporary_folder();
  await write_document(place.folder, 'places.csv', kTable);
  await write_document(place.folder, 'balls.json', JSON.stringify(kBalls, null, 2));
  await write_document(place.folder, 'row.json', JSON.stringify(kRow, null, 2));
  server = await start_server(place.folder, 'balls.json');
  browser = await start_browser();
  page = await open_page(await browser.newContext({ viewport: { width: 1280, height: 720 } }), server.address);
});

after(async () => {
  await browser?.close();
  await server?.stop();
  await place?.remove();
});

/// Returns the pixel of the page that shows a point of the world, by the camera's matrices.
async function seen_at([x, y, z]) {
  return page.evaluate(
    async (point) => {
      await window.studio.view.drawn(); // a panel may just have become wider
      const { camera } = window.studio.view.orbit;
      const times = (m, [a, b, c, d]) =>
        [0, 1, 2, 3].map((k) => m[k] * a + m[k + 4] * b + m[k + 8] * c + m[k + 12] * d);
      const [u, v, , w] = times(
        camera.projectionMatrix.elements,
        times(camera.matrixWorldInverse.elements, [...point, 1]),
      );
      const box = document.querySelector('.view canvas').getBoundingClientRect();
      return [box.left + ((u / w + 1) / 2) * box.width, box.top + ((1 - v / w) / 2) * box.height];
    },
    [x, y, z],
  );
}

const click_at = async (point) => page.mouse.click(...(await seen_at(point)));
const chosen = () => page.evaluate(() => window.studio.chosen.get());
const nobody = async () => {
  const { x, y, height } = await page.locator('.view canvas').boundingBox();
  await page.mouse.click(x + 150, y + height - 60);
};

test('twenty clicks choose the twenty balls that are there', async () => {
  for (const key of ['7', '1']) {
    await page.locator('.status').click({ position: { x: 300, y: 10 } });
    await page.keyboard.press(key);
    // From the front only the first row is certainly visible.
    const balls = key === '7' ? kNames : kNames.slice(15);
    for (const name of balls) {
      const [x, z] = place_of(kNames.indexOf(name));
      await click_at([x, 0.5, z]);
      assert.equal(await chosen(), `components.ball_${name}`);
    }
  }
});

test('outline, inspector and text follow a click, and an empty place lets go', async () => {
  await click_at([4, 0.5, 6]);
  assert.equal(
    await page
      .locator('.outline-choice[aria-current]')
      .innerText()
      .then((text) => text.split('\n')[0]),
    'ball_r',
  );
  assert.match(await page.locator('#inspector-title').innerText(), /^ball_r/);
  await page.keyboard.press('t');
  const line = page.locator('.cm-activeLine').first();
  await click_at([0, 0.5, 6]);
  await page.waitForFunction(() => /"ball_p"/.test(document.querySelector('.cm-activeLine')?.textContent ?? ''));
  assert.ok(await line.isVisible());
  await nobody();
  assert.equal(await chosen(), '');
  await page.keyboard.press('t');
});

test('a drag turns the view and chooses nothing', async () => {
  await choose(page, 'ball_a');
  const [x, y] = await seen_at([8, 0.5, 6]);
  const { azimuth } = await page.evaluate(() => window.studio.view.orbit.state);
  await page.mouse.move(x, y);
  await page.mouse.down();
  for (let k = 1; k <= 5; k += 1) await page.mouse.move(x + 10 * k, y);
  await page.mouse.up();
  assert.notEqual((await page.evaluate(() => window.studio.view.orbit.state)).azimuth, azimuth);
  assert.equal(await chosen(), 'components.ball_a');
});

test('what is not drawn is not clicked at', async () => {
  await page.locator('.view canvas').focus();
  await page.keyboard.press('1');
  // Seen along the row, one ball hides the others behind it.
  const point = [0, 0.5, 6];
  await click_at(point);
  assert.equal(await chosen(), 'components.ball_p');
  const item = page.locator('.outline-item', { hasText: 'ball_p' });
  await item.hover();
  await item.getByRole('button', { name: 'Draw ball_p' }).click();
  await click_at(point);
  assert.equal(await chosen(), 'components.ball_k');
  await item.hover();
  await item.getByRole('button', { name: 'Draw ball_p' }).click();
});

test('the pointer at rest is told what it points at', async () => {
  const [x, y] = await seen_at([4, 0.5, 6]);
  await page.mouse.move(x, y);
  await page.locator('.pointed-at').waitFor();
  assert.equal(await page.locator('.pointed-at').innerText(), 'ball_r');
  await page.mouse.move(x + 300, y - 200);
  await page.locator('.pointed-at').waitFor({ state: 'detached' });
});

test('one instance is marked, until it is another one or gone; nothing stays behind', async () => {
  await open_file(page, 'row.json');
  await page.keyboard.press('7');
  const counts = () =>
    page.evaluate(async () => {
      await window.studio.view.drawn();
      const { batches, instance_sets, geometries } = window.studio.view.counts;
      return { batches, instance_sets, geometries };
    });
  const before_it = await counts();
  for (let k = 0; k < 5; k += 1) {
    await click_at([2 * k, 0.5, 0]);
    const [x, y] = await seen_at([2 * k, 0.5, 0]);
    const box = await page.locator('.view canvas').boundingBox();
    assert.equal(await page.evaluate(([a, b]) => window.studio.view.pick(a, b).instance, [x - box.x, y - box.y]), k);
    assert.equal((await counts()).batches, before_it.batches + 1);
  }
  const size = row(page, 'components.ball.size');
  await step(page, () => type_into(page, size.getByRole('textbox').first(), '0.9'));
  await settled(page);
  assert.deepEqual(await counts(), before_it);
  await nobody();
  assert.deepEqual(await counts(), before_it);
});

test('nothing was complained about on the way', () => {
  assert.deepEqual(
    page.faults.filter((fault) => !/WebGL|GL Driver/i.test(fault)),
    [],
  );
});
