// SPDX-License-Identifier: Apache-2.0
// A value over time, given by keys and computed as in the library. It is used only for drawing; the server grows by its
// own.
//
// Based on: F. N. Fritsch, J. Butland: A method for constructing local monotone piecewise cubic interpolants (1984),
// for smooth keys.

import { full_colour } from '../values/colour.ts';
import type { Json } from '../values/json.ts';

export type Way = 'linear' | 'smooth' | 'step';
export const kWays: readonly Way[] = ['linear', 'smooth', 'step'];

export interface Key {
  time: number; // seconds
  value: Json;
  way: Way | null; // interpolation from the previous key; null: not given in the text
}

interface NumberKey {
  time: number;
  value: number;
  way: Way;
}

/// Returns the keys as numbers by `part`, or null if a value is no number there.
function numbers_of(keys: readonly Key[], part: (value: Json) => number | null): NumberKey[] | null {
  const made = keys.map(({ time, value, way }) => ({ time, value: part(value), way: way ?? 'linear' }));
  return made.every((one): one is NumberKey => one.value !== null) ? made : null;
}

/// Returns the slope at a key between two segments: the weighted harmonic mean of their slopes, or 0 if the values
/// turn.
function middle_slope(before: number, after: number, length_before: number, length_after: number): number {
  if (before * after <= 0) return 0;
  const [one, other] = [2 * length_after + length_before, length_after + 2 * length_before];
  return (one + other) / (one / before + other / after);
}

function slope_at(keys: readonly NumberKey[], k: number): number {
  const [before, at, after] = [keys[k - 1], keys[k], keys[k + 1]];
  if (!before || !at || !after || at.way === 'step' || after.way === 'step') return 0;
  const [first, second] = [at.time - before.time, after.time - at.time];
  return middle_slope((at.value - before.value) / first, (after.value - at.value) / second, first, second);
}

/// Returns the number at a time. Before the first key and after the last key it is constant.
export function number_at(keys: readonly NumberKey[], time: number): number {
  const [first, last] = [keys[0], keys.at(-1)];
  if (!first || !last) return 0;
  if (time >= last.time) return last.value;
  if (!(time > first.time)) return first.value;
  const next = keys.findIndex((one) => one.time > time);
  const [from, to] = [keys[next - 1] ?? first, keys[next] ?? last];
  if (to.way === 'step') return from.value;
  const length = to.time - from.time;
  const u = (time - from.time) / length;
  const rise = to.value - from.value;
  if (to.way === 'linear') return from.value + u * rise;
  const bent = u * (1 - u) * ((1 - u) * slope_at(keys, next - 1) - u * slope_at(keys, next)) * length;
  const value = from.value + u * u * (3 - 2 * u) * rise + bent;
  return Math.min(Math.max(from.value, to.value), Math.max(Math.min(from.value, to.value), value));
}

const as_number = (value: Json): number | null => (typeof value === 'number' ? value : null);
const elements_of = (keys: readonly Key[], k: number): Key[] =>
  keys.map((key) => ({ ...key, value: Array.isArray(key.value) ? (key.value[k] ?? null) : null }));
const channel =
  (k: number) =>
  (value: Json): number | null => {
    const colour = typeof value === 'string' ? full_colour(value) : null;
    return colour === null ? null : parseInt(colour.slice(1 + 2 * k, 3 + 2 * k), 16);
  };

/// Returns the value at a time. A value without interpolation is the value of the last key so far.
export function value_at_time(keys: readonly Key[], time: number): Json {
  const plain = numbers_of(keys, as_number);
  if (plain) return tidy(number_at(plain, time));
  const first = keys[0]?.value ?? null;
  if (Array.isArray(first) && keys.every(({ value }) => Array.isArray(value) && value.length === first.length)) {
    return first.map((_, k) => value_at_time(elements_of(keys, k), time));
  }
  const channels = [0, 1, 2].map((k) => numbers_of(keys, channel(k)));
  if (channels.every((one) => one !== null)) {
    return `#${channels
      .map((one) =>
        Math.floor(number_at(one, time) + 0.5)
          .toString(16)
          .padStart(2, '0'),
      )
      .join('')}`;
  }
  return keys.reduce<Json>((last, one) => (one.time <= time ? one.value : last), first);
}

/// Returns true if values can be interpolated: numbers, lists of numbers, colours.
export function has_values_between(keys: readonly Key[]): boolean {
  return keys.every(
    ({ value }) =>
      typeof value === 'number' || Array.isArray(value) || (typeof value === 'string' && full_colour(value) !== null),
  );
}

/// Returns points of the curve of numeric keys up to `end`, or null if the values are no plain numbers.
export function curve_of(keys: readonly Key[], end: number, count = 160): [number, number][] | null {
  const plain = numbers_of(keys, as_number);
  if (!plain) return null;
  const times = Array.from({ length: count + 1 }, (_, k) => (end * k) / count);
  // Jumps get a point on both sides.
  for (const { time } of plain) times.push(time - 1e-9, time);
  return times
    .filter((one) => one >= 0)
    .sort((a, b) => a - b)
    .map((time) => [time, number_at(plain, time)]);
}

function tidy(value: number): number {
  return Number(value.toPrecision(6));
}
