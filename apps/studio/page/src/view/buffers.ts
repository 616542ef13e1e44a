// SPDX-License-Identifier: Apache-2.0
// Owns the data on the graphics card: meshes and sets of instances by their keys, and the batches that draw them.
// Arrays of packets are used in place if a mesh is needed only once. three uploads arrays once, and again after a lost
// context.
import * as three from 'three';

import type { Packet, PacketInstances, PacketMesh } from '../server/packet.ts';
import { bytes, floats, shorts, signed_bytes, words } from '../server/packet.ts';
import type { Placing } from './instances.ts';
import { copies_for, frames_texture, tints_texture } from './instances.ts';
import { Solid } from './ray.ts';

/// Arrays that several batches may share: copies of a mesh.
interface Arrays {
  attributes: Record<string, three.BufferAttribute>;
  index: three.BufferAttribute;
  users: Set<three.InstancedBufferGeometry>;
}

interface Mesh {
  once: Arrays;
  copied: Map<number, Arrays>; // by the number of copies; 1: `once`
  vertices: number;
  triangles: number;
  solid: Solid;
}

interface InstanceSet {
  frames: three.DataTexture;
  tints: three.DataTexture;
  count: number;
  tint_scale: [number, number, number];
}

export interface Batch extends Placing {
  geometry: three.InstancedBufferGeometry;
  mesh: string;
  instances_of: string;
  tint_scale: three.Color;
  solid: Solid; // mesh of the batch, for rays
}

const kWhite: [number, number, number] = [1, 1, 1];

export class Buffers {
  private readonly meshes_ = new Map<string, Mesh>();
  private readonly sets_ = new Map<string, InstanceSet>();
  private readonly batches_ = new Map<string, Batch>();
  // One white texture serves all sets without tints of a view. A texture that views share would keep all these views in
  // memory.
  private readonly no_tints_ = tints_texture(new Uint8Array([255, 255, 255, 255]), 1);

  get counts(): { meshes: number; instance_sets: number; batches: number; bytes: number } {
    let sum = 0;
    for (const mesh of this.meshes_.values()) for (const arrays of mesh.copied.values()) sum += bytes_of(arrays);
    for (const { frames, tints } of this.sets_.values())
      sum += texture_bytes(frames) + (tints === this.no_tints_ ? 0 : texture_bytes(tints));
    return { meshes: this.meshes_.size, instance_sets: this.sets_.size, batches: this.batches_.size, bytes: sum };
  }

  /// Returns the triangles of all instances of a batch.
  triangles_of(batch: Batch): number {
    return (this.meshes_.get(batch.mesh)?.triangles ?? 0) * batch.instances;
  }

  add_mesh(packet: Packet, mesh: PacketMesh): void {
    const attributes: Arrays['attributes'] = {
      position: new three.BufferAttribute(floats(packet, mesh.positions), 3),
      normal: new three.BufferAttribute(signed_bytes(packet, mesh.normals), 4, true),
    };
    if (mesh.tangents) attributes['tangent'] = new three.BufferAttribute(signed_bytes(packet, mesh.tangents), 4, true);
    if (mesh.uvs) {
      const is_short = mesh.uv_type !== 'f32';
      attributes['uv'] = new three.BufferAttribute((is_short ? shorts : floats)(packet, mesh.uvs), 2, is_short);
    }
    const index = new three.BufferAttribute((mesh.index_type === 'u32' ? words : shorts)(packet, mesh.indices), 1);
    const vertices = attributes['position']?.count ?? 0;
    attributes['copy'] = new three.BufferAttribute(new Uint16Array(vertices), 1);
    const once = { attributes, index, users: new Set<three.InstancedBufferGeometry>() };
    const uv = attributes['uv'];
    const solid = new Solid(floats(packet, mesh.positions), index.array, uv ? (k) => [uv.getX(k), uv.getY(k)] : null);
    this.meshes_.set(mesh.key, { once, copied: new Map([[1, once]]), vertices, triangles: mesh.triangles, solid });
  }

  add_instances(packet: Packet, set: PacketInstances): void {
    const frames = frames_texture(floats(packet, set.frames), set.count);
    const tints = set.tints ? tints_texture(bytes(packet, set.tints), set.count) : this.no_tints_;
    this.put_set(set.key, { frames, tints, count: set.count, tint_scale: set.tint_scale ?? kWhite });
  }

  /// Returns three rows of the matrix of an instance. Returns an empty list if the set is unknown.
  frame_of(set_key: string, instance: number): number[] {
    const rows = this.sets_.get(set_key)?.frames.image.data;
    return rows instanceof Float32Array ? [...rows.slice(12 * instance, 12 * instance + 12)] : [];
  }

  /// Adds a set with one instance of another set.
  add_single(key: string, set_key: string, instance: number): void {
    const frame = this.frame_of(set_key, instance);
    if (frame.length === 0) return;
    this.put_set(key, {
      frames: frames_texture(new Float32Array(frame), 1),
      tints: this.no_tints_,
      count: 1,
      tint_scale: kWhite,
    });
  }

  /// Draws the mesh once for each instance of the set. Replaces what the batch drew before.
  add_batch(key: string, mesh_key: string, set_key: string): Batch {
    this.remove_batch(key);
    const mesh = this.meshes_.get(mesh_key);
    const set = this.sets_.get(set_key);
    if (!mesh || !set) throw new Error(`a batch of what never came: ${mesh_key}, ${set_key}`);
    const copies = copies_for(mesh.vertices, set.count);
    const arrays = arrays_of(mesh, copies);
    const geometry = new three.InstancedBufferGeometry();
    for (const [name, attribute] of Object.entries(arrays.attributes)) geometry.setAttribute(name, attribute);
    geometry.setIndex(arrays.index);
    geometry.instanceCount = Math.ceil(set.count / copies);
    arrays.users.add(geometry);
    const { frames, tints, count } = set;
    const batch = {
      geometry,
      mesh: mesh_key,
      instances_of: set_key,
      tint_scale: new three.Color(...set.tint_scale),
      frames,
      tints,
      instances: count,
      copies,
      solid: mesh.solid,
    };
    this.batches_.set(key, batch);
    return batch;
  }

  /// three frees all arrays of a geometry that is disposed of. Arrays that other batches use are therefore detached
  /// first.
  remove_batch(key: string): void {
    const batch = this.batches_.get(key);
    if (!batch) return;
    this.batches_.delete(key);
    const mesh = this.meshes_.get(batch.mesh);
    const arrays = mesh?.copied.get(batch.copies);
    if (mesh && arrays) {
      arrays.users.delete(batch.geometry);
      if (arrays.users.size > 0) {
        for (const name of Object.keys(arrays.attributes)) batch.geometry.deleteAttribute(name);
        batch.geometry.setIndex(null);
      } else if (batch.copies > 1) {
        mesh.copied.delete(batch.copies);
      }
    }
    batch.geometry.dispose();
  }

  /// Removes arrays. Their batches must be removed already.
  remove(meshes: string[], sets: string[]): void {
    for (const key of meshes) this.meshes_.delete(key);
    for (const key of sets) this.remove_set(key);
  }

  clear(): void {
    for (const key of [...this.batches_.keys()]) this.remove_batch(key);
    this.remove([...this.meshes_.keys()], [...this.sets_.keys()]);
    this.no_tints_.dispose();
  }

  private put_set(key: string, set: InstanceSet): void {
    this.remove_set(key);
    this.sets_.set(key, set);
  }

  private remove_set(key: string): void {
    const set = this.sets_.get(key);
    set?.frames.dispose();
    if (set && set.tints !== this.no_tints_) set.tints.dispose();
    this.sets_.delete(key);
  }
}

/// Returns the arrays with this number of copies of a mesh, one copy after the other.
function arrays_of(mesh: Mesh, copies: number): Arrays {
  const known = mesh.copied.get(copies);
  if (known) return known;
  const attributes: Arrays['attributes'] = {};
  for (const [name, { array, itemSize, normalized }] of Object.entries(mesh.once.attributes)) {
    const repeated = new (array.constructor as new (length: number) => typeof array)(array.length * copies);
    for (let k = 0; k < copies; k += 1) {
      if (name === 'copy') repeated.fill(k, k * mesh.vertices, (k + 1) * mesh.vertices);
      else repeated.set(array, k * array.length);
    }
    attributes[name] = new three.BufferAttribute(repeated, itemSize, normalized);
  }
  const corners = mesh.once.index.array;
  const indices = new Uint16Array(corners.length * copies); // a mesh with copies has few vertices
  for (let k = 0; k < copies; k += 1) {
    for (let c = 0; c < corners.length; c += 1) indices[k * corners.length + c] = (corners[c] ?? 0) + k * mesh.vertices;
  }
  const made = {
    attributes,
    index: new three.BufferAttribute(indices, 1),
    users: new Set<three.InstancedBufferGeometry>(),
  };
  mesh.copied.set(copies, made);
  return made;
}

function bytes_of({ attributes, index }: Arrays): number {
  return Object.values(attributes).reduce((sum, one) => sum + one.array.byteLength, index.array.byteLength);
}

function texture_bytes({ image }: three.DataTexture): number {
  return image.data?.byteLength ?? 0;
}
