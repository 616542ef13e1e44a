// SPDX-License-Identifier: Apache-2.0
// Lists of which one element is moved, put in or taken out.

/// With the element at `from` standing at `to`.
export function moved<T>(list: readonly T[], from: number, to: number): T[] {
  const made = [...list];
  const [one] = made.splice(from, 1);
  if (one !== undefined) made.splice(Math.min(made.length, Math.max(0, to)), 0, one);
  return made;
}

export function without<T>(list: readonly T[], index: number): T[] {
  return list.filter((_, k) => k !== index);
}

/// With one more behind the element at `index`.
export function with_behind<T>(list: readonly T[], index: number, one: T): T[] {
  return [...list.slice(0, index + 1), one, ...list.slice(index + 1)];
}
