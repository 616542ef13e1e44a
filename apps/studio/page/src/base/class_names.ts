// SPDX-License-Identifier: Apache-2.0

/// Returns the names of an element's classes as one text, without the false ones.
export function class_names(...names: readonly (string | false | undefined)[]): string {
  return names.filter((one) => one).join(' ');
}
