// SPDX-License-Identifier: Apache-2.0
// The licence notices of the packages in a bundle.
import { readdir, readFile } from 'node:fs/promises';
import path from 'node:path';
import { fileURLToPath } from 'node:url';

const here = path.dirname(fileURLToPath(import.meta.url));

/// Returns the packages in a bundle, found by the paths of its inputs.
function packages_in(inputs) {
  const found = Object.keys(inputs).map((file) => /.*node_modules\/((?:@[^/]+\/)?[^/]+)\//.exec(file)?.[1]);
  return [...new Set(found.filter(Boolean))].sort();
}

async function notice_of(name) {
  const folder = path.join(here, 'node_modules', name);
  const { version, license } = JSON.parse(await readFile(path.join(folder, 'package.json'), 'utf8'));
  const file = (await readdir(folder)).find((one) => /^licen[cs]e/i.test(one));
  const text = file ? await readFile(path.join(folder, file), 'utf8') : '';
  if (!/^(MIT|BSD-[23]-Clause|Apache-2\.0|ISC|0BSD)$/.test(license ?? ''))
    throw new Error(`${name} has the licence ${license}`);
  return `${name} ${version} (${license})\n\n${text.trim()}\n`;
}

/// Name, version and licence of each package in a bundle, by esbuild's inputs.
export const notices_of = (inputs) => Promise.all(packages_in(inputs).map(notice_of));
