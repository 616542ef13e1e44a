// SPDX-License-Identifier: Apache-2.0
// Parts of a scene other than meshes: poles and wires as lines, lamps as points.
import type { Packet, PacketScene } from '../server/packet.ts';
import { floats } from '../server/packet.ts';
import type { Overlays } from './overlays.ts';

const kWire = { light: [90, 74, 58, 255], dark: [203, 184, 159, 255] };
const kLamp = { light: [208, 138, 0, 255], dark: [255, 201, 77, 255] };
const kLampSize = 9; // pixels
const kLayer = 'scene';

export class Surroundings {
  private said_: PacketScene | null = null;
  private wires_ = new Float32Array(); // six numbers for each piece
  private shade_: 'light' | 'dark' = 'light';

  constructor(private readonly overlays_: Overlays) {}

  /// The scene of the last packet that has one; null before.
  get said(): PacketScene | null {
    return this.said_;
  }

  apply(packet: Packet): void {
    const { scene, whole } = packet.head;
    if (!scene && !whole) return;
    this.said_ = scene ?? null;
    this.wires_ = new Float32Array((scene?.supports ?? []).flatMap(({ points }) => pieces_of(floats(packet, points))));
    this.draw();
  }

  clear(): void {
    this.said_ = null;
    this.wires_ = new Float32Array();
    this.draw();
  }

  paint(is_dark: boolean): void {
    const shade = is_dark ? 'dark' : 'light';
    if (shade === this.shade_) return;
    this.shade_ = shade;
    this.draw();
  }

  private draw(): void {
    const lamps = new Float32Array((this.said_?.lamps ?? []).flatMap(({ position }) => position));
    const is_empty = lamps.length === 0 && this.wires_.length === 0;
    if (is_empty && !this.overlays_.has(kLayer)) return;
    this.overlays_.put(
      kLayer,
      is_empty
        ? null
        : {
            points: { positions: lamps, colours: repeated(kLamp[this.shade_], lamps.length / 3), size: kLampSize },
            lines: { positions: this.wires_, colours: repeated(kWire[this.shade_], this.wires_.length / 3) },
          },
    );
  }
}

/// Returns the pieces between the points of a line.
function pieces_of(line: Float32Array): number[] {
  const pieces: number[] = [];
  for (let k = 3; k < line.length; k += 3) pieces.push(...line.subarray(k - 3, k + 3));
  return pieces;
}

function repeated(colour: readonly number[], count: number): Uint8Array {
  return new Uint8Array(Array.from({ length: count }, () => colour).flat());
}
