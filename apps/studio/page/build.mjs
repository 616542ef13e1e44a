// SPDX-License-Identifier: Apache-2.0
// Builds the page into a folder that the program embeds: node build.mjs OUT [--check]. Prints its compressed size, and
// fails if this exceeds the limit of the page. node build.mjs --tests OUT builds the unit tests.

import { mkdir, readdir, readFile, rm, writeFile } from 'node:fs/promises';
import path from 'node:path';
import process from 'node:process';
import { fileURLToPath } from 'node:url';
import { gzipSync } from 'node:zlib';
import { build } from 'esbuild';

import { notices_of } from './notices.mjs';

const kMaxBytes = 500_000;
const here = path.dirname(fileURLToPath(import.meta.url));
const common = { bundle: true, target: 'es2022', logLevel: 'warning', absWorkingDir: here, jsx: 'automatic' };

/// Returns the first values of new components that would otherwise have faults, by type. They are the components of the
/// palette's documents with a description.
async function starters() {
  const folder = path.join(here, '../parts');
  const made = {};
  for (const file of (await readdir(folder)).filter((one) => one.endsWith('.json')).sort()) {
    const document = JSON.parse((await readFile(path.join(folder, file), 'utf8')).replace(/^\s*\/\/.*$/gm, ''));
    const name = path.basename(file, '.json');
    const { type, ...starter } = document.components[name];
    if (document.description !== undefined) made[type] = starter;
  }
  return made;
}

async function build_page(out) {
  await rm(out, { recursive: true, force: true });
  await mkdir(out, { recursive: true });
  const made = await build({
    ...common,
    entryPoints: { page: 'src/main.tsx' },
    outdir: out,
    format: 'esm',
    minify: true,
    metafile: true,
    legalComments: 'none',
    define: { 'process.env.NODE_ENV': '"production"' },
  });
  await build({ ...common, entryPoints: { page: 'src/style/page.css' }, outdir: out, minify: true });
  for (const file of ['index.html', 'icon.svg'])
    await writeFile(path.join(out, file), await readFile(path.join(here, 'src', file)));
  await writeFile(path.join(out, 'starters.json'), JSON.stringify(await starters()));
  const notices = await notices_of(made.metafile.inputs);
  await writeFile(
    path.join(out, 'notices.txt'),
    `The studio's page contains these packages.\n\n${notices.join(`\n${'-'.repeat(80)}\n\n`)}`,
  );
  let sum = 0;
  for (const file of (await readdir(out)).sort())
    sum += gzipSync(await readFile(path.join(out, file)), { level: 9 }).length;
  console.log(`the page weighs ${(sum / 1000).toFixed(0)} kB compressed, of ${kMaxBytes / 1000}`);
  if (sum > kMaxBytes) throw new Error('the page is too heavy');
}

async function build_tests(out) {
  const files = (await readdir(path.join(here, 'test'))).filter((one) => one.endsWith('.test.ts'));
  await rm(out, { recursive: true, force: true });
  await build({
    ...common,
    entryPoints: files.map((one) => `test/${one}`),
    outdir: out,
    outExtension: { '.js': '.mjs' },
    format: 'esm',
    platform: 'node',
    sourcemap: 'inline',
  });
}

const [first, second] = process.argv.slice(2);
if (first === undefined) throw new Error('usage: node build.mjs OUT | --tests OUT');
if (first === '--tests') await build_tests(path.resolve(second ?? 'tests'));
else await build_page(path.resolve(first));
