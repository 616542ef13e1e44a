// SPDX-License-Identifier: Apache-2.0
// Rows that exclude each other: when one is given, the others are removed.
import { createContext } from 'react';
import type { ParameterTable } from '../tables/tables.ts';
import { as_object } from '../tables/tables.ts';
import type { Json } from '../values/json.ts';

/// Returns the given rows of a table that must be removed when this one is given.
export function excluded_by(table: ParameterTable, name: string, value: Json | undefined): string[] {
  const given = as_object(table, value);
  const rivals = new Set<string>();
  for (const group of table.one_of ?? []) if (group.includes(name)) for (const one of group) rivals.add(one);
  for (const [one, other] of table.never_with ?? []) {
    if (one === name) rivals.add(other);
    if (other === name) rivals.add(one);
  }
  rivals.delete(name);
  return [...rivals].filter((one) => given[one] !== undefined);
}

/// Paths that are removed when anything below is given: rivals in the enclosing tables.
export const ExcludedPaths = createContext<readonly string[]>([]);
