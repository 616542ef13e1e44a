// SPDX-License-Identifier: Apache-2.0

/// Returns typed text with the line ends of the document.
export function with_line_ends(typed: string, text: string): string {
  const ends_in_two = text.includes('\r\n') && !/(^|[^\r])\n/.test(text);
  return ends_in_two ? typed.replace(/\r?\n/g, '\r\n') : typed;
}
