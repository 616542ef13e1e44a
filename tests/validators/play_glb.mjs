// SPDX-License-Identifier: Apache-2.0
// Plays animated GLBs in three.js and compares them with the document grown at the same times.
//
// Usage: node play_glb.mjs PROGRAM FOLDER DOCUMENT [DOCUMENT ...]
//
// Each document is written as an animated GLB of nine keys, which the Khronos validator has to accept. The mixer of
// three.js moves the file to three of the keys. Its triangles must then have the bounds of the document's mesh at this
// time, and the same positions: samples of each surface must have a point of the other within 1 % of the plant's size.
import { execFileSync } from 'node:child_process';
import { readFile } from 'node:fs/promises';
import path from 'node:path';
import process from 'node:process';

globalThis.self ??= globalThis;

const [program, folder, ...documents] = process.argv.slice(2);
if (documents.length === 0) {
  console.error('usage: node play_glb.mjs PROGRAM FOLDER DOCUMENT [DOCUMENT ...]');
  process.exit(1);
}
const [{ AnimationMixer, Box3, LoopOnce, Texture, Vector3 }, { GLTFLoader }, validator] = await Promise.all([
  import('three'),
  import('three/addons/loaders/GLTFLoader.js'),
  import('gltf-validator'),
]).catch(() => {
  console.error(`three and gltf-validator are not installed; run 'npm ci' in ${import.meta.dirname ?? 'tests/validators'}`);
  process.exit(1);
});

const kKeys = 9;
const kPlayed = [3, 6, 8];
const kSamples = 400;
const kTolerance = 0.01; // of the plant's size

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

/// Returns the corners of all visible triangles, in the world.
function corners(scene) {
  scene.updateMatrixWorld(true);
  const points = [];
  const [a, b, c] = [new Vector3(), new Vector3(), new Vector3()];
  scene.traverse((object) => {
    if (!object.isMesh) return;
    const { index } = object.geometry;
    for (let t = 0; t < index.count; t += 3) {
      [a, b, c].forEach((corner, k) => {
        object.getVertexPosition(index.getX(t + k), corner).applyMatrix4(object.matrixWorld);
      });
      const area = b.clone().sub(a).cross(c.clone().sub(a)).length();
      if (area > 1e-12) points.push(a.clone(), b.clone(), c.clone());
    }
  });
  return points;
}

/// Points in cells of this width, for searches of near points.
class Cells {
  constructor(points, width) {
    this.width = width;
    this.cells = new Map();
    for (const point of points) {
      const key = this.key(point, 0, 0, 0);
      if (!this.cells.has(key)) this.cells.set(key, []);
      this.cells.get(key).push(point);
    }
  }
  key({ x, y, z }, dx, dy, dz) {
    const cell = (value, shift) => Math.floor(value / this.width) + shift;
    return `${cell(x, dx)} ${cell(y, dy)} ${cell(z, dz)}`;
  }
  /// Returns the distance to the nearest point, or Infinity beyond a cell's width.
  distance(point) {
    let best = Infinity;
    for (let k = 0; k < 27; ++k) {
      const key = this.key(point, (k % 3) - 1, (Math.floor(k / 3) % 3) - 1, Math.floor(k / 9) - 1);
      for (const other of this.cells.get(key) ?? []) best = Math.min(best, point.distanceTo(other));
    }
    return best;
  }
}

const spread = (points) => points.filter((_, k) => k % Math.max(1, Math.floor(points.length / kSamples)) === 0);

/// Returns points spread over the triangles, at distances of at most `step`.
function dense(points, step) {
  const all = [];
  for (let t = 0; t < points.length; t += 3) {
    const [a, b, c] = points.slice(t, t + 3);
    const longest = Math.max(a.distanceTo(b), b.distanceTo(c), c.distanceTo(a));
    const parts = Math.max(1, Math.ceil(longest / step));
    for (let i = 0; i <= parts; ++i) {
      for (let j = 0; i + j <= parts; ++j) {
        const [u, v] = [i / parts, j / parts];
        all.push(a.clone().multiplyScalar(1 - u - v).addScaledVector(b, u).addScaledVector(c, v));
      }
    }
  }
  return all;
}

/// Returns the largest distance of samples of `from` from the triangles of `to`.
function farthest(from, to, width) {
  const cells = new Cells(dense(to, 0.05 * width), 0.5 * width);
  return Math.max(0, ...spread(from).map((point) => cells.distance(point)));
}

let faults = 0;
function require(holds, message) {
  if (holds) return;
  console.log(message);
  ++faults;
}

const grow = (document, file, ...options) =>
  execFileSync(program, ['grow', document, '-o', file, '--quiet', ...options], { stdio: ['ignore', 'ignore', 'inherit'] });

for (const document of documents) {
  const name = path.basename(document, '.json');
  const moving = path.join(folder, `${name}.glb`);
  grow(document, moving, '--animated', '--keys', `${kKeys}`);
  const { issues } = await validator.default.validateBytes(new Uint8Array(await readFile(moving)), { maxIssues: 20 });
  const serious = issues.messages.filter(({ severity, code }) => severity < 2 && code !== 'UNSUPPORTED_EXTENSION');
  for (const { code, message, pointer } of serious) require(false, `${name}: ${code}: ${message} (${pointer})`);

  const { scene, animations } = await load(moving);
  require(animations.length === 1 && animations[0].name === 'growth', `${name}: it has no animation 'growth'`);
  if (animations.length === 0) continue;
  const mixer = new AnimationMixer(scene);
  const action = mixer.clipAction(animations[0]).setLoop(LoopOnce, 1);
  action.clampWhenFinished = true;
  action.play();
  const length = animations[0].duration;
  let before = -1;
  for (const key of kPlayed) {
    const time = (length * key) / (kKeys - 1);
    mixer.setTime(time);
    const played = corners(scene);
    const still = path.join(folder, `${name}-${key}.glb`);
    grow(document, still, '--time', `${time}`);
    const grown = corners((await load(still)).scene);
    const [here, there] = [new Box3().setFromPoints(played), new Box3().setFromPoints(grown)];
    const size = there.getSize(new Vector3()).length();
    const apart = Math.max(here.min.distanceTo(there.min), here.max.distanceTo(there.max));
    require(apart <= 2 * kTolerance * size, `${name} at ${time} s: bounds differ by ${apart} m of ${size} m`);
    const [lost, added] = [farthest(grown, played, 0.1 * size), farthest(played, grown, 0.1 * size)];
    require(lost <= kTolerance * size, `${name} at ${time} s: ${lost} m of ${size} m from what has grown to the film`);
    require(added <= kTolerance * size, `${name} at ${time} s: ${added} m of ${size} m from the film to what has grown`);
    require(size !== before, `${name}: nothing has moved up to ${time} s`);
    before = size;
    console.log(`${name} at ${time.toFixed(3)} s: ${grown.length / 3} triangles, ${(100 * lost / size).toFixed(3)} % and ${(100 * added / size).toFixed(3)} % off`);
  }
}
console.log(`${documents.length} documents, ${faults} faults`);
process.exit(faults === 0 ? 0 : 1);
