// SPDX-License-Identifier: Apache-2.0
// All rows of the chosen part, made from the parameter tables.
import type { ReactElement } from 'react';
import { useState } from 'react';

import { use_store } from '../base/store.ts';
import { Button, Segments } from '../controls/button.tsx';
import { Faults } from '../controls/faults.tsx';
import { Icon } from '../controls/icon.tsx';
import { CurvesButton } from '../grass/curves_button.tsx';
import { use_document, use_page } from '../page/use_page.ts';
import { use_faults } from '../rows/row_actions.ts';
import { RowView } from '../rows/row_editor.tsx';
import { SceneTools } from '../scene/scene_tools.tsx';
import { SunDial } from '../scene/sun_dial.tsx';
import { groups_at } from '../tables/resolve.ts';
import type { Row, RowGroup } from '../tables/tables.ts';
import { has_meaning } from '../tables/tables.ts';
import type { Json } from '../values/json.ts';
import { is_object } from '../values/json.ts';
import { steps_of, value_at } from '../values/path.ts';
import { InstancePanel } from './instance_panel.tsx';
import { NamedTools } from './named_tools.tsx';

type Filter = 'all' | 'given';

export function Inspector(): ReactElement {
  const page = use_page();
  const path = use_store(page.chosen);
  const { tree } = use_document();
  const [filter, set_filter] = useState<Filter>('all');
  const [words, set_words] = useState('');
  const value = value_at(tree, path);
  const groups = groups_at(page.tables, tree, path);
  const wanted = (group: RowGroup, row: Row): boolean => {
    const given = is_object(value) && value[row.name] !== undefined;
    if (row.name === 'type') return false;
    if (words !== '' && !`${row.name.replaceAll('_', ' ')} ${row.doc}`.toLowerCase().includes(words.toLowerCase()))
      return false;
    return given || (filter === 'all' && has_meaning(group.table, row.name, value));
  };
  return (
    <section className="panel inspector" aria-labelledby="inspector-title">
      <InspectorHead path={path} value={value} />
      <InstancePanel path={path} />
      {path === 'scene' && (
        <>
          <SunDial />
          <SceneTools />
        </>
      )}
      <div className="inspector-tools">
        <label className="search">
          <Icon name="search" />
          <input
            type="search"
            aria-label="Find a parameter"
            placeholder="Find a parameter"
            value={words}
            onChange={(event) => set_words(event.target.value)}
          />
        </label>
        <Segments
          label="Which parameters"
          value={filter}
          choices={[
            ['all', 'All'],
            ['given', 'Given'],
          ]}
          choose={set_filter}
        />
      </div>
      <div className="inspector-rows" key={path}>
        {Array.isArray(value) && <ShortLink path={path} link={value} />}
        {!Array.isArray(value) &&
          groups.map((group) => <Group key={group.title} group={group} path={path} value={value} wanted={wanted} />)}
      </div>
    </section>
  );
}

function InspectorHead({ path, value }: { path: string; value: Json | undefined }): ReactElement {
  const page = use_page();
  const faults = use_faults(path);
  const [head, second] = steps_of(path);
  const type = is_object(value) && typeof value['type'] === 'string' ? value['type'] : null;
  const title =
    second === undefined ? capital(head ?? 'document') : typeof second === 'number' ? `Link ${second + 1}` : second;
  const doc = type !== null ? page.tables.components[type]?.doc : undefined;
  return (
    <div className="inspector-head">
      <h2 id="inspector-title">
        {title}
        {type !== null && head === 'components' && <span className="badge">{type}</span>}
      </h2>
      {doc && <p className="quiet">{doc}</p>}
      <NamedTools path={path} />
      <CurvesButton path={path} />
      {path !== '' && <Faults faults={faults} />}
    </div>
  );
}

function capital(text: string | number): string {
  const word = String(text);
  return word.charAt(0).toUpperCase() + word.slice(1);
}

interface GroupProps {
  group: RowGroup;
  path: string;
  value: Json | undefined;
  wanted: (group: RowGroup, row: Row) => boolean;
}

function Group({ group, path, value, wanted }: GroupProps): ReactElement | null {
  const rows = group.rows.filter((row) => wanted(group, row));
  if (rows.length === 0) return null;
  return (
    <section className="row-group">
      <h3 data-tip={group.table.doc}>{group.title}</h3>
      {rows.map((row) => (
        <RowView
          key={row.name}
          table={group.table}
          row={row}
          parent={path}
          parent_value={value}
          value={is_object(value) ? value[row.name] : undefined}
        />
      ))}
    </section>
  );
}

/// The short form ["from", "to"] of a link has no numbers, so the long form is offered.
function ShortLink({ path, link }: { path: string; link: Json[] }): ReactElement {
  const page = use_page();
  const write_out = (): void => page.set_value(path, { from: link[0] ?? '', to: link[1] ?? '' }, 'Write the link out');
  return (
    <div className="empty">
      <p>
        <strong>{String(link[1])}</strong> stands where <strong>{String(link[0])}</strong> ends. Written out, the link
        can say more: other kinds, how many, at which angle.
      </p>
      <Button press={write_out}>Write the link out</Button>
    </div>
  );
}
