// SPDX-License-Identifier: Apache-2.0
// Uses the studio with random actions for a long time: node bench/studio_soak.mjs [MINUTES] [SEED]
//
// A headless browser shows the page of a real server. First comes a tour (studio_tour.mjs), which sends each request of
// the protocol at least once. Then random actions follow (studio_actions.mjs). The run fails in these cases:
// - The page reports an error, or does not come to rest. The server ends, or a sanitizer reports a fault.
// - A request of the protocol was never sent.
// - A saved file does not hold the page's text, or the page shows another text than the file that it opened.
// - The server has another text than the page. Undoing everything does not restore the first text. The seed determines
// all actions, on machines of equal speed. A fault is printed with the last actions before it and with the output of
// the server.
//
// Memory is measured each minute while a small document is open: the page's script after a garbage collection (with and
// without compiled code), the view's buffers, and the server. Measuring begins when each document was open, each action
// was done, and a sixth of the time has passed. By then all data that are made only once exist. The rise of memory
// compares the smallest figure of the first third with the smallest figure of the last third. Single figures vary up to
// twofold, since the server's allocator and the system's large pages keep freed memory; a leak raises the smallest
// figure too.
//
// MERISTEM, MERISTEM_CHROMIUM, MERISTEM_SLOWNESS: as for the page's tests. MERISTEM_SOAK_MINUTES, MERISTEM_SOAK_SEED:
// defaults of the two arguments. MERISTEM_SOAK_SANITIZED=1: the server has sanitizers, so memory is not measured.
// MERISTEM_SOAK_TELLS=1 prints each action. MERISTEM_SOAK_SNAPSHOTS: a folder for the page's heap at the first and at
// the last measurement, which the browser's tools can compare. MERISTEM_BENCH=small: the tour and a few actions,
// without measurements. MERISTEM_BENCH_TABLE: a file for the lines of the table.

import { existsSync } from 'node:fs';
import { appendFile, mkdir, readdir, readFile, writeFile } from 'node:fs/promises';
import os from 'node:os';
import path from 'node:path';
import process from 'node:process';
import { leave_fields, open_file, open_model, undo_all } from '../tests/studio/page/hands.mjs';
import {
  kSource,
  open_page,
  patient,
  settled,
  start_browser,
  start_server,
  temporary_folder,
  text_of,
  write_document,
} from '../tests/studio/page/support.mjs';
import { Chance, kActions, kModels, kRestFile, next_action } from './studio_actions.mjs';
import { buffers_of, heap_of, memory_of, objects_in, snapshot_of } from './studio_measure.mjs';
import { kTour, prepare_tour, protocol_requests } from './studio_tour.mjs';

const is_small = process.env.MERISTEM_BENCH === 'small';
const is_measured = !is_small && !process.env.MERISTEM_SOAK_SANITIZED;
const minutes = Number(process.argv[2] ?? process.env.MERISTEM_SOAK_MINUTES ?? 3);
const seed = Number(process.argv[3] ?? process.env.MERISTEM_SOAK_SEED ?? 1);
const kSmall = {
  meristem: 1,
  components: { stem: { type: 'tree', length: 1, radius: 0.02 }, leaf: { type: 'leaf', length: 0.1, width: 0.05 } },
  links: [{ from: 'stem', to: 'leaf', kind: 'branch', count: 8 }],
};
const kSmallActions = 6; // that are done at least, after the tour
const kMaxFaults = 10;
const kFlat = 10; // percent that memory may rise
const kRests = 0.25; // share of actions after which the page must come to rest
const kToFirst = 0.05; // share after which all is undone
const kReport = /AddressSanitizer|LeakSanitizer|UndefinedBehaviorSanitizer|runtime error:/;

const chance = new Chance(seed);
const faults = [];
const missed = new Map();
const done = new Map();
const last = [];
const began = Date.now();
const share = () => (Date.now() - began) / (minutes * 60_000);
const digits = (value) => String(Number(value.toPrecision(4)));

function add_fault(what) {
  faults.push(what);
  console.log(
    `FAULT ${faults.length} at ${((Date.now() - began) / 1000).toFixed(0)} s, seed ${seed}: ${what}\n  after ${last.slice(-12).join(', ')}`,
  );
}

/// Runs in the page before its own script. Draws the page's random numbers from the seed, counts requests by their names,
/// and keeps the texts that were saved. A `text` request shows that the server had another text than the page.
function prepare(from) {
  let state = from >>> 0;
  Math.random = () => {
    state = (state + 0x6d2b79f5) >>> 0;
    let mixed = Math.imul(state ^ (state >>> 15), state | 1);
    mixed ^= mixed + Math.imul(mixed ^ (mixed >>> 7), mixed | 61);
    return ((mixed ^ (mixed >>> 14)) >>> 0) / 4294967296;
  };
  window.requests = {};
  window.saved_texts = {};
  window.restored = 0;
  let studio;
  Object.defineProperty(window, 'studio', {
    get: () => studio,
    set: (one) => {
      studio = one;
      const { connection, document } = one;
      const request = connection.request.bind(connection);
      connection.request = async (what, ...rest) => {
        window.requests[what] = (window.requests[what] ?? 0) + 1;
        const { text } = document.state.get();
        const answer = await request(what, ...rest);
        if (what === 'save') window.saved_texts[answer.path] = text;
        return answer;
      };
      const take_kept = document.take_kept.bind(document);
      document.take_kept = (...rest) => {
        window.restored += 1;
        take_kept(...rest);
      };
    },
  });
}

/// Closes everything that is open over the document, and leaves all fields.
async function close_all(page) {
  for (let k = 0; k < 2; k += 1) await page.keyboard.press('Escape');
  await page.evaluate(() => document.activeElement?.blur());
}

/// A growth that a limit of the document refuses also counts as rest: the previous plant stays.
async function rest(page) {
  await close_all(page);
  await page.waitForFunction(() => Object.keys(window.studio.dragged.get()).length === 0, null, {
    timeout: patient(60_000),
  });
  const is_refused = await page.evaluate(() => window.studio.growth.get().failed !== null);
  if (!is_refused)
    await settled(page).catch(async (fault) => {
      if ((await page.evaluate(() => window.studio.growth.get().failed)) === null) throw fault;
    });
  const { whole, restored } = await page.evaluate(() => ({
    whole: window.requests.text ?? 0,
    restored: window.restored,
  }));
  if (whole > restored + rest.known) {
    add_fault('the server had another text than the page');
    rest.known = whole - restored;
  }
}
rest.known = 0;

/// Returns another text for each document, and for each opening of a document.
const document_of = (page) =>
  page.evaluate(
    () =>
      `${window.studio.document.state.get().path} ${window.studio.document.state.get().model} ${window.requests.open}`,
  );

/// The text with which the document was opened, or with which unsaved work has begun.
const first_text = (page) =>
  page.evaluate(() => {
    const { text, undo, hash, base } = window.studio.document.state.get();
    return undo.done.length === 0 && hash === base ? text : null;
  });

async function undo_everything(page, first) {
  await leave_fields(page);
  await undo_all(page);
  await rest(page);
  if (first !== null && (await text_of(page)) !== first) add_fault('undoing everything does not give the first text');
}

/// The memory while a document is at rest.
async function held(page, session, server) {
  await close_all(page);
  await page.evaluate(() => {
    const { studio } = window;
    if (studio.bench.growth_look.state.get().is_open) studio.bench.growth_look.close();
    if (studio.bench.time.state.get().is_open) studio.bench.time.toggle();
    studio.shell.merge({ side: 'inspector', left: 'outline', dialog: null });
    studio.change_view({ drawing: 'shaded' });
  });
  // Opens the document twice: the second growth releases memory that jobs of the previous document have freed late.
  for (let k = 0; k < 2; k += 1) await open_file(page, kRestFile);
  await page.waitForTimeout(1000); // kept work is let go
  await settled(page);
  const heap = await heap_of(session);
  const metrics = new Map(
    (await session.send('Performance.getMetrics')).metrics.map(({ name, value }) => [name, value]),
  );
  const snapshot = await snapshot_of(session);
  const folder = process.env.MERISTEM_SOAK_SNAPSHOTS;
  if (folder) await writeFile(path.join(folder, `${held.is_later ? 'last' : 'first'}.heapsnapshot`), snapshot);
  held.is_later = true;
  return {
    heap,
    objects: objects_in(snapshot),
    buffers: await buffers_of(page),
    server: await memory_of(server.pid),
    nodes: metrics.get('Nodes'),
    listeners: metrics.get('JSEventListeners'),
  };
}

/// Returns the increase from the minimum of the first third to the minimum of the last third, in percent.
function rise(figures, key) {
  const third = Math.max(1, Math.floor(figures.length / 3));
  const lowest = (some) => Math.min(...some.map((one) => one[key]));
  const [from, to] = [lowest(figures.slice(0, third)), lowest(figures.slice(-third))];
  return (100 * (to - from)) / from;
}

held.is_later = false;

async function do_action(page, action, opened, first) {
  last.push(action.name);
  const began_at = Date.now();
  try {
    const is_done = await action(page, chance, files);
    done.set(action.name, (done.get(action.name) ?? 0) + (is_done ? 1 : 0));
  } catch (fault) {
    const why = `${action.name}: ${String(fault.message).split('\n')[0].slice(0, 160)}`;
    missed.set(why, (missed.get(why) ?? 0) + 1);
    if (
      /does not settle/.test(fault.message) &&
      (await page.evaluate(() => window.studio.growth.get().failed)) === null
    )
      add_fault(fault.message);
    await page.mouse.up().catch(() => undefined);
  }
  await close_all(page);
  const [rests, undoes] = [chance.happens(kRests), chance.happens(kToFirst)];
  if (rests || undoes) await rest(page).catch((fault) => add_fault(String(fault.message)));
  // Another document may have been opened, whose first text is not known here.
  if (undoes)
    await undo_everything(page, (await document_of(page)) === opened ? first : null).catch((fault) =>
      add_fault(`undoing everything: ${fault.message}`),
    );
  if (process.env.MERISTEM_SOAK_TELLS) console.log(`  ${action.name} ${Date.now() - began_at} ms`);
}

/// The files in the server's folder, which actions save and open.
const files = {
  folder: '',
  read: (name) => readFile(path.join(files.folder, name), 'utf8'),
  write: (name, text) => write_document(files.folder, name, text),
  /// Names of the documents that may be saved over.
  async documents() {
    return (await readdir(files.folder)).filter((name) => name.endsWith('.json') && name !== kRestFile).sort();
  },
  async compare_opened(page, name) {
    if ((await text_of(page)) !== (await files.read(name)))
      add_fault(`the page shows ${name} with another text than the file's`);
  },
  /// Compares the texts saved since the last check with the files.
  async compare_saved(page) {
    const saved = await page.evaluate(() => {
      const texts = window.saved_texts;
      window.saved_texts = {};
      return texts;
    });
    for (const [name, text] of Object.entries(saved)) {
      const there = await files.read(name).catch(String);
      if (there !== text)
        add_fault(
          `${name} was saved with another text than the page's: ${JSON.stringify(there.slice(0, 80))} in place of ${JSON.stringify(text.slice(0, 80))}`,
        );
      saves += 1;
    }
  },
};
let saves = 0;

const place = await temporary_folder();
files.folder = place.folder;
const browser = await start_browser();
const load = os.loadavg()[0];
try {
  await prepare_tour(place.folder);
  await write_document(place.folder, kRestFile, JSON.stringify(kSmall));
  await write_document(place.folder, 'own.json', await readFile(path.join(kSource, 'models', 'oak.json'), 'utf8'));
  const server = await start_server(place.folder, is_measured ? 'own.json' : kRestFile);
  const context = await browser.newContext({
    viewport: { width: 1280, height: 720 },
    permissions: ['clipboard-read', 'clipboard-write'],
  });
  await context.addInitScript(prepare, seed);
  const page = await open_page(context, server.address);
  await page.getByRole('button', { name: 'Start', exact: true }).click();
  const session = await context.newCDPSession(page);
  await session.send('Performance.enable');
  const folder = path.join(kSource, 'build/release/bench');
  await mkdir(folder, { recursive: true });

  let told = 0; // complaints of the page so far
  let actions = 0;
  let opened = '';
  let first = null;
  const look_for_faults = async () => {
    if (kReport.test(server.log())) throw new Error('a sanitizer reports a fault of the server');
    if (!existsSync(`/proc/${server.pid}`)) throw new Error('the server has ended');
    const complaints = page.faults.filter((fault) => !/WebGL|GL Driver/i.test(fault));
    for (const fault of complaints.slice(told)) add_fault(`the page: ${fault}`);
    if (complaints.length > told)
      await page.screenshot({ path: path.join(folder, `soak-fault-${faults.length}.png`) }).catch(() => undefined);
    told = complaints.length;
    await files.compare_saved(page);
  };
  const has_ended = server.ended.then(() => {
    throw new Error('the server has ended');
  });
  has_ended.catch(() => undefined); // where nothing waits for it
  /// Does something that ends with the server.
  const while_served = (act) => Promise.race([act(), has_ended]);
  const do_one = (action) =>
    while_served(async () => {
      const name = await document_of(page);
      if (name !== opened) first = await first_text(page);
      opened = name;
      await do_action(page, action, opened, first);
      actions += 1;
      await look_for_faults();
    });
  const go_on_tour = async () => {
    for (const part of kTour) {
      last.push(part.name);
      const began_at = Date.now();
      await while_served(() => part(page, files)).catch((fault) => {
        throw new Error(`the tour, ${part.name}: ${fault.message}`, { cause: fault });
      });
      await while_served(look_for_faults);
      if (process.env.MERISTEM_SOAK_TELLS) console.log(`  ${part.name} ${Date.now() - began_at} ms`);
    }
    const sent = await page.evaluate(() => window.requests);
    const missing = (await protocol_requests()).filter((name) => !(name in sent));
    if (missing.length > 0) add_fault(`the tour never sends these requests of the protocol: ${missing.join(', ')}`);
    console.log(
      `the tour took ${((Date.now() - began) / 1000).toFixed(0)} s and sent ${Object.keys(sent).length} kinds of requests`,
    );
  };
  const tell_held = (now) =>
    console.log(
      `${((Date.now() - began) / 60_000).toFixed(1).padStart(6)} min  ${String(actions).padStart(5)} actions  page ${digits(now.objects)} MB of ${digits(now.heap)} with code, ${now.buffers} buffers, ${now.nodes} nodes, ${now.listeners} listeners; server ${digits(now.server)} MB`,
    );
  const measure = async () => {
    const now = await held(page, session, server);
    opened = '';
    tell_held(now);
    return now;
  };
  const figures = [];
  try {
    await go_on_tour();
    if (is_measured) {
      for (const [k, model] of kModels.entries()) {
        await open_model(page, model);
        for (let n = k; n < kActions.length; n += kModels.length) await do_one(kActions[n][1]);
      }
    }
    let next_minute = 0;
    while ((actions < kSmallActions || (!is_small && share() < 1)) && faults.length < kMaxFaults) {
      await do_one(next_action(chance));
      if (is_measured && share() >= 1 / 6 && Date.now() - began > next_minute * 60_000) {
        figures.push(await measure());
        next_minute = Math.floor((Date.now() - began) / 60_000) + 1;
      }
    }
    const end = is_measured ? await measure() : null;
    if (end && (figures.length < 2 || Date.now() - began > (next_minute - 0.7) * 60_000)) figures.push(end);
  } catch (fault) {
    add_fault(String(fault.message));
  }
  const code = await server.stop();
  if (code !== 0) add_fault(`the server has ended with ${code}`);
  else if (kReport.test(server.log())) add_fault('a sanitizer reports a fault of the server at its end');
  console.log([...done].map(([name, count]) => `${name} ${count}`).join(', '));
  for (const [why, count] of missed) console.log(`  could not be done ${count} times: ${why}`);
  const lines = [['faults', faults.length, '', 0]];
  if (figures.length > 1)
    lines.push(
      ['page_more', rise(figures, 'objects'), '%', kFlat],
      ['page_with_code_more', rise(figures, 'heap'), '%'],
      ['buffers_more', figures.at(-1).buffers - figures[0].buffers, 'buffers', 0],
      ['server_more', rise(figures, 'server'), '%', kFlat],
    );
  for (const [what, value, unit, max] of lines) {
    const asked = max === undefined ? '' : `<= ${max}`;
    const verdict = max === undefined ? '' : value <= max ? 'held' : 'NOT HELD';
    console.log(`${`soak/${what}`.padEnd(24)} ${digits(value).padStart(8)} ${unit.padEnd(8)} ${asked}  ${verdict}`);
    if (process.env.MERISTEM_BENCH_TABLE && !is_small)
      await appendFile(
        process.env.MERISTEM_BENCH_TABLE,
        `${[`studio soak:${minutes}min/${what}`, `${digits(value)} ${unit}`, '', '', asked, verdict].join('\t')}\n`,
      );
  }
  if (faults.length > 0 && server.log() !== '') console.log(`what the server has written:\n${server.log()}`);
  console.log(
    `${actions} actions and ${saves} saved files in ${((Date.now() - began) / 60_000).toFixed(1)} minutes, seed ${seed}; load ${load.toFixed(2)} before, ${os.loadavg()[0].toFixed(2)} after`,
  );
  await context.close();
} finally {
  await browser.close();
  await place.remove();
}
process.exitCode = faults.length > 0 ? 1 : 0;
