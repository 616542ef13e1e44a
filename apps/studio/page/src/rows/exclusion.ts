// SPDX-License-Identifier: Apache-2.0
// Rows that never stand beside each other: where one is given, the others go.
import { createContext } from 'react';

import type { Json } from '../document/json.ts';
import type { ParameterTable } from '../tables/tables.ts';
import { as_object } from '../tables/tables.ts';

/// Those of a table's given rows that must go where this one is given.
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

/// Paths that go where anything below is given: rivals of the tables around it.
export const ExcludedPaths = createContext<readonly string[]>([]);
