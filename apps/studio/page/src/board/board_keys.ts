// SPDX-License-Identifier: Apache-2.0
// The effects of keys while the board has the keyboard focus.
import type { KeyboardEvent } from 'react';

import type { Studio } from '../studio.ts';
import type { BoardLayout } from './board_layout.ts';
import { edge_above, neighbour, siblings_of, stands_free } from './board_places.ts';
import type { Direction } from './board_state.ts';

type Act = (studio: Studio, id: string, layout: BoardLayout) => void;

const kActs: Record<string, Act> = {
  a: (studio) => studio.shell.merge({ dialog: 'palette' }),
  l: (studio, id) => studio.board.state.merge({ connecting: id, refused: null }),
  n: (studio, id) => studio.board.state.merge({ noting: id, renaming: null }),
  F2: (studio, id) => studio.board.state.merge({ renaming: id, noting: null }),
  Delete: (studio, id) => void studio.board.actions.remove(id),
  Backspace: (studio, id) => void studio.board.actions.remove(id),
  ' ': (studio, id) => studio.board.actions.fold(id),
  h: (studio, id) => studio.board.actions.hide(id),
  s: (studio, id) => studio.board.actions.solo(id),
};

const kWithControl: Record<string, Act> = {
  c: (studio, id) => void studio.board.parts.copy(id),
  x: (studio, id) => void studio.board.parts.copy(id).then(() => studio.board.actions.remove(id)),
  v: (studio, id) => void studio.board.parts.paste_clip(id),
  d: (studio, id) => void studio.board.parts.duplicate(id),
};

type Way = 'up' | 'down' | 'before' | 'behind';
const kWays: Record<Direction, Record<string, Way>> = {
  down: { ArrowUp: 'up', ArrowDown: 'down', ArrowLeft: 'before', ArrowRight: 'behind' },
  right: { ArrowLeft: 'up', ArrowRight: 'down', ArrowUp: 'before', ArrowDown: 'behind' },
};

export function press_key(event: KeyboardEvent, studio: Studio, layout: BoardLayout, direction: Direction, zoom: (by: number) => void): void {
  const key = (event.target as Element).closest<HTMLElement>('[data-node]')?.dataset['node'];
  if (key === undefined) return;
  const node = layout.nodes.find((one) => one.key === key);
  const way = kWays[direction][event.key];
  const has_control = event.ctrlKey || event.metaKey;
  const act = has_control ? kWithControl[event.key] : kActs[event.key];
  const { connecting } = studio.board.state.get();
  if (event.key === 'Escape' && connecting !== null) studio.board.state.merge({ connecting: null });
  else if (event.key === '+' || event.key === '=') zoom(1.2);
  else if (event.key === '-') zoom(1 / 1.2);
  else if (way !== undefined && event.altKey) shift(studio, layout, key, way, event.shiftKey);
  else if (way !== undefined) go(event, studio, layout, key, way, connecting !== null);
  else if (event.key === 'Enter' && node) (event.target as HTMLElement).click();
  else if (act && node && !event.altKey) act(studio, node.id, layout);
  else return;
  event.preventDefault();
  event.stopPropagation();
}

/// Moves a component among its siblings: its link, or the component itself if it has no link. With `in_text`, moves the
/// component among all components of the document.
function shift(studio: Studio, layout: BoardLayout, key: string, way: Way, in_text: boolean): void {
  const { actions } = studio.board;
  const node = layout.nodes.find((one) => one.key === key);
  if (!node || way === 'up' || way === 'down') return;
  const by = way === 'before' ? -1 : 1;
  const edge = edge_above(layout, key);
  if (in_text) void actions.shift_component(node.id, by);
  else if (edge && edge.link.index !== null) void actions.shift(edge.link, by);
  else if (stands_free(actions.graph, layout, key)) void actions.shift_component(node.id, by, siblings_of(layout, key).map((one) => one.id));
}

/// Moves to a neighbouring node. While a link waits for its other end, only the focus moves; otherwise the choice moves
/// too.
function go(event: KeyboardEvent, studio: Studio, layout: BoardLayout, key: string, way: Way, only_keyboard: boolean): void {
  const next = neighbour(layout, key, way);
  if (!next) return;
  event.currentTarget.querySelector<HTMLElement>(`[data-node="${CSS.escape(next.key)}"]`)?.focus({ preventScroll: true });
  if (!only_keyboard && !next.is_end) studio.board.actions.choose(next.id);
}
