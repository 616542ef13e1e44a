// SPDX-License-Identifier: Apache-2.0

/// A position or a vector in the world, metres. North is -z, east +x, and y is up.
export type Vec = readonly [number, number, number];

/// Returns positions from a flat list with three numbers each.
export function places_of_numbers(numbers: readonly number[]): Vec[] {
  return Array.from({ length: Math.floor(numbers.length / 3) }, (_, k) => [
    numbers[3 * k] ?? 0,
    numbers[3 * k + 1] ?? 0,
    numbers[3 * k + 2] ?? 0,
  ]);
}
