// SPDX-License-Identifier: Apache-2.0
// Changes of a text as replaced pieces. Offsets count UTF-16 units, like strings and the server's messages.

export interface Splice {
  offset: number; // position in the text before the whole patch
  length: number;
  replacement: string;
}

/// Splices in rising order that do not overlap.
export type Patch = Splice[];

export function apply_patch(text: string, patch: Patch): string {
  let made = '';
  let at = 0;
  for (const { offset, length, replacement } of patch) {
    if (offset < at || offset + length > text.length) throw new RangeError('a patch does not fit its text');
    made += text.slice(at, offset) + replacement;
    at = offset + length;
  }
  return made + text.slice(at);
}

/// Returns the patch that turns the patched text back into `text`.
export function inverse_patch(text: string, patch: Patch): Patch {
  let shift = 0;
  return patch.map(({ offset, length, replacement }) => {
    const inverse = {
      offset: offset + shift,
      length: replacement.length,
      replacement: text.slice(offset, offset + length),
    };
    shift += replacement.length - length;
    return inverse;
  });
}

/// Returns one splice that turns `before` into `after`, or an empty patch if they are equal.
export function patch_between(before: string, after: string): Patch {
  if (before === after) return [];
  const shorter = Math.min(before.length, after.length);
  let head = 0;
  while (head < shorter && before[head] === after[head]) head += 1;
  let tail = 0;
  while (tail < shorter - head && before[before.length - 1 - tail] === after[after.length - 1 - tail]) tail += 1;
  // A pair of surrogates is one character, which a splice must not split.
  if (head > 0 && is_high(before.charCodeAt(head - 1))) head -= 1;
  if (
    tail > 0 &&
    is_high(before.charCodeAt(before.length - tail - 1)) &&
    is_low(before.charCodeAt(before.length - tail))
  )
    tail -= 1;
  return [{ offset: head, length: before.length - head - tail, replacement: after.slice(head, after.length - tail) }];
}

function is_high(unit: number): boolean {
  return unit >= 0xd800 && unit < 0xdc00;
}

function is_low(unit: number): boolean {
  return unit >= 0xdc00 && unit < 0xe000;
}

/// Returns `later` adjusted to the text after `first`; both were made for one text. Returns null if both change one
/// range.
export function rebased(first: Patch, later: Patch): Patch | null {
  const made: Patch = [];
  for (const splice of later) {
    let shift = 0;
    for (const { offset, length, replacement } of first) {
      if (offset + length <= splice.offset) shift += replacement.length - length;
      else if (offset < splice.offset + splice.length || offset === splice.offset) return null;
    }
    made.push({ ...splice, offset: splice.offset + shift });
  }
  return made;
}

/// The form in which the server sends splices.
export type PlainPatch = [number, number, string][];

export function plain_patch(patch: Patch): PlainPatch {
  return patch.map(({ offset, length, replacement }) => [offset, length, replacement]);
}

export function patch_of_plain(plain: PlainPatch): Patch {
  return plain.map(([offset, length, replacement]) => ({ offset, length, replacement }));
}

/// Returns one patch, and its inverse, for two successive patches. `undo` is the inverse of the first one; `text` is
/// the text between them, and `patch` the second one.
export function joined_patch(text: string, undo: Patch, patch: Patch): { patch: Patch; inverse: Patch } {
  const before = apply_patch(text, undo);
  const joined = patch_between(before, apply_patch(text, patch));
  return { patch: joined, inverse: inverse_patch(before, joined) };
}
