// SPDX-License-Identifier: Apache-2.0
// Paths below the server's folder, with '/' between names; "" is the folder itself.

export function folder_of(path: string): string {
  return path.slice(0, Math.max(0, path.lastIndexOf('/')));
}

function names_of(path: string): string[] {
  const names: string[] = [];
  for (const name of path.split('/')) {
    if (name === '..' && names.length > 0) names.pop();
    else if (name !== '' && name !== '.' && name !== '..') names.push(name);
  }
  return names;
}

/// Returns the relative path from a folder to a file.
export function path_from(folder: string, file: string): string {
  const [from, to] = [names_of(folder), names_of(file)];
  let shared = 0;
  while (shared < from.length && shared + 1 < to.length && from[shared] === to[shared]) shared += 1;
  return [...from.slice(shared).map(() => '..'), ...to.slice(shared)].join('/');
}
