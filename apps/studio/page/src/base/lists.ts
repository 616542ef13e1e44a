// SPDX-License-Identifier: Apache-2.0
// Copies of lists with one element moved, added or removed.

/// Returns the list with the element at `from` moved to `to`.
export function moved<T>(list: readonly T[], from: number, to: number): T[] {
  const made = [...list];
  const [one] = made.splice(from, 1);
  if (one !== undefined) made.splice(Math.min(made.length, Math.max(0, to)), 0, one);
  return made;
}

export function without<T>(list: readonly T[], index: number): T[] {
  return list.filter((_, k) => k !== index);
}

/// Returns the list with one more element after the element at `index`.
export function with_behind<T>(list: readonly T[], index: number, one: T): T[] {
  return [...list.slice(0, index + 1), one, ...list.slice(index + 1)];
}
