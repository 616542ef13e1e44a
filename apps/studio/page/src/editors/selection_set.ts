// SPDX-License-Identifier: Apache-2.0
// The instances that a selection names by number or range, and the shortest way to write them. Conditions are evaluated
// by the library and are not changed.
import type { Json } from '../values/json.ts';

export function is_condition(entry: Json): boolean {
  return typeof entry === 'string';
}

/// Returns the numbers below `count` that entries name.
export function named_numbers(entries: readonly Json[], count: number): Set<number> {
  const named = new Set<number>();
  for (const entry of entries) {
    if (typeof entry === 'number') named.add(entry);
    if (!Array.isArray(entry) || typeof entry[0] !== 'number' || typeof entry[1] !== 'number') continue;
    for (let k = Math.max(0, entry[0]); k <= Math.min(entry[1], count - 1); k += 1) named.add(k);
  }
  return named;
}

/// Returns entries for these numbers, with ranges for three or more in a row. Conditions come last, in their order.
export function entries_of(numbers: ReadonlySet<number>, entries: readonly Json[], count: number): Json[] {
  const made: Json[] = [];
  const sorted = [...numbers].sort((a, b) => a - b);
  for (let k = 0; k < sorted.length; ) {
    const first = sorted[k] ?? 0;
    let last = first;
    while (sorted[k + 1] === last + 1) [last, k] = [last + 1, k + 1];
    k += 1;
    if (last - first >= 2) made.push([first, last]);
    else for (let one = first; one <= last; one += 1) made.push(one);
  }
  // Entries beyond the last existing instance are kept.
  const beyond = entries.filter((entry) => Array.isArray(entry) && typeof entry[0] === 'number' && entry[0] >= count);
  return [...made, ...beyond, ...entries.filter(is_condition)];
}

/// Returns the smallest number of cells that shows everything that entries name.
export function count_named(entries: readonly Json[]): number {
  let count = 0;
  for (const entry of entries) {
    const last = Array.isArray(entry) ? entry[1] : entry;
    if (typeof last === 'number') count = Math.max(count, last + 1);
  }
  return count;
}
