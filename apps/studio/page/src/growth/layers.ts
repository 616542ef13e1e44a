// SPDX-License-Identifier: Apache-2.0
// Overlays as the server tells them, made into layers of the view.
import type { Vec } from '../base/vec.ts';
import type { ToldLayer, ToldPlaces } from '../server/growth_protocol.ts';
import type { OverlayArrow, OverlayLayer } from '../view/overlays.ts';

export interface LegendKey {
  colour: [number, number, number]; // 0 to 1
  text: string;
}

const kPointSize = 5; // pixels
const kNodeSize = 3.5; // where lines join

export function view_layer(told: ToldLayer): OverlayLayer {
  const points = unpacked(told.points);
  const lines = unpacked(told.lines);
  return {
    points: { ...points, size: lines.positions.length > 0 ? kNodeSize : kPointSize },
    lines,
    arrows: arrows_of(unpacked(told.arrows)),
    labels: told.labels,
    is_in_front: true,
  };
}

/// Positions and colours, from base 64.
export function unpacked(places: ToldPlaces): { positions: Float32Array; colours: Uint8Array } {
  return { positions: floats_of(places.positions), colours: bytes_of(places.colours) };
}

export function floats_of(text: string): Float32Array {
  return new Float32Array(bytes_of(text).buffer);
}

function bytes_of(text: string): Uint8Array<ArrayBuffer> {
  return Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
}

function arrows_of({ positions, colours }: { positions: Float32Array; colours: Uint8Array }): OverlayArrow[] {
  const at = (numbers: ArrayLike<number>, first: number): Vec => [numbers[first] ?? 0, numbers[first + 1] ?? 0, numbers[first + 2] ?? 0];
  const arrows: OverlayArrow[] = [];
  for (let k = 0; 6 * k < positions.length; ++k) {
    arrows.push({ from: at(positions, 6 * k), to: at(positions, 6 * k + 3), colour: at(colours, 8 * k) });
  }
  return arrows;
}
