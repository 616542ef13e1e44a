// SPDX-License-Identifier: Apache-2.0
// Buttons for actions on the chosen part of the board.
import type { ReactElement } from 'react';

import { use_store } from '../base/store.ts';
import { Button, IconButton, Segments } from '../controls/button.tsx';
import type { MenuItem } from '../controls/menu.tsx';
import { Menu } from '../controls/menu.tsx';
import type { Page } from '../page/page.ts';
import { use_page } from '../page/use_page.ts';
import { Board } from './board.ts';
import { component_of, link_of, links_from } from './board_edits.ts';
import type { BoardLayout } from './board_layout.ts';
import { edge_above } from './board_places.ts';
import type { GraphLink, PlantGraph } from './plant_graph.ts';

interface ToolsProps {
  graph: PlantGraph;
  layout: BoardLayout;
}

export function BoardTools({ graph, layout }: ToolsProps): ReactElement {
  const page = use_page();
  const path = use_store(page.chosen);
  const board = use_store(page.tool(Board).state);
  const component = component_of(path);
  const link = graph.links.find((one) => one.index !== null && one.index === link_of(path));
  const turn = (): void => {
    const now = document.querySelector<HTMLElement>('.board-canvas')?.dataset['direction'];
    page.tool(Board).state.merge({ direction: now === 'down' ? 'right' : 'down' });
  };
  return (
    <div className="board-tools" role="toolbar" aria-label="Board">
      <Button
        icon="plus"
        tip="Add a component below the chosen one  A"
        press={() => page.shell.merge({ dialog: 'palette' })}
      >
        Add
      </Button>
      {component !== null && graph.components.has(component) && (
        <ComponentTools id={component} graph={graph} layout={layout} />
      )}
      {link && <LinkTools link={link} graph={graph} />}
      <span className="stretch" />
      {board.folded.size > 0 && (
        <IconButton
          is_small
          icon="unfold"
          label="Unfold all"
          press={() => page.tool(Board).state.merge({ folded: new Set() })}
        />
      )}
      <IconButton is_small icon="turn" label="Turn the board" press={turn} />
      <IconButton is_small icon="fit" label="Fit the board" press={() => page.tool(Board).fit()} />
    </div>
  );
}

function ComponentTools({ id, graph, layout }: ToolsProps & { id: string }): ReactElement {
  const page = use_page();
  const { solo, hidden } = use_store(page.view_state);
  const { folded } = use_store(page.tool(Board).state);
  const { actions: acts } = page.tool(Board);
  const is_camera = graph.components.get(id)?.is_camera === true;
  const has_children = graph.links.some((link) => link.from === id);
  return (
    <>
      <IconButton
        is_small
        icon="link"
        label={`Link from ${id}`}
        keys="L"
        press={() => page.tool(Board).state.merge({ connecting: id })}
      />
      <IconButton
        is_small
        icon="solo"
        label={`Show ${id} alone`}
        keys="S"
        is_on={solo === id}
        press={() => acts.solo(id)}
      />
      {!is_camera && (
        <IconButton
          is_small
          icon={hidden.has(id) ? 'eye_off' : 'eye'}
          label={`Draw ${id}`}
          keys="H"
          is_on={!hidden.has(id)}
          press={() => acts.hide(id)}
        />
      )}
      {has_children && (
        <IconButton
          is_small
          icon={folded.has(id) ? 'unfold' : 'fold'}
          label={folded.has(id) ? `Unfold ${id}` : `Fold ${id}`}
          keys="Space"
          press={() => acts.fold(id)}
        />
      )}
      <Menu label={`More for ${id}`} items={menu_of(page, id, graph, layout)} />
    </>
  );
}

function menu_of(page: Page, id: string, graph: PlantGraph, layout: BoardLayout): MenuItem[] {
  const { actions: acts, parts } = page.tool(Board);
  const edge = edge_above(layout, id);
  const siblings = edge ? links_from(graph, edge.link.from) : [];
  const at = siblings.findIndex((link) => link.index === edge?.link.index);
  const all = acts.written_components;
  const place = all.indexOf(id);
  const items: (MenuItem | false)[] = [
    page.tool(Board).gardens.document_of(id) !== null && {
      text: 'Open its document',
      act: () => void page.tool(Board).gardens.enter(id),
    },
    { text: 'Rename…', act: () => page.tool(Board).state.merge({ renaming: id, noting: null }) },
    { text: 'Note…', act: () => page.tool(Board).state.merge({ noting: id, renaming: null }) },
    { text: 'Duplicate', act: () => void parts.duplicate(id) },
    { text: 'Copy', act: () => void parts.copy(id) },
    { text: 'Paste below', act: () => void parts.paste_clip(id) },
    at > 0 && edge !== undefined && { text: 'Move earlier', act: () => void acts.shift(edge.link, -1) },
    at >= 0 &&
      at + 1 < siblings.length &&
      edge !== undefined && { text: 'Move later', act: () => void acts.shift(edge.link, 1) },
    place > 0 && { text: 'Earlier in the document', act: () => void acts.shift_component(id, -1) },
    place >= 0 &&
      place + 1 < all.length && { text: 'Later in the document', act: () => void acts.shift_component(id, 1) },
    edge !== undefined &&
      edge.link.index !== null && { text: 'Choose its link', act: () => page.choose(`links[${edge.link.index}]`) },
    { text: 'Delete alone', act: () => void acts.remove_alone(id) },
    { text: 'Delete', act: () => void acts.remove(id) },
  ];
  return items.filter((item): item is MenuItem => item !== false);
}

const kKinds = [
  ['child', 'Child'],
  ['branch', 'Branch'],
  ['leaf', 'Leaf'],
  ['crown', 'Crown'],
] as const;

function LinkTools({ link, graph }: { link: GraphLink; graph: PlantGraph }): ReactElement {
  const { actions: acts } = use_page().tool(Board);
  const siblings = links_from(graph, link.from);
  const at = siblings.findIndex((one) => one.index === link.index);
  return (
    <>
      <Segments
        label={`Kind of the link from ${link.from} to ${link.to}`}
        value={link.kind === 'placed' ? 'child' : link.kind}
        choices={kKinds}
        choose={(kind) => void acts.set_kind(link, kind)}
      />
      <IconButton
        is_small
        icon="left"
        label="Move the link earlier"
        is_off={at <= 0}
        press={() => void acts.shift(link, -1)}
      />
      <IconButton
        is_small
        icon="right"
        label="Move the link later"
        is_off={at + 1 >= siblings.length}
        press={() => void acts.shift(link, 1)}
      />
      <IconButton is_small icon="bin" label="Delete the link" press={() => void acts.remove_link(link.index ?? -1)} />
    </>
  );
}
