// SPDX-License-Identifier: Apache-2.0
// Builds the page of the view alone. `node build_viewer.mjs FILE` writes a template with {{title}}, {{look}} and
// {{packet}}. Programs that write pages replace these: by a text, by "AZIMUTH ALTITUDE" in degrees or nothing, and by a
// scene packet (gzip, base64).

import { mkdir, readFile, writeFile } from 'node:fs/promises';
import path from 'node:path';
import process from 'node:process';
import { fileURLToPath } from 'node:url';
import { gzipSync } from 'node:zlib';
import { build } from 'esbuild';

import { notices_of } from './notices.mjs';

const kMaxBytes = 220_000;
const here = path.dirname(fileURLToPath(import.meta.url));
const common = {
  bundle: true,
  minify: true,
  write: false,
  target: 'es2022',
  logLevel: 'warning',
  absWorkingDir: here,
  legalComments: 'none',
};

const out = process.argv[2];
if (out === undefined) throw new Error('usage: node build_viewer.mjs FILE');
const script = await build({ ...common, entryPoints: ['src/viewer/viewer.ts'], format: 'iife', metafile: true });
const style = await build({ ...common, entryPoints: ['src/viewer/viewer.css'] });
const filled = {
  // A comment of HTML ends at two dashes.
  notices: (await notices_of(script.metafile.inputs)).join('\n').replaceAll('--', '- -'),
  style: style.outputFiles[0].text.trim(),
  viewer: gzipSync(script.outputFiles[0].contents, { level: 9 }).toString('base64'),
};
let page = await readFile(path.join(here, 'src/viewer/viewer.html'), 'utf8');
for (const [name, text] of Object.entries(filled)) page = page.replace(`{{${name}}}`, () => text);
console.log(`the viewer's page weighs ${(page.length / 1000).toFixed(0)} kB, of ${kMaxBytes / 1000}`);
if (page.length > kMaxBytes) throw new Error('the page of the viewer is too heavy');
await mkdir(path.dirname(path.resolve(out)), { recursive: true });
await writeFile(out, page);
