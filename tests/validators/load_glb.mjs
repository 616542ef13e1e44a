// SPDX-License-Identifier: Apache-2.0
// Loads the samples with the loader of three.js and compares them with the contents that glb_samples reports. If GLB
// files are given, loads them and prints their contents. Exits with 1 if the contents differ. Pictures are not decoded,
// because this needs a browser.
import { readFile } from 'node:fs/promises';
import path from 'node:path';
import process from 'node:process';

globalThis.self ??= globalThis;

const folder = process.argv[2];
if (!folder) {
  console.error('usage: node load_glb.mjs FOLDER_OF_SAMPLES | FILE.glb ...');
  process.exit(1);
}
const [{ Matrix4, Texture }, { GLTFLoader }] = await Promise.all([
  import('three'),
  import('three/addons/loaders/GLTFLoader.js'),
]).catch(() => {
  console.error(`three is not installed; run 'npm ci' in ${import.meta.dirname ?? 'tests/validators'}`);
  process.exit(1);
});

/// Replaces the loader of pictures.
const withoutPictures = (parser) => ({
  name: 'WITHOUT_PICTURES',
  beforeRoot() {
    parser.textureLoader = { load: (_url, onLoad) => onLoad(new Texture()) };
  },
});

async function load(file) {
  const bytes = await readFile(file);
  const loader = new GLTFLoader().register(withoutPictures);
  return loader.parseAsync(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength), '');
}

/// Returns the smallest and the largest height of all vertices, including instances.
function heights(mesh) {
  mesh.updateWorldMatrix(true, false);
  const places = [];
  if (mesh.isInstancedMesh) {
    for (let i = 0; i < mesh.count; ++i) {
      const place = new Matrix4();
      mesh.getMatrixAt(i, place);
      places.push(place.premultiply(mesh.matrixWorld));
    }
  } else {
    places.push(mesh.matrixWorld);
  }
  mesh.geometry.computeBoundingBox();
  const bounds = places.map((place) => mesh.geometry.boundingBox.clone().applyMatrix4(place));
  return [Math.min(...bounds.map(({ min }) => min.y)), Math.max(...bounds.map(({ max }) => max.y))];
}

function countsOf(scene) {
  const counts = { triangles: 0, instanced_meshes: 0, instance_colours: 0, vertex_colours: 0, tangents: 0 };
  const materials = new Set();
  let [low, high] = [Infinity, -Infinity];
  scene.traverse((object) => {
    if (!object.isMesh) return;
    const { attributes, index } = object.geometry;
    counts.triangles += (index.count / 3) * (object.isInstancedMesh ? object.count : 1);
    counts.instanced_meshes += object.isInstancedMesh ? 1 : 0;
    counts.instance_colours += object.instanceColor ? 1 : 0;
    counts.vertex_colours += attributes.color ? 1 : 0;
    counts.tangents += attributes.tangent ? 1 : 0;
    materials.add(object.material);
    const [below, above] = heights(object);
    [low, high] = [Math.min(low, below), Math.max(high, above)];
  });
  const all = [...materials];
  counts.materials_with_map = all.filter(({ map }) => map).length;
  counts.materials_with_normal_map = all.filter(({ normalMap }) => normalMap).length;
  counts.masked_materials = all.filter(({ alphaTest }) => alphaTest === 0.5).length;
  return { counts, low, high };
}

if (folder.endsWith('.glb')) {
  for (const file of process.argv.slice(2)) {
    const { counts } = countsOf((await load(file)).scene);
    console.log(file, counts);
  }
  process.exit(0);
}

let faults = 0;
const expectations = JSON.parse(await readFile(path.join(folder, 'expected.json'), 'utf8'));
for (const [name, { low, high, ...expected }] of Object.entries(expectations)) {
  const found = countsOf((await load(path.join(folder, name))).scene);
  for (const [what, count] of Object.entries(expected)) {
    if (found.counts[what] === count) continue;
    console.log(`${name}: ${what}: ${found.counts[what]}, where ${count} were written`);
    ++faults;
  }
  // Boxes of turned leaves are larger than the leaves, so the box of three.js may lie slightly outside of the expected
  // box.
  if (low <= high && !(found.low <= low + 1e-4 && found.low > low - 0.5 && found.high >= high - 1e-4 && found.high < high + 0.5)) {
    console.log(`${name}: from ${found.low} m to ${found.high} m, where it is from ${low} m to ${high} m`);
    ++faults;
  }
}
console.log(`${Object.keys(expectations).length} files, ${faults} faults`);
process.exit(faults === 0 ? 0 : 1);
