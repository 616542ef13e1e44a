// SPDX-License-Identifier: Apache-2.0
// The outline: components with their children, links, and the parts of the document.
import type { KeyboardEvent, ReactElement } from 'react';
import { useEffect, useRef } from 'react';

import { use_part } from '../base/store.ts';
import { IconButton } from '../controls/button.tsx';
import type { IconName } from '../controls/icon.tsx';
import { Icon } from '../controls/icon.tsx';
import { use_document, use_page } from '../page/use_page.ts';
import { use_faults } from '../rows/row_actions.ts';
import { link_kind } from '../tables/resolve.ts';
import type { Tables } from '../tables/tables.ts';
import type { Json } from '../values/json.ts';
import { is_object } from '../values/json.ts';
import { member_of, path_below } from '../values/path.ts';

interface Item {
  path: string;
  title: string;
  detail: string;
  icon: IconName;
  component?: string; // component that can be hidden
}

const kParts: Item[] = [
  { path: '', title: 'Document', detail: 'name, seed', icon: 'document' },
  { path: 'scene', title: 'Scene', detail: 'sun, sky, ground', icon: 'scene' },
  { path: 'animation', title: 'Animation', detail: 'length, growth', icon: 'clock' },
  { path: 'output', title: 'Output', detail: 'pictures, levels', icon: 'camera' },
  { path: 'limits', title: 'Limits', detail: 'what may be asked for', icon: 'warning' },
];

export function Outline(): ReactElement {
  const page = use_page();
  const { tree } = use_document();
  const components = components_of(tree?.value, page.tables.components);
  const links = links_of(tree?.value);
  const variables = variables_of(tree?.value);
  return (
    <nav className="panel outline" aria-label="Outline" onKeyDown={step_through}>
      <div className="panel-head">
        <h2>Outline</h2>
      </div>
      <Group title="Components" items={components} empty="No components yet." />
      <Group title="Links" items={links} empty="No links: each component grows by itself." />
      {variables.length > 0 && <Group title="Handles" items={variables} empty="" />}
      <Group title="Document" items={kParts} empty="" />
    </nav>
  );
}

function components_of(document: Json | undefined, types: Tables['components']): Item[] {
  const components = member_of(document, 'components');
  if (!is_object(components)) return [];
  return Object.keys(components).map((id) => {
    const type = String(member_of(components[id], 'type') ?? '?');
    const is_camera = types[type]?.is_camera === true;
    const icon = is_camera ? 'camera' : types[type]?.makes_stems === true ? 'stem' : 'leaf';
    const item: Item = { path: path_below('components', id), title: id, detail: type, icon };
    return is_camera ? item : { ...item, component: id };
  });
}

function links_of(document: Json | undefined): Item[] {
  const links = member_of(document, 'links');
  if (!Array.isArray(links)) return [];
  return links.map((link, index) => {
    const [from, to] = Array.isArray(link) ? [link[0], link[1]] : [member_of(link, 'from'), member_of(link, 'to')];
    return {
      path: path_below('links', index),
      title: `${String(from)} → ${String(to)}`,
      detail: link_kind(link) || 'child',
      icon: 'link',
    };
  });
}

function variables_of(document: Json | undefined): Item[] {
  const variables = member_of(document, 'variables');
  if (!is_object(variables)) return [];
  return Object.keys(variables).map((name) => ({
    path: path_below('variables', name),
    title: name,
    detail: is_object(variables[name]) ? '' : 'private',
    icon: 'sparkle',
  }));
}

function Group({ title, items, empty }: { title: string; items: Item[]; empty: string }): ReactElement {
  return (
    <div className="outline-group">
      <h3>{title}</h3>
      {items.length === 0 && empty !== '' && <p className="empty">{empty}</p>}
      <ul>
        {items.map((item) => (
          <OutlineItem key={item.path} item={item} />
        ))}
      </ul>
    </div>
  );
}

function OutlineItem({ item }: { item: Item }): ReactElement {
  const page = use_page();
  const is_chosen = use_part(page.chosen, (path) => path === item.path);
  const is_hidden = use_part(
    page.view_state,
    ({ hidden }) => item.component !== undefined && hidden.has(item.component),
  );
  const button = useRef<HTMLButtonElement>(null);
  useEffect(() => {
    if (is_chosen) button.current?.scrollIntoView({ block: 'nearest' });
  }, [is_chosen]);
  const below = use_faults(item.path === '' ? '-' : item.path, true);
  const { component } = item;
  const count = use_part(page.growth, ({ grown }) =>
    component === undefined ? undefined : grown?.placed?.[component],
  );
  const toggle = (): void => {
    const hidden = new Set(page.view_state.get().hidden);
    if (component !== undefined && !hidden.delete(component)) hidden.add(component);
    page.change_view({ hidden });
  };
  return (
    <li className={`outline-item${is_hidden ? ' hidden' : ''}`}>
      <button
        ref={button}
        type="button"
        className="outline-choice"
        aria-current={is_chosen ? 'true' : undefined}
        onClick={() => page.choose(item.path)}
      >
        <Icon name={item.icon} />
        <span className="outline-title">{item.title}</span>
        <span className="outline-detail">{item.detail}</span>
        {below.length > 0 && <Icon name={below.some((one) => one.severity === 'error') ? 'fault' : 'warning'} />}
        {count !== undefined && count > 0 && <span className="outline-count">{count.toLocaleString('en')}</span>}
      </button>
      {component !== undefined && (
        <IconButton
          is_small
          icon={is_hidden ? 'eye_off' : 'eye'}
          label={`Draw ${component}`}
          is_on={!is_hidden}
          press={toggle}
        />
      )}
    </li>
  );
}

/// The arrow keys move from item to item.
function step_through(event: KeyboardEvent<HTMLElement>): void {
  const move = { ArrowDown: 1, ArrowUp: -1 }[event.key];
  if (move === undefined) return;
  const all = [...event.currentTarget.querySelectorAll<HTMLElement>('.outline-choice')];
  const at = all.indexOf(document.activeElement as HTMLElement);
  if (at < 0) return;
  event.preventDefault();
  all[Math.min(all.length - 1, Math.max(0, at + move))]?.focus();
}
