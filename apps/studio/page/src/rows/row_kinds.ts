// SPDX-License-Identifier: Apache-2.0
// The registry of row kinds: which editor a row has. Rows and editors share it and do not import each other; the entry
// of the page fills it.
import type { ReactElement } from 'react';
import { createContext, useContext } from 'react';

import type { Row } from '../tables/tables.ts';
import type { Json } from '../values/json.ts';
import type { RowActions } from './row_actions.ts';

/// Size of an editor: in a row of the inspector, or large below the view.
export type EditorSize = 'row' | 'large';

export interface RowEditorProps {
  row: Row;
  label: string;
  path: string;
  value: Json | undefined;
  actions: RowActions;
  is_faulty: boolean;
  size?: EditorSize; // missing: as in a row
}

export interface NestedRowProps {
  row: Row;
  path: string;
  value: Json | undefined;
  rivals: readonly string[]; // paths that are removed when anything of the row is given
}

export interface RowKind {
  editor: (props: RowEditorProps) => ReactElement;
  is_tall?: boolean; // true: needs the whole width of the panel
  can_be_large?: (row: Row) => boolean; // returns true if the row has a large editor
}

/// Kinds of rows, by the name of the kind in the tables. Rows of other kinds are edited as text.
export interface RowKinds {
  editors: Readonly<Record<string, RowKind>>;
  nested: Readonly<Record<string, (props: NestedRowProps) => ReactElement>>; // kinds of rows that hold tables
}

export const RowKindsContext = createContext<RowKinds>({ editors: {}, nested: {} });

export function use_row_kinds(): RowKinds {
  return useContext(RowKindsContext);
}
