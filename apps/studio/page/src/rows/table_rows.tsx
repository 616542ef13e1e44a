// SPDX-License-Identifier: Apache-2.0
// The rows of one table.
import type { ReactElement } from 'react';

import type { ParameterTable } from '../tables/tables.ts';
import { as_object, has_meaning } from '../tables/tables.ts';
import type { Json } from '../values/json.ts';
import { RowView } from './row_editor.tsx';

interface TableRowsProps {
  table: ParameterTable;
  path: string;
  value: Json | undefined;
  without?: string; // name of a row that is edited elsewhere
}

/// All rows of a table that have an effect beside the other values.
export function TableRows({ table, path, value, without }: TableRowsProps): ReactElement {
  const object = as_object(table, value);
  const rows = table.rows.filter(
    (row) => row.name !== without && (object[row.name] !== undefined || has_meaning(table, row.name, object)),
  );
  return (
    <>
      {rows.map((row) => (
        <RowView key={row.name} table={table} row={row} parent={path} parent_value={value} value={object[row.name]} />
      ))}
    </>
  );
}
