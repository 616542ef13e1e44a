// SPDX-License-Identifier: Apache-2.0

/// A place in the world or a way through it, metres. North is -z, east +x, and y is up.
export type Vec = readonly [number, number, number];

/// Three numbers for each place, one after another.
export function places_of_numbers(numbers: readonly number[]): Vec[] {
  return Array.from({ length: Math.floor(numbers.length / 3) }, (_, k) => [numbers[3 * k] ?? 0, numbers[3 * k + 1] ?? 0, numbers[3 * k + 2] ?? 0]);
}
