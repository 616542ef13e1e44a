// SPDX-License-Identifier: Apache-2.0
// The drawing of the board. Dragging beside the nodes moves it, and the wheel zooms. Nodes are chosen by a click or the
// arrow keys, moved by dragging them among their siblings or onto other nodes, and linked by dragging from their edge.
import type { KeyboardEvent, PointerEvent, ReactElement } from 'react';
import { useEffect, useLayoutEffect, useRef, useState } from 'react';

import { use_store } from '../base/store.ts';
import { use_page } from '../page/use_page.ts';
import { Board } from './board.ts';
import { BoardEdgeView, DraggedLine } from './board_edge.tsx';
import { component_of, link_of } from './board_edits.ts';
import type { BoardGesture } from './board_gesture.ts';
import { use_gesture } from './board_gesture.ts';
import { press_key } from './board_keys.ts';
import type { BoardLayout } from './board_layout.ts';
import { BoardNodeView } from './board_node.tsx';
import { fitting_direction, kNode, place_of, size_of } from './board_places.ts';
import type { Direction } from './board_state.ts';
import type { PlantGraph } from './plant_graph.ts';

interface Sight {
  x: number; // position of the board's corner in the panel, pixels
  y: number;
  scale: number;
}

const kScales = { low: 0.25, high: 1.5, first: 0.62 };

export function BoardCanvas({ graph, layout }: { graph: PlantGraph; layout: BoardLayout }): ReactElement {
  const page = use_page();
  const frame = useRef<HTMLDivElement>(null);
  const board = use_store(page.tool(Board).state);
  const chosen = use_store(page.chosen);
  const [area, set_area] = useState<[number, number]>([440, 320]);
  const [sight, set_sight] = useState<Sight>({ x: 0, y: 0, scale: 1 });
  const direction = board.direction ?? fitting_direction(layout, ...area);
  const size = size_of(layout, direction);
  const { name } = page.document.state.get();

  useLayoutEffect(() => {
    const element = frame.current;
    if (!element) return undefined;
    const measure = new ResizeObserver(() => set_area([element.clientWidth, element.clientHeight]));
    measure.observe(element);
    return () => measure.disconnect();
  }, []);
  useEffect(() => {
    set_sight(fitted(size, area));
    // A document is fitted once, and again if the panel or the direction changes.
  }, [name, direction, area[0], area[1]]);
  useEffect(() => {
    if (page.tool(Board).fits.get() > 0) set_sight(fitted(size, area));
  }, [use_store(page.tool(Board).fits)]);
  // A node that is chosen elsewhere is scrolled into view.
  const chosen_id =
    component_of(chosen) ?? layout.edges.find((edge) => edge.link.index === link_of(chosen))?.to ?? null;
  useEffect(() => {
    const node = layout.nodes.find((one) => one.key === chosen_id);
    if (node) set_sight((now) => seen(now, place_of(node, direction), area));
  }, [chosen_id, layout]);

  const gesture = use_gesture(graph, layout, direction, () => sight, frame);
  const wheel = (event: WheelEvent): void => {
    event.preventDefault();
    const box = frame.current?.getBoundingClientRect();
    if (!box) return;
    if (!event.ctrlKey && event.deltaMode === 0 && Math.abs(event.deltaX) > 0) {
      set_sight((now) => ({ ...now, x: now.x - event.deltaX, y: now.y - event.deltaY }));
      return;
    }
    const [x, y] = [event.clientX - box.left, event.clientY - box.top];
    set_sight((now) =>
      zoomed(now, Math.exp(-Math.sign(event.deltaY) * Math.min(0.25, Math.abs(event.deltaY) / 500)), x, y),
    );
  };
  useEffect(() => {
    const element = frame.current;
    element?.addEventListener('wheel', wheel, { passive: false });
    return () => element?.removeEventListener('wheel', wheel);
  });
  const key = (event: KeyboardEvent): void =>
    press_key(event, page, layout, direction, (by) => set_sight((now) => zoomed(now, by, area[0] / 2, area[1] / 2)));
  const pan = use_pan(set_sight);
  return (
    <div
      ref={frame}
      className={`board-canvas${board.connecting === null ? '' : ' connecting'}`}
      data-direction={direction}
      onKeyDown={key}
      {...pan(gesture)}
    >
      <div
        className="board-sheet"
        style={{
          width: size[0],
          height: size[1],
          transform: `translate(${sight.x}px, ${sight.y}px) scale(${sight.scale})`,
        }}
      >
        <Lines layout={layout} direction={direction} size={size} chosen={chosen} gesture={gesture} />
        <div role="tree" aria-label="Components" className="board-nodes">
          {layout.nodes.map((node) => (
            <BoardNodeView
              key={node.key}
              node={node}
              graph={graph}
              layout={layout}
              place={place_of(node, direction)}
              gesture={gesture}
              is_first={node === layout.nodes[0]}
            />
          ))}
        </div>
      </div>
      {graph.components.size === 0 && (
        <p className="empty board-empty">Nothing is here yet. Add the first component with A.</p>
      )}
    </div>
  );
}

interface LinesProps {
  layout: BoardLayout;
  direction: Direction;
  size: [number, number];
  chosen: string;
  gesture: BoardGesture;
}

function Lines({ layout, direction, size, chosen, gesture }: LinesProps): ReactElement {
  const page = use_page();
  const { refused } = use_store(page.tool(Board).state);
  const places = new Map(layout.nodes.map((node) => [node.key, place_of(node, direction)]));
  const chosen_link = link_of(chosen);
  const ends = refused ? [places.get(refused.from), places.get(refused.to)] : [];
  return (
    <svg className="board-lines" width={size[0]} height={size[1]} aria-hidden="true">
      {layout.edges.map((edge) => {
        const [from, to] = [places.get(edge.from), places.get(edge.to)];
        if (!from || !to) return null;
        const is_chosen = edge.link.index !== null && edge.link.index === chosen_link;
        return (
          <BoardEdgeView key={edge.key} edge={edge} from={from} to={to} direction={direction} is_chosen={is_chosen} />
        );
      })}
      {ends[0] && ends[1] && (
        <path className="board-line refused" d={`M${ends[0].x} ${ends[0].y}L${ends[1].x} ${ends[1].y}`} />
      )}
      <DraggedLine gesture={gesture} places={places} direction={direction} />
    </svg>
  );
}

/// Dragging beside all nodes moves the board. A click there chooses the document.
function use_pan(set_sight: (change: (now: Sight) => Sight) => void) {
  const page = use_page();
  const hand = useRef<{ x: number; y: number; moved: boolean } | null>(null);
  return (gesture: BoardGesture) => ({
    onPointerDown: (event: PointerEvent<HTMLDivElement>) => {
      if ((event.target as Element).closest('[data-node], [data-line]')) return;
      event.currentTarget.setPointerCapture(event.pointerId);
      hand.current = { x: event.clientX, y: event.clientY, moved: false };
    },
    onPointerMove: (event: PointerEvent<HTMLDivElement>) => {
      const held = hand.current;
      if (!held) return gesture.move(event);
      const [dx, dy] = [event.clientX - held.x, event.clientY - held.y];
      if (!held.moved && Math.hypot(dx, dy) < 4) return;
      hand.current = { x: event.clientX, y: event.clientY, moved: true };
      set_sight((now) => ({ ...now, x: now.x + dx, y: now.y + dy }));
    },
    onPointerUp: (event: PointerEvent<HTMLDivElement>) => {
      const held = hand.current;
      hand.current = null;
      if (!held) return gesture.drop(event);
      if (!held.moved) page.choose('');
    },
    onPointerCancel: () => {
      hand.current = null;
      gesture.cancel();
    },
  });
}

function fitted([width, height]: [number, number], [w, h]: [number, number]): Sight {
  const scale = Math.min(1, Math.max(kScales.first, Math.min(w / width, h / height)));
  return { scale, x: Math.max(0, (w - width * scale) / 2), y: Math.max(0, (h - height * scale) / 2) };
}

function zoomed(now: Sight, by: number, x: number, y: number): Sight {
  const scale = Math.min(kScales.high, Math.max(kScales.low, now.scale * by));
  const share = scale / now.scale;
  return { scale, x: x - (x - now.x) * share, y: y - (y - now.y) * share };
}

/// Returns the view of the board, moved so that a node is visible.
function seen(now: Sight, place: { x: number; y: number }, [w, h]: [number, number]): Sight {
  const [x, y] = [now.x + place.x * now.scale, now.y + place.y * now.scale];
  const [dx, dy] = [(kNode.width / 2 + 8) * now.scale, (kNode.height / 2 + 8) * now.scale];
  const shift = (at: number, margin: number, size: number): number =>
    at < margin ? margin - at : at > size - margin ? size - margin - at : 0;
  const [sx, sy] = [shift(x, dx, w), shift(y, dy, h)];
  return sx === 0 && sy === 0 ? now : { ...now, x: now.x + sx, y: now.y + sy };
}
