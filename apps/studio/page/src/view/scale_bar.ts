// SPDX-License-Identifier: Apache-2.0
// A scale bar for 1, 2 or 5 times a power of ten metres, 60 to 160 pixels long.

export function scale_bar(metres_per_pixel: number): { pixels: number; text: string } {
  const longest = 150 * metres_per_pixel;
  const power = 10 ** Math.floor(Math.log10(longest));
  const share = longest / power;
  const metres = power * (share >= 5 ? 5 : share >= 2 ? 2 : 1);
  return { pixels: Math.round(metres / metres_per_pixel), text: length_text(metres) };
}

export function length_text(metres: number): string {
  if (metres < 0.00995) return `${Number((metres * 1000).toPrecision(3))} mm`;
  if (metres < 0.995) return `${Number((metres * 100).toPrecision(3))} cm`;
  return metres < 995 ? `${Number(metres.toPrecision(3))} m` : `${Number((metres / 1000).toPrecision(3))} km`;
}
