// SPDX-License-Identifier: Apache-2.0
// The large editor below the view, so that the plant stays visible during edits.
import type { ReactElement } from 'react';
import { useEffect } from 'react';

import { use_store } from '../base/store.ts';
import { IconButton } from '../controls/button.tsx';
import { Faults } from '../controls/faults.tsx';
import { use_document, use_page } from '../page/use_page.ts';
import { excluded_by } from '../rows/exclusion.ts';
import { use_faults, use_row_actions, use_shown_value } from '../rows/row_actions.ts';
import { use_row_kinds } from '../rows/row_kinds.ts';
import { groups_at, rows_at } from '../tables/resolve.ts';
import type { Row } from '../tables/tables.ts';
import { path_below, path_of, steps_of, value_at } from '../values/path.ts';

export function Drawer(): ReactElement | null {
  const page = use_page();
  const path = use_store(page.enlarged);
  const { tree } = use_document();
  const parent = path === null ? '' : path_of(steps_of(path).slice(0, -1));
  const name = path === null ? undefined : steps_of(path).at(-1);
  const row = path === null ? undefined : rows_at(page.tables, tree, parent).find((one) => one.name === name);
  const is_gone = path !== null && (!row || value_at(tree, parent) === undefined);
  useEffect(() => {
    if (is_gone) page.enlarged.set(null);
  }, [page, is_gone]);
  if (path === null || !row || is_gone) return null;
  return <LargeEditor key={path} path={path} parent={parent} row={row} close={() => page.enlarged.set(null)} />;
}

interface LargeEditorProps {
  path: string;
  parent: string;
  row: Row;
  close: () => void;
}

function LargeEditor({ path, parent, row, close }: LargeEditorProps): ReactElement | null {
  const page = use_page();
  const { tree } = use_document();
  const around = value_at(tree, parent);
  const table = groups_at(page.tables, tree, parent).find((group) => group.rows.includes(row))?.table;
  const rivals = table ? excluded_by(table, row.name, around).map((name) => path_below(parent, name)) : [];
  const actions = use_row_actions(path, row.name, rivals);
  const value = use_shown_value(path, value_at(tree, path));
  const faults = use_faults(path, true);
  const label = row.name.replaceAll('_', ' ');
  const Editor = use_row_kinds().editors[row.kind]?.editor;
  if (!Editor) return null;
  return (
    <section
      className="drawer"
      aria-label={`${label}, large`}
      onKeyDown={(event) => {
        if (event.key === 'Escape') close();
      }}
    >
      <header>
        <h2>
          {label} <span className="quiet">of {title_of(parent)}</span>
        </h2>
        <p className="quiet">{row.doc}</p>
        <IconButton icon="close" label={`Close the large ${label}`} press={close} />
      </header>
      <div className="drawer-body" data-path={path}>
        <Editor
          row={row}
          label={label}
          path={path}
          value={value}
          actions={actions}
          is_faulty={faults.some((fault) => fault.severity === 'error')}
          size="large"
        />
        <Faults faults={faults} />
      </div>
    </section>
  );
}

function title_of(path: string): string {
  return path === ''
    ? 'the document'
    : steps_of(path)
        .filter((one) => one !== 'components')
        .join(' ');
}
