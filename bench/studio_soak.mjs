// SPDX-License-Identifier: Apache-2.0
// The studio under random hands for a long time: node bench/studio_soak.mjs [MINUTES] [SEED]
//
// A headless browser shows the page of a real server; deeds follow each other by chance (studio_deeds.mjs). A fault is an
// error of the page, a server that ends, a page that does not come to rest, a text of which page and server have not the
// same, or undoing everything without the first text. All deeds follow from the seed, as far as the machine is equally
// fast, and the last ones before a fault are told. Memory is measured each minute with a small document at rest: what the
// page's script holds after its garbage was collected, and that with the code that the engine compiles of it, the more
// the longer it is used; the view's buffers; and the server's. It begins when each document has been open, each deed has
// been done, and a sixth of the time is over, so that all that is made once is there. How much memory rises is told by
// the least of the first and of the last third of these figures: the server's allocator and the system's large pages keep
// now more and now less of what was freed, up to as much again, and a leak raises the least too. The table's lines go to
// the file that MERISTEM_BENCH_TABLE names. MERISTEM_BENCH=small does a few deeds and measures nothing. MERISTEM,
// MERISTEM_CHROMIUM: as for the page's tests; MERISTEM_SOAK_MINUTES, MERISTEM_SOAK_SEED: for words that are not given;
// MERISTEM_SOAK_TELLS=1 prints each deed; MERISTEM_SOAK_SNAPSHOTS: a folder for the page's heap at the first and at the
// last of these moments, which the browser's tools can compare.
import { appendFile, mkdir, readFile, writeFile } from 'node:fs/promises';
import { existsSync } from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import process from 'node:process';

import { buffers_of, heap_of, memory_of, objects_in, snapshot_of } from './studio_measure.mjs';
import { Chance, kDeeds, kModels, next_deed } from './studio_deeds.mjs';
import { leave_fields, open_file, open_model, undo_all } from '../tests/studio/page/hands.mjs';
import { kSource, open_page, settled, start_browser, start_server, temporary_folder, text_of, write_document } from '../tests/studio/page/support.mjs';

const is_small = process.env.MERISTEM_BENCH === 'small';
const minutes = Number(process.argv[2] ?? process.env.MERISTEM_SOAK_MINUTES ?? 3);
const seed = Number(process.argv[3] ?? process.env.MERISTEM_SOAK_SEED ?? 1);
const kSmall = { meristem: 1, components: { stem: { type: 'tree', length: 1, radius: 0.02 }, leaf: { type: 'leaf', length: 0.1, width: 0.05 } }, links: [{ from: 'stem', to: 'leaf', kind: 'branch', count: 8 }] };
const kSmallDeeds = 6;
const kMostFaults = 10;
const kFlat = 10; // percent that memory may rise
const kRests = 0.25; // share of deeds after which the page must come to rest
const kToFirst = 0.05; // share after which all is undone

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
  console.log(`FAULT ${faults.length} at ${((Date.now() - began) / 1000).toFixed(0)} s, seed ${seed}: ${what}\n  after ${last.slice(-12).join(', ')}`);
}

/// All that chance decides in the page follows from the seed, too; and texts that are sent whole are counted, since the
/// page sends them where the server has another one.
function prepare(from) {
  let state = from >>> 0;
  Math.random = () => {
    state = (state + 0x6d2b79f5) >>> 0;
    let mixed = Math.imul(state ^ (state >>> 15), state | 1);
    mixed ^= mixed + Math.imul(mixed ^ (mixed >>> 7), mixed | 61);
    return ((mixed ^ (mixed >>> 14)) >>> 0) / 4294967296;
  };
  window.whole_texts = 0;
  window.restored = 0;
  let studio;
  Object.defineProperty(window, 'studio', {
    get: () => studio,
    set: (one) => {
      studio = one;
      const { connection, keeper } = one;
      const request = connection.request.bind(connection);
      connection.request = (what, ...rest) => {
        if (what === 'text') window.whole_texts += 1;
        return request(what, ...rest);
      };
      const restore = keeper.restore.bind(keeper);
      keeper.restore = (work) => {
        window.restored += 1;
        restore(work);
      };
    },
  });
}

/// Nothing is open over the document, and no field has the keyboard.
async function close_all(page) {
  for (let k = 0; k < 2; k += 1) await page.keyboard.press('Escape');
  await page.evaluate(() => document.activeElement?.blur());
}

/// A growth that a limit of the document refuses is at rest, too: what was shown before stays.
async function rest(page) {
  await close_all(page);
  await page.waitForFunction(() => Object.keys(window.studio.dragged.get()).length === 0, null, { timeout: 60_000 });
  const is_refused = await page.evaluate(() => window.studio.growth.get().failed !== null);
  if (!is_refused) await settled(page).catch(async (fault) => {
    if ((await page.evaluate(() => window.studio.growth.get().failed)) === null) throw fault;
  });
  const { whole, restored } = await page.evaluate(() => ({ whole: window.whole_texts, restored: window.restored }));
  if (whole > restored + rest.known) {
    add_fault('the server had another text than the page');
    rest.known = whole - restored;
  }
}
rest.known = 0;

const document_of = (page) => page.evaluate(() => `${window.studio.document.state.get().path} ${window.studio.document.state.get().model}`);

/// The text with which the document was opened, or with which unsaved work has begun.
const first_text = (page) => page.evaluate(() => {
  const { text, undo, hash, base } = window.studio.document.state.get();
  return undo.done.length === 0 && hash === base ? text : null;
});

async function undo_everything(page, first) {
  await leave_fields(page);
  await undo_all(page);
  await rest(page);
  if (first !== null && (await text_of(page)) !== first) add_fault('undoing everything does not give the first text');
}

/// What is held while one document is at rest.
async function held(page, session, server) {
  await close_all(page);
  await page.evaluate(() => {
    const { studio } = window;
    if (studio.bench.growth_look.state.get().is_open) studio.bench.growth_look.close();
    if (studio.bench.time.state.get().is_open) studio.bench.time.toggle();
    studio.shell.merge({ side: 'inspector', left: 'outline', dialog: null });
    studio.change_view({ drawing: 'shaded' });
  });
  // Opened twice: with the second growth goes what the jobs of the document before have freed late.
  for (let k = 0; k < 2; k += 1) await open_file(page, 'small.json');
  await page.waitForTimeout(1000); // kept work is let go
  await settled(page);
  const heap = await heap_of(session);
  const metrics = new Map((await session.send('Performance.getMetrics')).metrics.map(({ name, value }) => [name, value]));
  const snapshot = await snapshot_of(session);
  const folder = process.env.MERISTEM_SOAK_SNAPSHOTS;
  if (folder) await writeFile(path.join(folder, `${held.is_later ? 'last' : 'first'}.heapsnapshot`), snapshot);
  held.is_later = true;
  return { heap, objects: objects_in(snapshot), buffers: await buffers_of(page), server: await memory_of(server.pid), nodes: metrics.get('Nodes'), listeners: metrics.get('JSEventListeners') };
}

/// Percent that the least of the last third lies above that of the first.
function rise(figures, key) {
  const third = Math.max(1, Math.floor(figures.length / 3));
  const least = (some) => Math.min(...some.map((one) => one[key]));
  const [from, to] = [least(figures.slice(0, third)), least(figures.slice(-third))];
  return (100 * (to - from)) / from;
}

held.is_later = false;

async function do_deed(page, deed, opened, first) {
  last.push(deed.name);
  const began_at = Date.now();
  try {
    const is_done = await deed(page, chance);
    done.set(deed.name, (done.get(deed.name) ?? 0) + (is_done ? 1 : 0));
  } catch (fault) {
    const why = `${deed.name}: ${String(fault.message).split('\n')[0].slice(0, 160)}`;
    missed.set(why, (missed.get(why) ?? 0) + 1);
    if (/does not settle/.test(fault.message) && (await page.evaluate(() => window.studio.growth.get().failed)) === null) add_fault(fault.message);
    await page.mouse.up().catch(() => undefined);
  }
  await close_all(page);
  const [rests, undoes] = [chance.happens(kRests), chance.happens(kToFirst)];
  if (rests || undoes) await rest(page).catch((fault) => add_fault(String(fault.message)));
  // Another document may have been opened, whose first text is not known here.
  if (undoes) await undo_everything(page, (await document_of(page)) === opened ? first : null).catch((fault) => add_fault(`undoing everything: ${fault.message}`));
  if (process.env.MERISTEM_SOAK_TELLS) console.log(`  ${deed.name} ${Date.now() - began_at} ms`);
}

const place = await temporary_folder();
const browser = await start_browser();
const load = os.loadavg()[0];
try {
  await write_document(place.folder, 'small.json', JSON.stringify(kSmall));
  await write_document(place.folder, 'own.json', await readFile(path.join(kSource, 'models', 'oak.json'), 'utf8'));
  const server = await start_server(place.folder, is_small ? 'small.json' : 'own.json');
  const context = await browser.newContext({ viewport: { width: 1280, height: 720 } });
  await context.addInitScript(prepare, seed);
  const page = await open_page(context, server.address);
  await page.getByRole('button', { name: 'Start', exact: true }).click();
  const session = await context.newCDPSession(page);
  await session.send('Performance.enable');
  const folder = path.join(kSource, 'build/bench');
  await mkdir(folder, { recursive: true });

  let told = 0; // complaints of the page so far
  let deeds = 0;
  let opened = '';
  let first = null;
  const do_one = async (deed) => {
    const name = await document_of(page);
    if (name !== opened) first = await first_text(page);
    opened = name;
    await do_deed(page, deed, opened, first);
    deeds += 1;
    const complaints = page.faults.filter((fault) => !/WebGL|GL Driver/i.test(fault));
    for (const fault of complaints.slice(told)) add_fault(`the page: ${fault}`);
    if (complaints.length > told) await page.screenshot({ path: path.join(folder, `soak-fault-${faults.length}.png`) }).catch(() => undefined);
    told = complaints.length;
    if (!existsSync(`/proc/${server.pid}`)) throw new Error('the server has ended');
  };
  const tell_held = (now) => console.log(`${((Date.now() - began) / 60_000).toFixed(1).padStart(6)} min  ${String(deeds).padStart(5)} deeds  page ${digits(now.objects)} MB of ${digits(now.heap)} with code, ${now.buffers} buffers, ${now.nodes} nodes, ${now.listeners} listeners; server ${digits(now.server)} MB`);
  const measure = async () => {
    const now = await held(page, session, server);
    opened = '';
    tell_held(now);
    return now;
  };
  const figures = [];
  try {
    if (!is_small) {
      for (const [k, model] of kModels.entries()) {
        await open_model(page, model);
        for (let n = k; n < kDeeds.length; n += kModels.length) await do_one(kDeeds[n][1]);
      }
    }
    let next_minute = 0;
    while ((is_small ? deeds < kSmallDeeds : share() < 1) && faults.length < kMostFaults) {
      await do_one(next_deed(chance));
      if (!is_small && share() >= 1 / 6 && Date.now() - began > next_minute * 60_000) {
        figures.push(await measure());
        next_minute = Math.floor((Date.now() - began) / 60_000) + 1;
      }
    }
    const end = is_small ? null : await measure();
    if (end && (figures.length < 2 || Date.now() - began > (next_minute - 0.7) * 60_000)) figures.push(end);
  } catch (fault) {
    add_fault(String(fault.message));
  }
  console.log([...done].map(([name, count]) => `${name} ${count}`).join(', '));
  for (const [why, count] of missed) console.log(`  could not be done ${count} times: ${why}`);
  const lines = [['faults', faults.length, '', 0]];
  if (figures.length > 1) lines.push(['page_more', rise(figures, 'objects'), '%', kFlat], ['page_with_code_more', rise(figures, 'heap'), '%'], ['buffers_more', figures.at(-1).buffers - figures[0].buffers, 'buffers', 0], ['server_more', rise(figures, 'server'), '%', kFlat]);
  for (const [what, value, unit, most] of lines) {
    const asked = most === undefined ? '' : `<= ${most}`;
    const verdict = most === undefined ? '' : value <= most ? 'held' : 'NOT HELD';
    console.log(`${`soak/${what}`.padEnd(24)} ${digits(value).padStart(8)} ${unit.padEnd(8)} ${asked}  ${verdict}`);
    if (process.env.MERISTEM_BENCH_TABLE && !is_small) await appendFile(process.env.MERISTEM_BENCH_TABLE, `${[`studio soak:${minutes}min/${what}`, `${digits(value)} ${unit}`, '', '', asked, verdict].join('\t')}\n`);
  }
  console.log(`${deeds} deeds in ${((Date.now() - began) / 60_000).toFixed(1)} minutes, seed ${seed}; load ${load.toFixed(2)} before, ${os.loadavg()[0].toFixed(2)} after`);
  await context.close();
  await server.stop();
} finally {
  await browser.close();
  await place.remove();
}
process.exitCode = faults.length > 0 ? 1 : 0;
