// SPDX-License-Identifier: Apache-2.0
// A drag on the board: a line from a node's edge to another node, or a node that is moved among its siblings or onto
// another node.
import type { PointerEvent, RefObject } from 'react';
import { useEffect, useState } from 'react';

import { use_page } from '../page/use_page.ts';
import { Board } from './board.ts';
import { links_from } from './board_edits.ts';
import type { BoardLayout, BoardNode } from './board_layout.ts';
import { edge_above, place_of, siblings_of, stands_free } from './board_places.ts';
import type { Direction } from './board_state.ts';
import type { GraphLink, PlantGraph } from './plant_graph.ts';
import { refusal_of_link } from './plant_graph.ts';

export interface Held {
  kind: 'link' | 'node';
  key: string; // key of the node that is dragged
  x: number; // position of the pointer on the sheet
  y: number;
  from_x: number;
  from_y: number;
  moved: boolean;
  over: string | null; // key of the node below the pointer
  refused: string | null; // why a link to that node is impossible
}

export interface BoardGesture {
  held: Held | null;
  hold(event: PointerEvent, kind: Held['kind'], key: string): void;
  move(event: PointerEvent): void;
  drop(event: PointerEvent): void;
  cancel(): void;
}

const kStill = 5; // pixels within which a press is a click

export function use_gesture(
  graph: PlantGraph,
  layout: BoardLayout,
  direction: Direction,
  sight: () => { x: number; y: number; scale: number },
  frame: RefObject<HTMLDivElement | null>,
): BoardGesture {
  const page = use_page();
  const [held, set_held] = useState<Held | null>(null);
  const on_sheet = (event: PointerEvent): { x: number; y: number } => {
    const box = frame.current?.getBoundingClientRect();
    const { x, y, scale } = sight();
    return { x: (event.clientX - (box?.left ?? 0) - x) / scale, y: (event.clientY - (box?.top ?? 0) - y) / scale };
  };
  const node_below = (event: PointerEvent): string | null =>
    document
      .elementsFromPoint(event.clientX, event.clientY)
      .map((one) => one.closest<HTMLElement>('[data-node]')?.dataset['node'])
      .find((key) => key !== undefined) ?? null;
  const id_of = (key: string): string => layout.nodes.find((one) => one.key === key)?.id ?? key;
  const refusal = (from: string, to: string): string | null =>
    refusal_of_link(graph, id_of(from), id_of(to), (id) => page.tool(Board).actions.recursion_of(id));

  const hold = (event: PointerEvent, kind: Held['kind'], key: string): void => {
    if (event.button !== 0) return;
    event.stopPropagation();
    const { x, y } = on_sheet(event);
    set_held({ kind, key, x, y, from_x: x, from_y: y, moved: false, over: null, refused: null });
  };
  const move = (event: PointerEvent): void => {
    if (!held) return;
    const at = on_sheet(event);
    const moved = held.moved || Math.hypot(at.x - held.from_x, at.y - held.from_y) > kStill;
    if (!moved) return;
    if (!held.moved) frame.current?.setPointerCapture(event.pointerId);
    const below = node_below(event);
    const over = below === held.key ? null : below;
    set_held({
      ...held,
      ...at,
      moved,
      over,
      refused: held.kind === 'link' && over !== null ? refusal(held.key, over) : null,
    });
  };
  const drop = (event: PointerEvent): void => {
    if (!held) return;
    set_held(null);
    if (!held.moved) return;
    const below = node_below(event);
    if (held.kind === 'link') {
      if (below !== null && below !== held.key)
        void page
          .tool(Board)
          .actions.connect(
            id_of(held.key),
            id_of(below),
            page.tool(Board).actions.usual_kind(id_of(held.key), id_of(below)),
          );
      return;
    }
    const { actions } = page.tool(Board);
    const link = edge_above(layout, held.key)?.link;
    if (below !== null && below !== held.key) {
      if (link?.index !== undefined && link.index !== null) {
        if (id_of(below) !== link.from) void actions.hang(link, id_of(below));
      } else if (stands_free(graph, layout, held.key)) {
        void actions.connect(id_of(below), id_of(held.key), actions.usual_kind(id_of(below), id_of(held.key)));
      }
      return;
    }
    // Among siblings, the node is placed after all whose centre the pointer has passed.
    const across = direction === 'down' ? on_sheet(event).x : on_sheet(event).y;
    const is_passed = (node: BoardNode | undefined): boolean => {
      const place = node && place_of(node, direction);
      return place !== undefined && (direction === 'down' ? place.x : place.y) < across;
    };
    if (link?.index !== undefined && link.index !== null) {
      const others = links_from(graph, link.from).filter((one) => one.index !== link.index);
      const node_of = (one: GraphLink): BoardNode | undefined =>
        layout.nodes.find((node) => node.key === layout.edges.find((edge) => edge.link.index === one.index)?.to);
      void actions.put(link, others.filter((one) => is_passed(node_of(one))).length);
    } else if (stands_free(graph, layout, held.key)) {
      const siblings = siblings_of(layout, held.key);
      void actions.put_component(
        id_of(held.key),
        siblings.map((one) => one.id),
        siblings.filter((one) => one.key !== held.key && is_passed(one)).length,
      );
    }
  };
  const cancel = (): void => set_held(null);
  useEffect(() => {
    if (!held) return undefined;
    const cancel_on_escape = (event: globalThis.KeyboardEvent): void => {
      if (event.key === 'Escape') set_held(null);
    };
    document.addEventListener('keydown', cancel_on_escape);
    return () => document.removeEventListener('keydown', cancel_on_escape);
  }, [held]);
  return { held, hold, move, drop, cancel };
}
