// SPDX-License-Identifier: Apache-2.0
// Builds the tests of the page's units into a folder and runs them there: node test/run.mjs FOLDER
import { spawnSync } from 'node:child_process';
import { readdirSync } from 'node:fs';
import path from 'node:path';
import process from 'node:process';

const folder = path.resolve(process.argv[2] ?? 'units');
const run = (...words) => spawnSync(process.execPath, words, { stdio: 'inherit' }).status ?? 1;
const built = run('build.mjs', '--tests', folder);
process.exit(
  built !== 0
    ? built
    : run(
        '--test',
        ...readdirSync(folder)
          .filter((one) => one.endsWith('.mjs'))
          .map((one) => path.join(folder, one)),
      ),
);
