// SPDX-License-Identifier: Apache-2.0
// Packets: a head in JSON, and arrays that are used in place. A scene packet shows a plant. An answer with arrays is
// also sent as a packet.
import type { PacketHead } from './types/packets.ts';

export type * from './types/packets.ts';

/// Position of the first byte, counted from the first array, and number of elements.
export type ArrayPlace = [number, number];

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
