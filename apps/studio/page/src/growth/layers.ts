// SPDX-License-Identifier: Apache-2.0
// Converts overlays from the server into layers of the view.
import type { Vec } from '../base/vec.ts';
import type { PacketArrays } from '../server/packet.ts';
import { bytes, floats } from '../server/packet.ts';
import type { ColouredPoints, PackedLayer } from '../server/protocol.ts';
import type { OverlayArrow, OverlayLayer } from '../view/overlays.ts';

export interface LegendKey {
  colour: [number, number, number]; // 0 to 1
  text: string;
}

interface Places {
  positions: Float32Array; // position of the array in the answer
  colours: Uint8Array;
}

const kPointSize = 5; // pixels
const kNodeSize = 3.5; // nodes where lines join

export function view_layer(packed: PackedLayer, arrays: PacketArrays): OverlayLayer {
  const places = ({ positions, colours }: ColouredPoints): Places => ({
    positions: floats(arrays, positions),
    colours: bytes(arrays, colours),
  });
  const lines = places(packed.lines);
  return {
    points: { ...places(packed.points), size: lines.positions.length > 0 ? kNodeSize : kPointSize },
    lines,
    arrows: arrows_of(places(packed.arrows)),
    labels: packed.labels,
    is_in_front: true,
  };
}

function arrows_of({ positions, colours }: Places): OverlayArrow[] {
  const at = (numbers: ArrayLike<number>, first: number): Vec => [
    numbers[first] ?? 0,
    numbers[first + 1] ?? 0,
    numbers[first + 2] ?? 0,
  ];
  const arrows: OverlayArrow[] = [];
  for (let k = 0; 6 * k < positions.length; ++k) {
    arrows.push({ from: at(positions, 6 * k), to: at(positions, 6 * k + 3), colour: at(colours, 8 * k) });
  }
  return arrows;
}
