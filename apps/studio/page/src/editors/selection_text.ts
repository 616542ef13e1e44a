// SPDX-License-Identifier: Apache-2.0
// An entry of a selection as the user types it: 7, 3 to 5, or a condition such as i % 10 == 9.
import type { Json } from '../values/json.ts';
import { write_json } from '../values/json.ts';

export function entry_text(entry: Json): string {
  if (Array.isArray(entry) && entry.length === 2) return `${String(entry[0])} to ${String(entry[1])}`;
  return typeof entry === 'string' ? entry : write_json(entry);
}

/// Returns the document's form of a typed entry. Texts other than numbers and ranges are conditions. Returns null for
/// an empty text.
export function entry_of(typed: string): Json | null {
  const text = typed.trim();
  if (text === '') return null;
  if (/^\d+$/.test(text)) return instance(text);
  const range = /^(\d+)\s*(?:to|\.\.\.?|-|–)\s*(\d+)$/.exec(text);
  if (!range) return text;
  const [first, last] = [instance(range[1]), instance(range[2])];
  return [Math.min(first, last), Math.max(first, last)];
}

const kLastInstance = 2 ** 32 - 1;

function instance(text = ''): number {
  return Math.min(kLastInstance, Number(text));
}
