// SPDX-License-Identifier: Apache-2.0
// What the studio's benchmarks measure of a page and its server.
import { readFile } from 'node:fs/promises';

/// Resident memory of a process, MB.
export async function memory_of(pid) {
  return Number(/VmRSS:\s+(\d+)/.exec(await readFile(`/proc/${pid}/status`, 'utf8'))[1]) / 1024;
}

/// Heap of the page after its garbage was collected, in MB. `session` is one of the browser's protocol.
export async function heap_of(session) {
  for (let k = 0; k < 2; k += 1) await session.send('HeapProfiler.collectGarbage');
  return (await session.send('Runtime.getHeapUsage')).usedSize / 1e6;
}

/// What the view holds on the card: buffers, textures, and what these are made for.
export const buffers_of = (page) => page.evaluate(async () => {
  for (let frame = 0; frame < 3; frame += 1) await new Promise(requestAnimationFrame);
  const { geometries, textures, meshes, instance_sets, batches } = window.studio.view.counts;
  return geometries + textures + meshes + instance_sets + batches;
});
