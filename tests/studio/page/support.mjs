// SPDX-License-Identifier: Apache-2.0
// A running studio and a browser that shows it. MERISTEM names the program, MERISTEM_CHROMIUM the browser, and
// MERISTEM_CHROMIUM_SHELL this browser without windows. MERISTEM_PAGE is a folder with another page than the program's
// own. MERISTEM_SLOWNESS multiplies all times of waiting, as for a program with sanitizers.
import { execFile, spawn } from 'node:child_process';
import { mkdtemp, readdir, rm, writeFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import os from 'node:os';
import path from 'node:path';
import process from 'node:process';
import { fileURLToPath } from 'node:url';
import { promisify } from 'node:util';

const here = path.dirname(fileURLToPath(import.meta.url));
export const kSource = path.resolve(here, '../../..');
const require = createRequire(path.join(kSource, 'apps/studio/page/package.json'));
const { chromium } = require('playwright-core');
export const kAxe = require.resolve('axe-core/axe.min.js');
export const validator = require('gltf-validator');

export const kProgram = process.env.MERISTEM ?? path.join(kSource, 'build/release/bin/meristem');
const kSlowness = Number(process.env.MERISTEM_SLOWNESS ?? 1);
/// Returns a waiting time for this machine and program.
export const patient = (ms) => ms * kSlowness;
const kLongest = patient(20_000); // ms until the text must have changed
const kOften = 20; // ms between looks at whether what is waited for has come
const kBrowser = process.env.MERISTEM_CHROMIUM ?? '/usr/bin/chromium';
// The browser without windows, if there is one: without forms, profiles and the like.
const kShell = process.env.MERISTEM_CHROMIUM_SHELL || kBrowser;
// A processor draws instead of a graphics card, so panels are painted without GPU rasterization, which is three times
// as fast.
const kArguments = [
  '--no-sandbox',
  '--use-angle=swiftshader',
  '--enable-unsafe-swiftshader',
  '--ignore-gpu-blocklist',
  '--disable-gpu-rasterization',
];
// A page that replaces the program's own page has no address. By default, browsers do not let such a page connect to
// this machine.
if (process.env.MERISTEM_PAGE) kArguments.push('--disable-features=LocalNetworkAccessChecks');

export async function temporary_folder() {
  const folder = await mkdtemp(path.join(os.tmpdir(), 'meristem-studio-'));
  return { folder, remove: () => rm(folder, { recursive: true, force: true }) };
}

/// Runs the program and returns its output, with its exit `code`.
export async function meristem(...words) {
  try {
    return { code: 0, ...(await promisify(execFile)(kProgram, words, { maxBuffer: 1e8 })) };
  } catch (fault) {
    return { code: fault.code, stdout: fault.stdout, stderr: fault.stderr };
  }
}

/// Starts a server on a free port and returns it with its printed address. `stop` returns its exit code, `ended` waits
/// for the end, and `log` returns its output on standard error.
export async function start_server(folder, ...words) {
  const child = spawn(kProgram, ['studio', ...words, '--root', folder, '--no-browser'], { cwd: folder });
  let said = '';
  child.stderr.on('data', (data) => (said += data));
  const ended = new Promise((done) => child.on('close', done));
  const address = await new Promise((resolve, reject) => {
    child.stdout.on('data', (data) => {
      const found = /http:\/\/\S+/.exec(String(data));
      if (found) resolve(found[0]);
    });
    child.on('close', (code) => reject(new Error(`the studio ended with ${code}: ${said}`)));
  });
  const stop = (signal = 'SIGTERM') => {
    if (child.exitCode === null && child.signalCode === null) child.kill(signal);
    return ended;
  };
  return { address, stop, ended, pid: child.pid, log: () => said };
}

/// Starts a browser that also composes its pages without the graphics card, with half of the pixels along each side,
/// which makes tests faster. `as_users_do` starts it as users do, for measurements of speed and for tests of all
/// messages of the browser. Contexts for pictures need a `deviceScaleFactor` of 1.
export async function start_browser({ as_users_do = false } = {}) {
  if (as_users_do) return chromium.launch({ executablePath: kBrowser, args: kArguments });
  const browser = await chromium.launch({ executablePath: kShell, args: [...kArguments, '--disable-gpu-compositing'] });
  const make = browser.newContext.bind(browser);
  browser.newContext = (wishes) => make({ deviceScaleFactor: 0.5, reducedMotion: 'reduce', ...wishes });
  return browser;
}

/// Opens a page of the studio and records its errors.
export async function open_page(context, address) {
  const page = await context.newPage();
  page.setDefaultTimeout(patient(30_000));
  // Polls at intervals, because polling at each frame makes the browser draw the next frame.
  const wait = page.waitForFunction.bind(page);
  page.waitForFunction = (wanted, fact, wishes) => wait(wanted, fact, { polling: kOften, ...wishes });
  page.faults = [];
  page.on('pageerror', (fault) => page.faults.push(String(fault)));
  page.on('console', (message) => {
    if (message.type() === 'error') page.faults.push(message.text());
  });
  await visit(page, address);
  return page;
}

export async function visit(page, address) {
  if (process.env.MERISTEM_PAGE) await serve_folder(page, address, process.env.MERISTEM_PAGE);
  await page.goto(address);
  await ready(page);
}

/// Replaces the program's page by a built page, for work on the page.
async function serve_folder(page, address, folder) {
  for (const file of await readdir(folder)) {
    await page.route(file === 'index.html' ? address : address + file, (route) =>
      route.fulfill({ path: path.join(folder, file) }),
    );
  }
}

/// Waits until the document is open and its plant is shown.
export async function ready(page) {
  await page.waitForFunction(() => window.studio?.document.state.get().text && window.studio.growth.get().shown, null, {
    timeout: patient(60_000),
  });
  await settled(page);
}

/// Waits until the server knows the text, and the plant of the text is shown at rest.
export async function settled(page) {
  const state = () =>
    page.evaluate(() =>
      JSON.stringify([
        window.studio.document.state.get().hash,
        window.studio.growth.get(),
        window.studio.server.get().link,
      ]),
    );
  await page
    .waitForFunction(
      () => {
        const { studio } = window;
        const { hash, good } = studio.document.state.get();
        const { shown, working } = studio.growth.get();
        return (
          Object.keys(studio.dragged.get()).length === 0 &&
          (!good || (shown?.hash === hash && !shown.draft && !working))
        );
      },
      null,
      { timeout: patient(60_000) },
    )
    .catch(async (fault) => {
      throw new Error(`the page does not settle: ${await state()}`, { cause: fault });
    });
}

/// Runs `act`, and waits until the text has changed and the page has had the time to show it. The time limit begins
/// when `act` has ended, because a slow machine may take long for the moves of a drag.
export async function changes(page, act) {
  await page.evaluate(() => {
    const { state } = window.studio.document;
    const { text } = state.get();
    window.text_changes = new Promise((done) => {
      const stop = state.subscribe(() => {
        if (state.get().text === text) return;
        stop();
        requestAnimationFrame(() => setTimeout(() => done(true)));
      });
    });
  });
  await act();
  const within = (limit) =>
    Promise.race([window.text_changes, new Promise((done) => setTimeout(() => done(false), limit))]);
  if (await page.evaluate(within, kLongest)) return;
  const state = await page.evaluate(() => [
    window.studio.chosen.get(),
    document.activeElement.outerHTML.slice(0, 200),
    ...window.studio.toasts.shown.get().map((one) => one.text),
    window.studio.document.state.get().text,
  ]);
  throw new Error(`the text stays what it is: ${state.join('\n')}`);
}

/// Waits until the page has drawn some frames. What had to happen by itself has then happened.
export const frames = (page, count = 3) =>
  page.evaluate(async (wanted) => {
    for (let k = 0; k < wanted; k += 1) await new Promise((done) => requestAnimationFrame(() => setTimeout(done)));
  }, count);

/// Gives the page a theme, or the system's (null), and waits for the end of all transitions to its colours.
export async function set_theme(page, theme) {
  await page.emulateMedia({ colorScheme: theme });
  await still(page);
}

/// Waits until no transition or animation of the page that ends by itself runs.
export async function still(page) {
  await frames(page);
  await page.waitForFunction(() =>
    document
      .getAnimations()
      .every((one) => one.playState !== 'running' || one.effect.getComputedTiming().endTime === Infinity),
  );
}

/// Returns the record of unsaved work on a file that the browser keeps for this tab, or on the open document if no
/// file is given. Null if there is no such work.
export async function kept_work(page, name) {
  return page.evaluate(async (wanted) => {
    const database = await new Promise((done, fail) => {
      const asked = indexedDB.open('meristem-studio');
      asked.onsuccess = () => done(asked.result);
      asked.onerror = () => fail(asked.error);
    });
    const asked = database.transaction('slots').objectStore('slots').getAll();
    const all = await new Promise((done) => (asked.onsuccess = () => done(asked.result)));
    database.close();
    const path = wanted ?? window.studio.document.state.get().path;
    return all.find((one) => one.path === path && one.tab === sessionStorage.getItem('meristem.tab')) ?? null;
  }, name);
}

/// Waits until the browser keeps the present text and the edits that wait for the server.
export async function kept(page) {
  for (const begun = Date.now(); Date.now() - begun < kLongest; ) {
    const work = await kept_work(page);
    const is_kept = (known) => {
      const { text, waiting } = window.studio.document.state.get();
      return known !== null && known.text === text && known.waiting === waiting.length;
    };
    if (await page.evaluate(is_kept, work && { text: work.text, waiting: work.waiting.length })) return;
    await frames(page, 1);
  }
  throw new Error(`the browser does not keep the text: ${JSON.stringify(await kept_work(page))}`);
}

export const text_of = (page) => page.evaluate(() => window.studio.document.state.get().text);
export const undo_count = (page) => page.evaluate(() => window.studio.document.state.get().undo.done.length);

export async function write_document(folder, name, text) {
  await writeFile(path.join(folder, name), text);
}
