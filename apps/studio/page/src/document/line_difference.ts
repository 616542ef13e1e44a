// SPDX-License-Identifier: Apache-2.0
// The differences between two texts line by line, for a user who must choose between them.

export interface DifferentLine {
  sign: '+' | '-' | ' ';
  text: string;
}

const kMaxCells = 4e6;

/// Returns only the differing lines, with one line of context. Uses the longest common subsequence between equal
/// beginning and end.
export function line_difference(before: string, after: string): DifferentLine[] {
  const [a, b] = [before.split(/\r?\n/), after.split(/\r?\n/)];
  let head = 0;
  while (head < a.length && head < b.length && a[head] === b[head]) head += 1;
  let tail = 0;
  while (tail < a.length - head && tail < b.length - head && a[a.length - 1 - tail] === b[b.length - 1 - tail])
    tail += 1;
  const lines = middle(a.slice(head, a.length - tail), b.slice(head, b.length - tail));
  const context = (text: string | undefined): DifferentLine[] => (text === undefined ? [] : [{ sign: ' ', text }]);
  if (lines.length === 0) return [];
  return [...context(a[head - 1]), ...lines, ...context(a[a.length - tail])];
}

function middle(a: string[], b: string[]): DifferentLine[] {
  const minus = (text: string): DifferentLine => ({ sign: '-', text });
  const plus = (text: string): DifferentLine => ({ sign: '+', text });
  if (a.length * b.length > kMaxCells) return [...a.map(minus), ...b.map(plus)];
  const width = b.length + 1;
  const common = new Uint32Array((a.length + 1) * width);
  const at = (i: number, j: number): number => common[i * width + j] ?? 0;
  for (let i = a.length - 1; i >= 0; i -= 1) {
    for (let j = b.length - 1; j >= 0; j -= 1) {
      common[i * width + j] = a[i] === b[j] ? at(i + 1, j + 1) + 1 : Math.max(at(i + 1, j), at(i, j + 1));
    }
  }
  const lines: DifferentLine[] = [];
  let [i, j] = [0, 0];
  while (i < a.length || j < b.length) {
    if (i < a.length && j < b.length && a[i] === b[j]) {
      lines.push({ sign: ' ', text: a[i] as string });
      i += 1;
      j += 1;
    } else if (j >= b.length || (i < a.length && at(i + 1, j) >= at(i, j + 1))) {
      lines.push(minus(a[i++] as string));
    } else {
      lines.push(plus(b[j++] as string));
    }
  }
  return lines;
}
