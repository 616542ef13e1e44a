// SPDX-License-Identifier: Apache-2.0
// Measures how fast the studio follows inputs, in a headless browser with the real server: node bench/studio.mjs
//
// The response time begins with the browser's time stamp of an input. It ends with the first frame that shows the plant
// with the new value, minus the time of drawing this frame once more. Each response time is measured 100 times while
// the mouse holds a slider and waits for each picture before the next move. During a slow picture, the server may
// therefore begin the detail of rest. The reference is a sapling of a few triangles in the same run: the smallest
// possible cost from input to picture. The lines of the table are written to the file named by MERISTEM_BENCH_TABLE.
// MERISTEM_BENCH=small runs everything a few times. MERISTEM, MERISTEM_CHROMIUM: as for the page's tests.
import { appendFile, readFile } from 'node:fs/promises';
import os from 'node:os';
import path from 'node:path';
import process from 'node:process';
import { choose, open_file, point_at, row, slider } from '../tests/studio/page/hands.mjs';
import {
  kSource,
  meristem,
  open_page,
  settled,
  start_browser,
  start_server,
  temporary_folder,
  write_document,
} from '../tests/studio/page/support.mjs';
import { buffers_of, heap_of, memory_of } from './studio_measure.mjs';

const is_small = process.env.MERISTEM_BENCH === 'small';
const kMoves = is_small ? 2 : 100;
const kGardens = is_small ? ['bonsai'] : ['balcony', 'garden']; // shipped plants that are opened
const kEdits = is_small ? 10 : 500;
const kSapling = {
  meristem: 1,
  variables: { size: { value: 0.1, min: 0.05, max: 0.25 } },
  components: { tree: { type: 'tree', length: 1, radius: 0.02 }, leaf: { type: 'leaf', length: 'size', width: 0.05 } },
  links: [{ from: 'tree', to: 'leaf', kind: 'branch', count: 8 }],
};

const kPoints = {
  meristem: 1,
  components: {
    tree: {
      type: 'colonize',
      crown: { ellipsoid: { centre: [0, 3, 0], radii: [2, 2, 2] } },
      points: 10000,
      step: 0.08,
      influence: 1,
      kill: 0.2,
    },
  },
};

const figures = [];
const digits = (value) => String(Number(value.toPrecision(4)));

/// A line of the table; `max` is its upper bound.
function tell(name, value, unit, max, reference) {
  const held = max === undefined ? '' : value <= max ? 'held' : 'NOT HELD';
  const ratio = reference ? digits(value / reference.value) : '';
  figures.push([
    `studio ${name}`,
    `${digits(value)} ${unit}`,
    reference?.name ?? '',
    ratio,
    max === undefined ? '' : `<= ${digits(max)}`,
    held,
  ]);
  console.log(
    `${name.padEnd(40)} ${digits(value).padStart(10)} ${unit.padEnd(8)} ${max === undefined ? '' : `<= ${max}`.padEnd(12)} ${held}`,
  );
}

const quantile = (values, share) =>
  [...values].sort((a, b) => a - b)[Math.min(values.length - 1, Math.floor(share * values.length))];

/// Watches inputs and frames from inside the page.
function watch() {
  const canvas = document.querySelector('.view canvas');
  const gl = canvas.getContext('webgl2');
  // Reading a pixel waits until the card has drawn everything.
  const finish = () => gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
  const { studio } = window;
  const found = { input: 0, shown: false, frames: [] };
  window.bench = found;
  document.addEventListener(
    'input',
    (event) => {
      found.input = event.timeStamp;
      found.shown = false;
    },
    true,
  );
  studio.growth.subscribe(() => {
    const { shown } = studio.growth.get();
    if (shown !== found.last && found.input > 0) found.shown = true;
    found.last = shown;
  });
  studio.view_facts.subscribe(() => {
    if (!found.shown || found.input === 0) return;
    finish();
    const end = performance.now();
    const { draft, triangles } = studio.growth.get().shown;
    const frame = { lag: end - found.input, draft, triangles };
    [found.shown, found.input] = [false, 0];
    if (found.draws_again) {
      found.draws_again = false;
      studio.view.draw();
      finish();
      frame.own = performance.now() - end;
    }
    found.frames.push(frame);
  });
}

/// Returns the milliseconds from moves of a slider to their pictures, without the drawing itself.
async function follow(page, target) {
  const { x, y, box } = await point_at(page, target, 0.3);
  await page.mouse.down();
  // Every tenth frame is drawn twice to measure drawing. The next move meets a late server, so neither counts.
  for (let k = 0; k < kMoves * 1.25 + 2; k += 1) {
    const count = await page.evaluate(
      (again) => {
        window.bench.draws_again = again;
        return window.bench.frames.length;
      },
      k % 10 === 0,
    );
    await page.mouse.move(x + (0.3 * box.width * (1 + (k % 40))) / 40, y);
    await page.waitForFunction((known) => window.bench.frames.length > known, count, { timeout: 30000, polling: 4 });
  }
  const frames = await page.evaluate(() => window.bench.frames.splice(0));
  await page.keyboard.press('Escape');
  await page.mouse.up();
  await settled(page);
  const drawing = quantile(
    frames.filter((one) => one.own !== undefined).map((one) => one.own),
    0.5,
  );
  const lags = frames
    .filter((_, k) => k % 10 > 1)
    .slice(0, kMoves)
    .map((one) => Math.max(0, one.lag - drawing));
  const drafts = frames.filter((one) => one.draft).length;
  console.log(
    `  ${frames.length} frames, ${drafts} drafts, ${quantile(
      frames.map((one) => one.triangles),
      0.5,
    )} triangles; drawing one takes ${digits(drawing)} ms`,
  );
  return { median: quantile(lags, 0.5), late: quantile(lags, 0.95) };
}

const counts = (page) => page.evaluate(() => ({ ...window.studio.connection.counts }));

/// Returns the bytes of all packets that `act` causes.
async function bytes_of(page, act) {
  const before = (await counts(page)).packet_bytes;
  await act();
  await settled(page);
  await page.waitForTimeout(400);
  await settled(page);
  return (await counts(page)).packet_bytes - before;
}

const set = (page, path, value) =>
  page.evaluate(([one, given]) => window.studio.edit([{ set: one, value: given }], 'Set'), [path, value]);

/// Loads the page from nothing: its size, and the time of its first picture.
async function open_first(browser, address) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 720 } });
  const page = await context.newPage();
  const session = await context.newCDPSession(page);
  await session.send('Network.enable');
  const names = new Map();
  const weights = new Map();
  session.on('Network.responseReceived', ({ requestId, response }) =>
    names.set(requestId, path.basename(new URL(response.url).pathname)),
  );
  session.on('Network.loadingFinished', ({ requestId, encodedDataLength }) =>
    weights.set(names.get(requestId), encodedDataLength),
  );
  await page.addInitScript(() => {
    let studio;
    Object.defineProperty(window, 'studio', {
      get: () => studio,
      set: (one) => {
        studio = one;
        const stop = one.view_facts.subscribe(() => {
          if (!one.growth.get().shown) return;
          const gl = document.querySelector('.view canvas').getContext('webgl2');
          gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
          window.first_picture = performance.now();
          stop();
        });
      },
    });
  });
  await page.goto(address);
  await page.waitForFunction(() => window.first_picture !== undefined, null, { timeout: 60000 });
  const first = await page.evaluate(() => window.first_picture);
  weights.delete('tables.json'); // of the library, and not of the page
  const weight = [...weights.values()].reduce((sum, one) => sum + one, 0);
  await context.close();
  return { first, weight };
}

/// Returns the median time from the request for the board to the frame that shows it, ms.
async function board_time(page, text) {
  await page.evaluate((said) => {
    window.studio.connection.tell('pause', { paused: true });
    return window.studio.open({ text: said, path: null });
  }, text);
  const times = [];
  for (let k = 0; k < (is_small ? 2 : 20); k += 1) {
    times.push(
      await page.evaluate(async () => {
        const { shell } = window.studio;
        shell.merge({ left: 'outline' });
        await new Promise((done) => requestAnimationFrame(() => setTimeout(done, 50)));
        // With software rendering, the compositor is busy while the view draws in its new size.
        await window.studio.view.drawn();
        const begin = performance.now();
        shell.merge({ left: 'board' });
        await new Promise((done) => requestAnimationFrame(() => setTimeout(done)));
        if (
          document.querySelectorAll('.board-node').length <
          Object.keys(window.studio.document.state.get().tree.value.components).length
        )
          throw new Error('the board is not whole');
        return performance.now() - begin;
      }),
    );
  }
  await page.evaluate(() => window.studio.connection.tell('pause', { paused: false }));
  return times.sort((a, b) => a - b)[Math.floor(times.length / 2)];
}

/// Returns the median milliseconds from the request for a step of growth to the packet that shows it, over distant
/// steps.
async function scrub_time(page) {
  await page.keyboard.press('s');
  await page.waitForFunction(() => window.studio.bench.growth_look.state.get().steps !== null, null, {
    timeout: 60000,
  });
  await settled(page);
  const times = await page.evaluate(
    async (count) => {
      const { studio } = window;
      const { steps } = studio.bench.growth_look.state.get();
      const taken = [];
      for (let k = 0; k < count; k += 1) {
        const step = Math.round(steps * (0.5 + 0.45 * Math.sin(2.4 * k)));
        const begin = performance.now();
        studio.bench.growth_look.show_step(step);
        await new Promise((done) => {
          const stop = studio.growth.subscribe(() => {
            const { grown, shown } = studio.growth.get();
            if (grown.step !== step || shown === studio.bench.last_shown) return;
            studio.bench.last_shown = shown;
            stop();
            done();
          });
        });
        taken.push(performance.now() - begin);
        await studio.view.drawn();
        await new Promise((done) => setTimeout(done, 100));
      }
      return taken;
    },
    is_small ? 3 : 30,
  );
  return quantile(times, 0.5);
}

/// Returns the median milliseconds from the request for an overlay to its points in the view.
async function overlay_time(page) {
  const times = await page.evaluate(
    async (count) => {
      const { studio } = window;
      const { growth_look: growth } = studio.bench;
      const taken = [];
      for (let k = 0; k < count; k += 1) {
        const begin = performance.now();
        growth.switch_part('points');
        while (studio.view.counts.overlays.points === 0) await new Promise((done) => setTimeout(done));
        taken.push(performance.now() - begin);
        growth.switch_part('points');
        await new Promise((done) => setTimeout(done, 50));
      }
      return taken;
    },
    is_small ? 3 : 30,
  );
  return quantile(times, 0.5);
}

/// Returns the milliseconds from clicks at the plant until its component is chosen, and until its instance is known.
async function pick_times(page) {
  await settled(page);
  await page.evaluate(() => {
    const { studio } = window;
    window.picks = [];
    document.querySelector('.view canvas').addEventListener(
      'pointerup',
      (event) => {
        window.picks.push({ begin: event.timeStamp, chosen: 0, known: 0 });
      },
      true,
    );
    studio.chosen.subscribe(() => {
      const last = window.picks.at(-1);
      if (last && last.chosen === 0 && studio.chosen.get() !== '') last.chosen = performance.now() - last.begin;
    });
    studio.instance.found.subscribe(() => {
      const last = window.picks.at(-1);
      if (last && last.known === 0 && studio.instance.found.get() !== null) last.known = performance.now() - last.begin;
    });
  });
  const box = await page.locator('.view canvas').boundingBox();
  for (let k = 0; k < (is_small ? 3 : 40); k += 1) {
    await page.evaluate(() => window.studio.choose(''));
    await page.evaluate(() => window.studio.view.drawn());
    await page.mouse.click(
      box.x + box.width * (0.42 + 0.16 * ((k * 0.618) % 1)),
      box.y + box.height * (0.3 + 0.3 * ((k * 0.414) % 1)),
    );
    await page.waitForFunction((count) => window.picks.length > count, k, { timeout: 10_000 });
    await page.waitForFunction(() => window.picks.at(-1).known > 0, null, { timeout: 2000 }).catch(() => undefined);
  }
  const picks = (await page.evaluate(() => window.picks)).filter((one) => one.chosen > 0);
  if (picks.length === 0) throw new Error('no click met the plant');
  console.log(`  ${picks.length} clicks met the plant`);
  return {
    chosen: quantile(
      picks.map((one) => one.chosen),
      0.5,
    ),
    known: quantile(
      picks.filter((one) => one.known > 0).map((one) => one.known),
      0.5,
    ),
  };
}

/// Returns the milliseconds from the request for a strip to its five plants: the first, and the median with a warm
/// cache.
async function strip_time(page, count) {
  const times = [];
  for (let k = 0; k < count; k += 1) {
    times.push(
      await page.evaluate(async () => {
        const { studio } = window;
        const { name } = studio.document.state.get().variables.find((one) => !one.private);
        studio.strip.set(null);
        await new Promise((done) => requestAnimationFrame(() => setTimeout(done, 50)));
        const begin = performance.now();
        studio.strip.set(name);
        while (document.querySelectorAll('.strip img.still:not(.old)').length < 5) {
          if (performance.now() - begin > 60_000) throw new Error('the strip does not come');
          await new Promise((done) => setTimeout(done, 5));
        }
        const took = performance.now() - begin;
        studio.strip.set(null);
        return took;
      }),
    );
  }
  return { first: times[0], again: quantile(times.slice(count > 1 ? 1 : 0), 0.5) };
}

/// Returns the seconds from the request to open a shipped plant to its first picture, and to its picture at rest.
function open_times(page, name) {
  return page.evaluate(async (model) => {
    const { studio } = window;
    const begin = performance.now();
    let first = 0;
    const at_rest = new Promise((done, fail) => {
      const stop = studio.growth.subscribe(() => {
        const { shown, failed } = studio.growth.get();
        const { model: opened, hash } = studio.document.state.get();
        if (failed) fail(new Error(failed.message));
        if (opened !== model || shown?.hash !== hash) return;
        const is_last = !shown.draft;
        if (is_last) stop();
        void studio.view.drawn().then(() => {
          const seconds = (performance.now() - begin) / 1000;
          first ||= seconds;
          if (is_last) done(seconds);
        });
      });
    });
    await studio.open({ model });
    return { rest: await at_rest, first };
  }, name);
}

/// Returns the seconds in which the command line grows and writes a shipped plant.
async function grow_time(name, folder) {
  const begin = performance.now();
  const { code, stderr } = await meristem('grow', name, '-o', path.join(folder, `${name}.glb`));
  if (code !== 0) throw new Error(stderr);
  return (performance.now() - begin) / 1000;
}

const place = await temporary_folder();
const browser = await start_browser({ as_users_do: !is_small });
const load = os.loadavg()[0];
try {
  const model = async (name) => readFile(path.join(kSource, 'models', `${name}.json`), 'utf8');
  await write_document(place.folder, 'oak.json', await model('oak'));
  await write_document(place.folder, 'sapling.json', JSON.stringify(kSapling));
  await write_document(place.folder, 'points.json', JSON.stringify(kPoints));
  await write_document(place.folder, 'limb.json', (await model('large-maple')).replace('"count": 26', '"count": 1'));
  const server = await start_server(place.folder, 'oak');
  const opened = await open_first(browser, server.address);
  tell('page_weight', opened.weight / 1000, 'kB', 500);
  tell('first_picture', opened.first / 1000, 's', 2);
  const context = await browser.newContext({ viewport: { width: 1280, height: 720 } });
  const page = await open_page(context, server.address);
  await page.evaluate(watch);

  const row_slider = (component, key) => row(page, `components.${component}.${key}`).getByRole('slider').first();
  await open_file(page, 'sapling.json');
  const sapling = await follow(page, slider(page, 'size'));
  tell('follow/sapling', sapling.median, 'ms');
  const reference = { name: 'sapling', value: sapling.median };
  const plants = [
    ['oak_leaf', 'oak.json', 'leaf', () => row_slider('leaf', 'fold')],
    ['maple_limb', 'limb.json', 'shoot', () => row_slider('shoot', 'radius')],
    ['oak_wood', 'oak.json', 'tree', () => row_slider('tree', 'tip_radius')],
  ];
  for (const [name, file, component, target] of plants) {
    await open_file(page, file);
    await choose(page, component);
    const { median, late } = await follow(page, target());
    tell(`follow/${name}/median`, median, 'ms', 50, reference);
    tell(`follow/${name}/95th_of_100`, late, 'ms', 90);
  }

  tell('board/garden', await board_time(page, await model('garden')), 'ms', 100);

  for (const name of kGardens) {
    const grow = await grow_time(name, place.folder);
    const { first, rest } = await open_times(page, name);
    tell(`open/${name}/first_picture`, first, 's', 5, { name: 'grow', value: grow });
    tell(`open/${name}/at_rest`, rest, 's', 2 * grow, { name: 'grow', value: grow });
  }

  await open_file(page, 'oak.json');
  const picks = await pick_times(page);
  tell('pick/oak_component', picks.chosen, 'ms', 30);
  tell('pick/oak_instance', picks.known, 'ms');
  const strips = await strip_time(page, is_small ? 1 : 8);
  tell('strip/oak_first', strips.first / 1000, 's');
  tell('strip/oak', strips.again / 1000, 's', 1);
  await set(page, 'leaf.fold', 14);
  await settled(page);
  tell('strip/oak_after_edit', (await strip_time(page, 1)).first / 1000, 's', 1);
  await set(page, 'leafiness', 0.35);
  await settled(page);
  tell('growth/oak_step', await scrub_time(page), 'ms', 100);
  await page.keyboard.press('s');
  await open_file(page, 'points.json');
  await page.keyboard.press('s');
  await page.waitForFunction(() => window.studio.bench.growth_look.state.get().steps !== null);
  tell('growth/overlay_of_10000', await overlay_time(page), 'ms', 20);
  await page.keyboard.press('s');

  await open_file(page, 'oak.json');
  tell('bytes/oak_leaf', (await bytes_of(page, () => set(page, 'leaf.fold', 12))) / 1e6, 'MB', 1.3);
  tell('bytes/oak_near_colour', (await bytes_of(page, () => set(page, 'leaf.colour', '#5a7b31'))) / 1000, 'kB', 2);
  tell('bytes/oak_far_colour', (await bytes_of(page, () => set(page, 'leaf.colour', '#a04020'))) / 1000, 'kB', 2);
  await page.evaluate(() => window.studio.view.drawn()); // what is seen has been acknowledged
  const sent = (await counts(page)).sent;
  const turned = await bytes_of(page, async () => {
    await point_at(page, page.locator('.view canvas'));
    await page.mouse.down();
    for (let k = 1; k <= 20; k += 1) await page.mouse.move(640 + 5 * k, 360);
    await page.mouse.up();
  });
  tell('bytes/camera', turned + (await counts(page)).sent - sent, 'B', 0);

  const session = await context.newCDPSession(page);
  const edit_often = async (begin, end) => {
    for (let k = begin; k < end; k += 1) {
      await set(page, 'leaf.fold', 10 + ((k * 7) % 23) / 2);
      if (k % 5 === 0) await settled(page);
    }
    await set(page, 'leaf.fold', 10);
    await settled(page);
  };
  // The first edits create lasting data, such as compiled code and the server's caches.
  await edit_often(0, kEdits / 5);
  const [buffers, heap, memory] = [await buffers_of(page), await heap_of(session), await memory_of(server.pid)];
  await edit_often(0, kEdits);
  tell(`edits:${kEdits}/buffers_more`, (await buffers_of(page)) - buffers, 'buffers', 0);
  tell(`edits:${kEdits}/heap_more`, (await heap_of(session)) - heap, 'MB', 5);
  const server_now = await memory_of(server.pid);
  tell(`edits:${kEdits}/server_memory`, server_now, 'MB', undefined, { name: 'before', value: memory });
  tell(`edits:${kEdits}/server_more`, (100 * (server_now - memory)) / memory, '%', 5);
  await context.close();
  await server.stop();
  console.log(`load ${load.toFixed(2)} before, ${os.loadavg()[0].toFixed(2)} after`);
} finally {
  await browser.close();
  await place.remove();
}
if (process.env.MERISTEM_BENCH_TABLE && !is_small)
  await appendFile(process.env.MERISTEM_BENCH_TABLE, figures.map((one) => `${one.join('\t')}\n`).join(''));
