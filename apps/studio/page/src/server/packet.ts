// SPDX-License-Identifier: Apache-2.0
// Packets: a head in JSON, and arrays that are used in place. A scene packet shows a plant. An answer with arrays is
// also sent as a packet.
import type { Vec } from '../base/vec.ts';

/// Position of the first byte, counted from the first array, and number of elements.
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

/// Parts of the scene other than meshes.
export interface PacketScene {
  sun: Vec; // unit vector to the sun
  lamps: { position: Vec; strength: number }[];
  supports: { name: string; points: ArrayPlace }[];
}

export interface PacketHead {
  packet: number;
  whole?: boolean;
  fit?: boolean;
  hash: string;
  draft?: boolean;
  share?: number; // share of all triangles that was requested
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

/// The buffer and the position of its arrays.
export interface PacketArrays {
  buffer: ArrayBuffer;
  first: number; // byte of the first array
}

export interface Packet extends PacketArrays {
  head: PacketHead;
}

const kScene = 0x3150534d; // MSP1
const kAnswer = 0x3141534d; // MSA1
const kDecoder = new TextDecoder();

const letters_of = (buffer: ArrayBuffer): number =>
  buffer.byteLength < 8 ? 0 : new DataView(buffer).getUint32(0, true);

/// Returns true if the bytes are the answer to a request.
export const is_answer = (buffer: ArrayBuffer): boolean => letters_of(buffer) === kAnswer;

/// Reads a scene packet. Throws an error for other bytes.
export function read_packet(buffer: ArrayBuffer): Packet {
  if (letters_of(buffer) !== kScene) throw new Error('these bytes are no scene packet');
  return read_packed<PacketHead>(buffer);
}

/// Reads a packet of any kind.
export function read_packed<Head>(buffer: ArrayBuffer): PacketArrays & { head: Head } {
  const length = new DataView(buffer).getUint32(4, true);
  return { head: JSON.parse(kDecoder.decode(new Uint8Array(buffer, 8, length))) as Head, buffer, first: 8 + length };
}

export const floats = (arrays: PacketArrays, [at, count]: ArrayPlace) =>
  new Float32Array(arrays.buffer, arrays.first + at, count);
export const signed_bytes = (arrays: PacketArrays, [at, count]: ArrayPlace) =>
  new Int8Array(arrays.buffer, arrays.first + at, count);
export const bytes = (arrays: PacketArrays, [at, count]: ArrayPlace) =>
  new Uint8Array(arrays.buffer, arrays.first + at, count);
export const shorts = (arrays: PacketArrays, [at, count]: ArrayPlace) =>
  new Uint16Array(arrays.buffer, arrays.first + at, count);
export const words = (arrays: PacketArrays, [at, count]: ArrayPlace) =>
  new Uint32Array(arrays.buffer, arrays.first + at, count);
