// SPDX-License-Identifier: Apache-2.0
// Measurements of a page and its server for the studio's benchmarks.
import { readFile } from 'node:fs/promises';

/// Returns the resident memory of a process, MB.
export async function memory_of(pid) {
  return Number(/VmRSS:\s+(\d+)/.exec(await readFile(`/proc/${pid}/status`, 'utf8'))[1]) / 1024;
}

/// Returns the heap of the page after garbage collection, in MB. `session` is a session of the browser's protocol.
export async function heap_of(session) {
  for (let k = 0; k < 2; k += 1) await session.send('HeapProfiler.collectGarbage');
  return (await session.send('Runtime.getHeapUsage')).usedSize / 1e6;
}

/// Returns the page's heap as a text in the format of the browser's tools.
export async function snapshot_of(session) {
  const chunks = [];
  const take = ({ chunk }) => chunks.push(chunk);
  session.on('HeapProfiler.addHeapSnapshotChunk', take);
  await session.send('HeapProfiler.takeHeapSnapshot', { reportProgress: false });
  session.off('HeapProfiler.addHeapSnapshotChunk', take);
  return chunks.join('');
}

/// Returns the memory of the page's script in such a text, MB. Excludes compiled code, which grows with use, and the
/// copies of loaded files that the browser's tools keep.
export function objects_in(snapshot) {
  const {
    nodes,
    strings,
    snapshot: { meta },
  } = JSON.parse(snapshot);
  const [type, name, size] = ['type', 'name', 'self_size'].map((field) => meta.node_fields.indexOf(field));
  const kinds = meta.node_types[type];
  let sum = 0;
  for (let k = 0; k < nodes.length; k += meta.node_fields.length) {
    if (
      kinds[nodes[k + type]] !== 'code' &&
      !/NetworkResourcesData|Performance\w*Timing/.test(strings[nodes[k + name]])
    )
      sum += nodes[k + size];
  }
  return sum / 1e6;
}

/// Returns the view's objects on the card: buffers, textures, and their purposes.
export const buffers_of = (page) =>
  page.evaluate(async () => {
    for (let frame = 0; frame < 3; frame += 1) await new Promise(requestAnimationFrame);
    const { geometries, textures, meshes, instance_sets, batches } = window.studio.view.counts;
    return geometries + textures + meshes + instance_sets + batches;
  });
