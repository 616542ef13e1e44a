// SPDX-License-Identifier: Apache-2.0
// The hash that page and server compare to find out whether their texts are equal. It equals the server's text_hash.

const hexadecimal = (n: number): string => (n >>> 0).toString(16).padStart(8, '0');

/// Returns 16 hexadecimal digits.
export function text_hash(text: string): string {
  let a = 0xdeadbeef;
  let b = 0x41c6ce57;
  for (let k = 0; k < text.length; k += 1) {
    const unit = text.charCodeAt(k);
    a = Math.imul(a ^ unit, 2654435761);
    b = Math.imul(b ^ unit, 1597334677);
  }
  a = Math.imul(a ^ (a >>> 16), 2246822507) ^ Math.imul(b ^ (b >>> 13), 3266489909);
  b = Math.imul(b ^ (b >>> 16), 2246822507) ^ Math.imul(a ^ (a >>> 13), 3266489909);
  return hexadecimal(b) + hexadecimal(a);
}
