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

/// The page's heap as the browser's tools read it, a text.
export async function snapshot_of(session) {
  const chunks = [];
  const take = ({ chunk }) => chunks.push(chunk);
  session.on('HeapProfiler.addHeapSnapshotChunk', take);
  await session.send('HeapProfiler.takeHeapSnapshot', { reportProgress: false });
  session.off('HeapProfiler.addHeapSnapshotChunk', take);
  return chunks.join('');
}

/// What the page's script holds by such a text, MB: without the code that the engine compiles the more a function is used, and
/// without what the browser's tools keep of all that was loaded.
export function objects_in(snapshot) {
  const { nodes, strings, snapshot: { meta } } = JSON.parse(snapshot);
  const [type, name, size] = ['type', 'name', 'self_size'].map((field) => meta.node_fields.indexOf(field));
  const kinds = meta.node_types[type];
  let sum = 0;
  for (let k = 0; k < nodes.length; k += meta.node_fields.length) {
    if (kinds[nodes[k + type]] !== 'code' && !/NetworkResourcesData|Performance\w*Timing/.test(strings[nodes[k + name]])) sum += nodes[k + size];
  }
  return sum / 1e6;
}

/// What the view holds on the card: buffers, textures, and what these are made for.
export const buffers_of = (page) => page.evaluate(async () => {
  for (let frame = 0; frame < 3; frame += 1) await new Promise(requestAnimationFrame);
  const { geometries, textures, meshes, instance_sets, batches } = window.studio.view.counts;
  return geometries + textures + meshes + instance_sets + batches;
});
