// SPDX-License-Identifier: Apache-2.0
// A text that a document holds as a string or as a list of lines: its content, the positions of its characters in the
// document, and its replacement. Comments and layout around unchanged lines are kept.
import type { JsonNode } from '../values/json.ts';

/// Returns the text of a value, or null if it is neither a text nor a list of texts.
export function text_in(node: JsonNode | null): string | null {
  if (typeof node?.value === 'string') return node.value;
  if (!node?.elements) return null;
  const lines = node.elements.map((one) => one.value);
  return lines.every((one): one is string => typeof one === 'string') ? lines.join('\n') : null;
}

/// Returns the document with the node's text replaced.
export function with_text(document: string, node: JsonNode, text: string): string {
  const elements = node.elements;
  if (!elements) return document.slice(0, node.start) + JSON.stringify(text) + document.slice(node.end);
  // An element may hold several lines, so elements are compared with as many lines as they have.
  const before = elements.map((one) => String(one.value));
  const after = text.split('\n');
  let head = 0;
  let head_lines = 0;
  for (; head < before.length; head += 1) {
    const lines = (before[head] ?? '').split('\n');
    if (!lines.every((line, k) => after[head_lines + k] === line)) break;
    head_lines += lines.length;
  }
  let tail = 0;
  let tail_lines = 0;
  for (; tail < before.length - head; tail += 1) {
    const lines = (before[before.length - 1 - tail] ?? '').split('\n');
    const first = after.length - tail_lines - lines.length;
    if (first < head_lines || !lines.every((line, k) => after[first + k] === line)) break;
    tail_lines += lines.length;
  }
  const made = after.slice(head_lines, after.length - tail_lines).map((line) => JSON.stringify(line));
  return put_elements(document, node, elements, head, before.length - tail, made);
}

/// Replaces the elements from `first` up to `end` by `made`.
function put_elements(
  document: string,
  node: JsonNode,
  elements: JsonNode[],
  first: number,
  end: number,
  made: string[],
): string {
  const put = (from: number, to: number, text: string): string => document.slice(0, from) + text + document.slice(to);
  const between = separator(document, node, elements);
  const joined = made.join(between);
  const [begin, behind, last] = [elements[first], elements[end], elements[end - 1]];
  if (elements.length === 0) return put(node.start, node.end, `[${joined}]`);
  if (end > first && begin && last) {
    if (made.length > 0) return put(begin.start, last.end, joined);
    if (behind) return put(begin.start, behind.start, '');
    const kept = elements[first - 1];
    return kept ? put(kept.end, last.end, '') : put(node.start, node.end, '[]');
  }
  if (made.length === 0) return document;
  if (begin) return put(begin.start, begin.start, joined + between);
  const kept = elements[first - 1];
  return kept ? put(kept.end, kept.end, between + joined) : put(node.start, node.end, `[${joined}]`);
}

/// Returns the text between two elements of the list.
function separator(document: string, node: JsonNode, elements: JsonNode[]): string {
  for (let k = 0; k + 1 < elements.length; k += 1) {
    const between = document.slice(elements[k]?.end ?? 0, elements[k + 1]?.start ?? 0);
    if (/^\s*,\s*$/.test(between)) return between;
  }
  const [first] = elements;
  const lead = first ? document.slice(node.start + 1, first.start) : '';
  return /^\s*\n\s*$/.test(lead) ? `,${lead}` : ', ';
}

/// Returns the position in the text of an offset in the document, or null outside of the text.
export function offset_in_text(document: string, node: JsonNode, offset: number): number | null {
  let lines_before = 0;
  for (const element of node.elements ?? [node]) {
    if (offset >= element.start && offset <= element.end)
      return lines_before + characters_before(document.slice(element.start, offset));
    lines_before += String(element.value).length + 1;
  }
  return null;
}

const kPiece = /\\u[0-9a-fA-F]{4}|\\.|[^]/y;

/// Returns the number of characters in a piece of a string, whose first character is the quote.
function characters_before(piece: string): number {
  let count = 0;
  kPiece.lastIndex = 1;
  while (kPiece.lastIndex < piece.length && kPiece.exec(piece)) count += 1;
  return count;
}
