// SPDX-License-Identifier: Apache-2.0
// The lines of the board, drawn as in the published source: child links thin, branch links thick, leaf links dashed.
// Crown links are dotted, and links that a grammar makes are pale. Lines of a recursion are doubled.
import type { ReactElement } from 'react';
import { class_names } from '../base/class_names.ts';
import { use_page } from '../page/use_page.ts';
import { use_faults } from '../rows/row_actions.ts';
import { link_path } from './board_edits.ts';
import type { BoardGesture } from './board_gesture.ts';
import type { BoardEdge } from './board_layout.ts';
import type { Place } from './board_places.ts';
import { curve_between } from './board_places.ts';
import type { Direction } from './board_state.ts';

interface BoardEdgeProps {
  edge: BoardEdge;
  from: Place;
  to: Place;
  direction: Direction;
  is_chosen: boolean;
}

export function BoardEdgeView({ edge, from, to, direction, is_chosen }: BoardEdgeProps): ReactElement {
  const page = use_page();
  const { index, kind } = edge.link;
  const faults = use_faults(index === null ? '-' : link_path(index), true);
  const curve = curve_between(from, to, direction);
  const { is_doubled } = edge;
  const is_faulty = faults.length > 0;
  const classes = class_names(
    'board-line',
    kind,
    is_doubled && 'doubled',
    is_chosen && 'chosen',
    is_faulty && 'faulty',
  );
  return (
    <g data-line={index ?? undefined} onClick={() => index !== null && page.choose(link_path(index))}>
      <path className={classes} d={curve} />
      {is_doubled && <path className={`board-between ${kind}`} d={curve} />}
      {index !== null && <path className="board-hit" d={curve} />}
    </g>
  );
}

/// The line that the user draws from a node.
export function DraggedLine({
  gesture,
  places,
  direction,
}: {
  gesture: BoardGesture;
  places: Map<string, Place>;
  direction: Direction;
}): ReactElement | null {
  const { held } = gesture;
  const from = held?.kind === 'link' ? places.get(held.key) : undefined;
  if (!held || !from) return null;
  const over = held.over === null ? undefined : places.get(held.over);
  const curve = over ? curve_between(from, over, direction) : `M${from.x} ${from.y}L${held.x} ${held.y}`;
  return <path className={`board-line dragged${held.refused === null ? '' : ' refused'}`} d={curve} />;
}
