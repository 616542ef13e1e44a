// SPDX-License-Identifier: Apache-2.0
// Scene packets: a head in JSON, and arrays that are used where they lie.
import type { Vec } from '../base/vec.ts';

/// First byte, counted from the first array, and how many numbers.
export type ArrayPlace = [number, number];

export interface PacketPicture {
  key: string;
  type: string;
  width: number;
  height: number;
  bytes: ArrayPlace;
}

export interface PacketMaterial {
  index: number;
  name: string;
  colour: [number, number, number];
  roughness: number;
  translucency: number;
  two_sided: boolean;
  masked: boolean;
  picture?: string;
  normals?: string;
}

export interface PacketMesh {
  key: string;
  vertices: number;
  triangles: number;
  positions: ArrayPlace;
  normals: ArrayPlace;
  tangents?: ArrayPlace;
  uvs?: ArrayPlace;
  uv_type?: 'u16' | 'f32';
  indices: ArrayPlace;
  index_type: 'u16' | 'u32';
}

export interface PacketInstances {
  key: string;
  count: number;
  frames: ArrayPlace;
  tints?: ArrayPlace;
  tint_scale?: [number, number, number];
}

export interface PacketBatch {
  component: string;
  number: number;
  mesh: string;
  material: number;
  instances_of: string;
}

export interface PacketSkeleton {
  key: string;
  positions: ArrayPlace;
  segments: ArrayPlace;
  orders: ArrayPlace;
  radii: ArrayPlace;
}

/// What surrounds plants and is no mesh.
export interface PacketScene {
  sun: Vec; // unit vector to it
  lamps: { position: Vec; strength: number }[];
  supports: { name: string; points: ArrayPlace }[];
}

export interface PacketHead {
  packet: number;
  whole?: boolean;
  fit?: boolean;
  hash: string;
  draft?: boolean;
  share?: number; // of all triangles, that was asked of the meshes
  triangles: number;
  instances: number;
  of: { triangles: number; instances: number; nodes: number };
  bounds?: [Vec, Vec];
  scene?: PacketScene;
  pictures?: PacketPicture[];
  materials?: PacketMaterial[];
  meshes?: PacketMesh[];
  instances_of?: PacketInstances[];
  batches?: PacketBatch[];
  skeletons?: PacketSkeleton[];
  lines?: string[];
  gone?: {
    batches?: [string, number][];
    meshes?: string[];
    instances_of?: string[];
    pictures?: string[];
    skeletons?: string[];
    materials?: number;
  };
}

export interface Packet {
  head: PacketHead;
  buffer: ArrayBuffer;
  first: number; // byte of the first array
}

const kMagic = 0x3150534d; // MSP1
const kDecoder = new TextDecoder();

/// Throws where the bytes are no packet.
export function read_packet(buffer: ArrayBuffer): Packet {
  const view = new DataView(buffer);
  if (buffer.byteLength < 8 || view.getUint32(0, true) !== kMagic) throw new Error('these bytes are no scene packet');
  const length = view.getUint32(4, true);
  return { head: JSON.parse(kDecoder.decode(new Uint8Array(buffer, 8, length))) as PacketHead, buffer, first: 8 + length };
}

export const floats = (packet: Packet, [at, count]: ArrayPlace) => new Float32Array(packet.buffer, packet.first + at, count);
export const signed_bytes = (packet: Packet, [at, count]: ArrayPlace) => new Int8Array(packet.buffer, packet.first + at, count);
export const bytes = (packet: Packet, [at, count]: ArrayPlace) => new Uint8Array(packet.buffer, packet.first + at, count);
export const shorts = (packet: Packet, [at, count]: ArrayPlace) => new Uint16Array(packet.buffer, packet.first + at, count);
export const words = (packet: Packet, [at, count]: ArrayPlace) => new Uint32Array(packet.buffer, packet.first + at, count);
