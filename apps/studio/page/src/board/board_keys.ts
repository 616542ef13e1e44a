// SPDX-License-Identifier: Apache-2.0
// The effects of keys while the board has the keyboard focus.
import type { KeyboardEvent } from 'react';

import type { Page } from '../page/page.ts';
import { Board } from './board.ts';
import type { BoardLayout } from './board_layout.ts';
import { edge_above, neighbour, siblings_of, stands_free } from './board_places.ts';
import type { Direction } from './board_state.ts';

type Act = (page: Page, id: string, layout: BoardLayout) => void;

const kActs: Record<string, Act> = {
  a: (page) => page.shell.merge({ dialog: 'palette' }),
  l: (page, id) => page.tool(Board).state.merge({ connecting: id, refused: null }),
  n: (page, id) => page.tool(Board).state.merge({ noting: id, renaming: null }),
  F2: (page, id) => page.tool(Board).state.merge({ renaming: id, noting: null }),
  Delete: (page, id) => void page.tool(Board).actions.remove(id),
  Backspace: (page, id) => void page.tool(Board).actions.remove(id),
  ' ': (page, id) => page.tool(Board).actions.fold(id),
  h: (page, id) => page.tool(Board).actions.hide(id),
  s: (page, id) => page.tool(Board).actions.solo(id),
};

const kWithControl: Record<string, Act> = {
  c: (page, id) => void page.tool(Board).parts.copy(id),
  x: (page, id) =>
    void page
      .tool(Board)
      .parts.copy(id)
      .then(() => page.tool(Board).actions.remove(id)),
  v: (page, id) => void page.tool(Board).parts.paste_clip(id),
  d: (page, id) => void page.tool(Board).parts.duplicate(id),
};

type Way = 'up' | 'down' | 'before' | 'behind';
const kWays: Record<Direction, Record<string, Way>> = {
  down: { ArrowUp: 'up', ArrowDown: 'down', ArrowLeft: 'before', ArrowRight: 'behind' },
  right: { ArrowLeft: 'up', ArrowRight: 'down', ArrowUp: 'before', ArrowDown: 'behind' },
};

export function press_key(
  event: KeyboardEvent,
  page: Page,
  layout: BoardLayout,
  direction: Direction,
  zoom: (by: number) => void,
): void {
  const key = (event.target as Element).closest<HTMLElement>('[data-node]')?.dataset['node'];
  if (key === undefined) return;
  const node = layout.nodes.find((one) => one.key === key);
  const way = kWays[direction][event.key];
  const has_control = event.ctrlKey || event.metaKey;
  const act = has_control ? kWithControl[event.key] : kActs[event.key];
  const { connecting } = page.tool(Board).state.get();
  if (event.key === 'Escape' && connecting !== null) page.tool(Board).state.merge({ connecting: null });
  else if (event.key === '+' || event.key === '=') zoom(1.2);
  else if (event.key === '-') zoom(1 / 1.2);
  else if (way !== undefined && event.altKey) shift(page, layout, key, way, event.shiftKey);
  else if (way !== undefined) go(event, page, layout, key, way, connecting !== null);
  else if (event.key === 'Enter' && node) (event.target as HTMLElement).click();
  else if (act && node && !event.altKey) act(page, node.id, layout);
  else return;
  event.preventDefault();
  event.stopPropagation();
}

/// Moves a component among its siblings: its link, or the component itself if it has no link. With `in_text`, moves the
/// component among all components of the document.
function shift(page: Page, layout: BoardLayout, key: string, way: Way, in_text: boolean): void {
  const { actions } = page.tool(Board);
  const node = layout.nodes.find((one) => one.key === key);
  if (!node || way === 'up' || way === 'down') return;
  const by = way === 'before' ? -1 : 1;
  const edge = edge_above(layout, key);
  if (in_text) void actions.shift_component(node.id, by);
  else if (edge && edge.link.index !== null) void actions.shift(edge.link, by);
  else if (stands_free(actions.graph, layout, key))
    void actions.shift_component(
      node.id,
      by,
      siblings_of(layout, key).map((one) => one.id),
    );
}

/// Moves to a neighbouring node. While a link waits for its other end, only the focus moves; otherwise the choice moves
/// too.
function go(
  event: KeyboardEvent,
  page: Page,
  layout: BoardLayout,
  key: string,
  way: Way,
  only_keyboard: boolean,
): void {
  const next = neighbour(layout, key, way);
  if (!next) return;
  event.currentTarget
    .querySelector<HTMLElement>(`[data-node="${CSS.escape(next.key)}"]`)
    ?.focus({ preventScroll: true });
  if (!only_keyboard && !next.is_end) page.tool(Board).actions.choose(next.id);
}
