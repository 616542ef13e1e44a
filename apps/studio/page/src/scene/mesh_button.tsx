// SPDX-License-Identifier: Apache-2.0
import type { ReactElement } from 'react';
import { useState } from 'react';

import { Button } from '../controls/button.tsx';
import { FileDialog } from '../editors/file_row.tsx';
import { use_page } from '../page/use_page.ts';
import type { Row } from '../tables/tables.ts';
import { table_of } from '../tables/tables.ts';

/// Returns the row of the obstacles' mesh, whose sentence names the accepted files.
function mesh_row(page: ReturnType<typeof use_page>): Row | undefined {
  const { tables } = page;
  const scene = table_of(
    tables,
    table_of(tables, tables.document).rows.find((row) => row.name === 'scene')?.table ?? '',
  );
  const obstacles = table_of(tables, scene.rows.find((row) => row.name === 'obstacles')?.table ?? '');
  return obstacles.rows.find((row) => row.name === 'mesh');
}

/// A button that chooses a file with a mesh.
export function MeshButton({ take }: { take: (file: string) => void }): ReactElement | null {
  const page = use_page();
  const [is_open, set_open] = useState(false);
  const row = mesh_row(page);
  if (!row) return null;
  return (
    <>
      <Button icon="plus" tip="An obstacle from a file" press={() => set_open(true)}>
        Mesh…
      </Button>
      {is_open && <FileDialog label="mesh" row={row} value={undefined} take={take} close={() => set_open(false)} />}
    </>
  );
}
