// SPDX-License-Identifier: Apache-2.0
// Rows that hold tables: objects, lists and maps. They are folded until the user opens them.
import type { ReactElement } from 'react';
import { useContext, useState } from 'react';

import { IconButton } from '../controls/button.tsx';
import { Menu } from '../controls/menu.tsx';
import { use_page } from '../page/use_page.ts';
import type { ParameterTable, Row } from '../tables/tables.ts';
import { first_object, table_of } from '../tables/tables.ts';
import { give } from '../time/values_now.ts';
import type { Json } from '../values/json.ts';
import { is_object } from '../values/json.ts';
import { member_of, path_below } from '../values/path.ts';
import { ExcludedPaths } from './exclusion.ts';
import { Fold } from './fold.tsx';
import { tip_of } from './row_editor.tsx';
import type { NestedRowProps } from './row_kinds.ts';
import { TableRows } from './table_rows.tsx';

export function NestedRow({ row, path, value, rivals }: NestedRowProps): ReactElement {
  const page = use_page();
  const excluded = [...useContext(ExcludedPaths), ...rivals];
  const label = row.name.replaceAll('_', ' ');
  const remove = (): void => void page.edit([{ unset: path }], `Unset ${row.name}`);
  const menu =
    value === undefined || row.required ? undefined : (
      <Menu label={`More for ${label}`} items={[{ text: 'Unset', act: remove }]} />
    );
  return (
    <Fold title={label} tip={tip_of(row)} path={path} is_set={value !== undefined} menu={menu}>
      <ExcludedPaths.Provider value={excluded}>
        {row.kind === 'object' && row.table !== undefined ? (
          <TableRows table={table_of(page.tables, row.table)} path={path} value={value} />
        ) : row.kind === 'list' ? (
          <ListRows row={row} path={path} value={value} />
        ) : (
          <MapRows row={row} path={path} value={value} />
        )}
      </ExcludedPaths.Provider>
    </Fold>
  );
}

function ListRows({ row, path, value }: Omit<NestedRowProps, 'rivals'>): ReactElement {
  const page = use_page();
  const excluded = useContext(ExcludedPaths);
  const elements = Array.isArray(value) ? value : [];
  const add = (element: Json): void => {
    // A missing list is added together with its first element.
    const edit =
      value === undefined ? { set: path, value: [element] } : { insert: path_below(path, -1), value: element };
    give(page, [edit], `Add to ${row.name}`, excluded);
  };
  return (
    <>
      {elements.map((element, index) => (
        <Fold
          key={index}
          title={element_title(row, element, index)}
          tip={row.doc}
          path={path_below(path, index)}
          is_set
          menu={<ElementButtons path={path} index={index} count={elements.length} />}
        >
          <TableRows
            table={element_table(page.tables.tables, row, element)}
            path={path_below(path, index)}
            value={element}
          />
        </Fold>
      ))}
      {row.kinds ? (
        <div className="add-line">
          Add
          <Menu
            icon="plus"
            label={`Add to ${row.name}`}
            items={Object.entries(row.kinds.tables).map(([kind, name]) => ({
              text: kind,
              act: () => add({ [row.kinds?.key ?? 'kind']: kind, ...object_of(first_object(page.tables, name)) }),
            }))}
          />
        </div>
      ) : (
        <div className="add-line">
          Add
          <IconButton
            is_small
            icon="plus"
            label={`Add to ${row.name}`}
            press={() => add(first_object(page.tables, row.table ?? ''))}
          />
        </div>
      )}
    </>
  );
}

function ElementButtons({ path, index, count }: { path: string; index: number; count: number }): ReactElement {
  const page = use_page();
  const at = path_below(path, index);
  return (
    <>
      <IconButton
        is_small
        icon="up"
        label={`Move ${index + 1} up`}
        is_off={index === 0}
        press={() => void page.edit([{ move: at, index: index - 1 }], 'Move up')}
      />
      <IconButton
        is_small
        icon="down"
        label={`Move ${index + 1} down`}
        is_off={index === count - 1}
        press={() => void page.edit([{ move: at, index: index + 1 }], 'Move down')}
      />
      <IconButton
        is_small
        icon="close"
        label={`Remove ${index + 1}`}
        press={() => void page.edit([{ remove: at }], 'Remove')}
      />
    </>
  );
}

function MapRows({ row, path, value }: Omit<NestedRowProps, 'rivals'>): ReactElement {
  const page = use_page();
  const excluded = useContext(ExcludedPaths);
  const [name, set_name] = useState('');
  const object = object_of(value);
  const table = table_of(page.tables, row.table ?? '');
  const add = (): void => {
    const made = first_object(page.tables, row.table ?? '');
    const edit =
      value === undefined ? { set: path, value: { [name]: made } } : { set: path_below(path, name), value: made };
    give(page, [edit], `Add ${name}`, excluded);
    set_name('');
  };
  return (
    <>
      {Object.keys(object).map((key) => (
        <Fold
          key={key}
          title={key}
          tip={table.doc}
          path={path_below(path, key)}
          is_set
          menu={
            <IconButton
              is_small
              icon="close"
              label={`Remove ${key}`}
              press={() => void page.edit([{ remove: path_below(path, key) }], `Remove ${key}`)}
            />
          }
        >
          <TableRows table={table} path={path_below(path, key)} value={object[key]} />
        </Fold>
      ))}
      <div className="add-line">
        <input
          className="text-field"
          aria-label={`Name of a new element of ${row.name}`}
          placeholder="new name"
          value={name}
          onChange={(event) => set_name(event.target.value)}
        />
        <IconButton
          is_small
          icon="plus"
          label={`Add to ${row.name}`}
          is_off={name === '' || name in object}
          press={add}
        />
      </div>
    </>
  );
}

function object_of(value: Json | undefined): { [name: string]: Json } {
  return is_object(value) ? value : {};
}

function element_table(tables: Record<string, ParameterTable>, row: Row, element: Json): ParameterTable {
  const kind = row.kinds ? member_of(element, row.kinds.key) : undefined;
  const name = row.kinds && typeof kind === 'string' ? row.kinds.tables[kind] : row.table;
  return tables[name ?? ''] ?? { doc: '', rows: [] };
}

function element_title(row: Row, element: Json, index: number): string {
  const kind = row.kinds ? member_of(element, row.kinds.key) : undefined;
  return `${index + 1}${typeof kind === 'string' ? ` · ${kind}` : ''}`;
}
