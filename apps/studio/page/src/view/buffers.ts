// SPDX-License-Identifier: Apache-2.0
// Owns what lies on the graphics card: meshes and sets of instances by their keys, and the batches that draw one with
// the other. Arrays are those of the packets, in place; three uploads them once, and again after a lost context.
import * as three from 'three';

import type { Packet, PacketInstances, PacketMesh } from '../server/packet.ts';
import { bytes, floats, shorts, signed_bytes, words } from '../server/packet.ts';

type Attributes = Record<string, three.BufferAttribute | three.InterleavedBufferAttribute>;

/// Arrays that several batches may draw from.
interface Shared {
  attributes: Attributes;
  index?: three.BufferAttribute;
  count: number; // of triangles, or of instances
  bytes: number;
  users: Set<three.InstancedBufferGeometry>;
}

export interface Batch {
  geometry: three.InstancedBufferGeometry;
  mesh: string;
  instances_of: string;
  tint_scale: three.Color;
}

const kWhite: [number, number, number] = [1, 1, 1];

export class Buffers {
  private readonly meshes_ = new Map<string, Shared>();
  private readonly sets_ = new Map<string, Shared & { tint_scale: [number, number, number] }>();
  private readonly batches_ = new Map<string, Batch>();

  get counts(): { meshes: number; instance_sets: number; batches: number; bytes: number } {
    let sum = 0;
    for (const shared of [...this.meshes_.values(), ...this.sets_.values()]) sum += shared.bytes;
    return { meshes: this.meshes_.size, instance_sets: this.sets_.size, batches: this.batches_.size, bytes: sum };
  }

  /// Triangles of a batch, all its instances together.
  triangles_of(batch: Batch): number {
    return (this.meshes_.get(batch.mesh)?.count ?? 0) * (this.sets_.get(batch.instances_of)?.count ?? 0);
  }

  add_mesh(packet: Packet, mesh: PacketMesh): void {
    const attributes: Attributes = {
      position: new three.BufferAttribute(floats(packet, mesh.positions), 3),
      normal: new three.BufferAttribute(signed_bytes(packet, mesh.normals), 4, true),
    };
    if (mesh.tangents) attributes['tangent'] = new three.BufferAttribute(signed_bytes(packet, mesh.tangents), 4, true);
    if (mesh.uvs) {
      const is_short = mesh.uv_type !== 'f32';
      attributes['uv'] = new three.BufferAttribute((is_short ? shorts : floats)(packet, mesh.uvs), 2, is_short);
    }
    const index = new three.BufferAttribute((mesh.index_type === 'u32' ? words : shorts)(packet, mesh.indices), 1);
    this.meshes_.set(mesh.key, { attributes, index, count: mesh.triangles, bytes: bytes_of(attributes) + index.array.byteLength, users: new Set() });
  }

  add_instances(packet: Packet, set: PacketInstances): void {
    const frames = new three.InstancedInterleavedBuffer(floats(packet, set.frames), 12);
    const attributes: Attributes = {};
    for (const row of [0, 1, 2]) attributes[`frame_${row}`] = new three.InterleavedBufferAttribute(frames, 4, 4 * row);
    // Without tints one white serves all.
    const tints = set.tints ? bytes(packet, set.tints) : new Uint8Array([255, 255, 255, 255]);
    attributes['tint'] = new three.InstancedBufferAttribute(tints, 4, true, set.tints ? 1 : Math.max(set.count, 1));
    const size = set.frames[1] * 4 + tints.byteLength;
    this.sets_.set(set.key, { attributes, count: set.count, bytes: size, users: new Set(), tint_scale: set.tint_scale ?? kWhite });
  }

  /// Three rows of the matrix of an instance; none where the set never came.
  frame_of(set_key: string, instance: number): number[] {
    const row = this.sets_.get(set_key)?.attributes['frame_0'];
    return row instanceof three.InterleavedBufferAttribute ? [...row.data.array.slice(12 * instance, 12 * instance + 12)] : [];
  }

  /// A set of one instance of another.
  add_single(key: string, set_key: string, instance: number): void {
    const row = this.sets_.get(set_key)?.attributes['frame_0'];
    if (!(row instanceof three.InterleavedBufferAttribute)) return;
    const frames = new three.InstancedInterleavedBuffer(new Float32Array(row.data.array.slice(12 * instance, 12 * instance + 12)), 12);
    const attributes = Object.fromEntries([0, 1, 2].map((one) => [`frame_${one}`, new three.InterleavedBufferAttribute(frames, 4, 4 * one)]));
    this.sets_.set(key, { attributes, count: 1, bytes: 48, users: new Set(), tint_scale: kWhite });
  }

  /// Draws the mesh once for each instance of the set, in place of what the batch drew before.
  add_batch(key: string, mesh_key: string, set_key: string): Batch {
    this.remove_batch(key);
    const mesh = this.meshes_.get(mesh_key);
    const set = this.sets_.get(set_key);
    if (!mesh?.index || !set) throw new Error(`a batch of what never came: ${mesh_key}, ${set_key}`);
    const geometry = new three.InstancedBufferGeometry();
    for (const [name, attribute] of Object.entries({ ...mesh.attributes, ...set.attributes })) geometry.setAttribute(name, attribute);
    geometry.setIndex(mesh.index);
    geometry.instanceCount = set.count;
    mesh.users.add(geometry);
    set.users.add(geometry);
    const batch = { geometry, mesh: mesh_key, instances_of: set_key, tint_scale: new three.Color(...set.tint_scale) };
    this.batches_.set(key, batch);
    return batch;
  }

  /// three frees all arrays of a geometry that is disposed of, so those that others still draw are taken out before.
  remove_batch(key: string): void {
    const batch = this.batches_.get(key);
    if (!batch) return;
    this.batches_.delete(key);
    for (const shared of [this.meshes_.get(batch.mesh), this.sets_.get(batch.instances_of)]) {
      if (!shared) continue;
      shared.users.delete(batch.geometry);
      if (shared.users.size === 0) continue;
      for (const name of Object.keys(shared.attributes)) batch.geometry.deleteAttribute(name);
      if (shared.index) batch.geometry.setIndex(null);
    }
    batch.geometry.dispose();
  }

  /// Forgets arrays; batches of them are gone already.
  remove(meshes: string[], sets: string[]): void {
    for (const key of meshes) this.meshes_.delete(key);
    for (const key of sets) this.sets_.delete(key);
  }

  clear(): void {
    for (const key of [...this.batches_.keys()]) this.remove_batch(key);
    this.meshes_.clear();
    this.sets_.clear();
  }
}

function bytes_of(attributes: Attributes): number {
  return Object.values(attributes).reduce((sum, one) => sum + one.array.byteLength, 0);
}
