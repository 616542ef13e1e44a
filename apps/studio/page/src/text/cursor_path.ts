// SPDX-License-Identifier: Apache-2.0
// Finds the path at the cursor. The text is read from the beginning, bracket by bracket, because it may be incomplete
// JSON.
import type { PathStep } from '../values/path.ts';

export interface CursorPosition {
  steps: PathStep[]; // steps to the object or list around the cursor
  is_list: boolean;
  name: string | null; // name of the member whose value is being written; null if a name is expected
  given: string[]; // members before the cursor in that object
  word_start: number; // beginning of the word under the cursor, including its quote
}

interface Level {
  is_list: boolean;
  name: string | null;
  index: number;
  given: string[];
}

const kTokens = /\/\/[^\n]*|\/\*[^]*?(?:\*\/|$)|"(?:[^"\\\n]|\\.)*"?|[{}[\],:]|[^\s{}[\],:"/]+|\//g;

export function cursor_position(text: string, offset: number): CursorPosition {
  const levels: Level[] = [];
  let last_text: string | null = null;
  let word_start = offset;
  for (const found of text.slice(0, offset).matchAll(kTokens)) {
    const token = found[0];
    const end = found.index + token.length;
    if (token.startsWith('//') || token.startsWith('/*')) continue;
    word_start = end === offset && !/^[{}[\],:]$/.test(token) ? found.index : offset;
    const level = levels.at(-1);
    if (token === '{' || token === '[') {
      levels.push({ is_list: token === '[', name: null, index: 0, given: [] });
    } else if (token === '}' || token === ']') {
      levels.pop();
    } else if (token === ':' && level && last_text !== null) {
      level.name = last_text;
      level.given.push(last_text);
    } else if (token === ',' && level) {
      level.name = null;
      level.index += 1;
    }
    last_text = token.startsWith('"') && end < offset ? token.slice(1, -1) : null;
  }
  const steps = levels.slice(0, -1).map((level) => (level.is_list ? level.index : (level.name ?? '')));
  const inner = levels.at(-1);
  return { steps, is_list: inner?.is_list ?? false, name: inner?.name ?? null, given: inner?.given ?? [], word_start };
}
