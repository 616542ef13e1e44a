// SPDX-License-Identifier: Apache-2.0
// Colours as documents write them, and as a person picks them: hue in degrees, saturation and value from 0 to 1.
import type { Json } from './json.ts';
import { is_object } from './json.ts';

export interface Hsv {
  hue: number;
  saturation: number;
  value: number;
}

const kLong = /^#[0-9a-f]{6}$/i;
const kShort = /^#([0-9a-f])([0-9a-f])([0-9a-f])$/i;

/// Returns a colour as "#rrggbb"; the short form is accepted. Returns null for other texts.
export function full_colour(text: string): string | null {
  const short = kShort.exec(text);
  if (short)
    return `#${short
      .slice(1)
      .map((one) => one + one)
      .join('')}`.toLowerCase();
  return kLong.test(text) ? text.toLowerCase() : null;
}

export function hsv_of(colour: string): Hsv {
  const full = full_colour(colour) ?? '#808080';
  const [red, green, blue] = [1, 3, 5].map((k) => parseInt(full.slice(k, k + 2), 16) / 255) as [number, number, number];
  const value = Math.max(red, green, blue);
  const range = value - Math.min(red, green, blue);
  if (range === 0) return { hue: 0, saturation: 0, value };
  const sixth =
    value === red ? (green - blue) / range : value === green ? 2 + (blue - red) / range : 4 + (red - green) / range;
  return { hue: (60 * sixth + 360) % 360, saturation: range / value, value };
}

export function colour_of({ hue, saturation, value }: Hsv): string {
  const channel = (shift: number): string => {
    const k = (shift + hue / 60) % 6;
    const light = value - value * saturation * Math.max(0, Math.min(k, 4 - k, 1));
    return Math.round(255 * light)
      .toString(16)
      .padStart(2, '0');
  };
  return `#${channel(5)}${channel(3)}${channel(1)}`;
}

/// Returns the colours in a document, each once, in their order.
export function colours_in(value: Json | undefined, max = 24): string[] {
  const found = new Set<string>();
  const look = (one: Json | undefined): void => {
    if (typeof one === 'string') {
      const colour = full_colour(one);
      if (colour !== null && found.size < max) found.add(colour);
    } else if (Array.isArray(one)) one.forEach(look);
    else if (is_object(one)) Object.values(one).forEach(look);
  };
  look(value);
  return [...found];
}
