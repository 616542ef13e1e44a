// SPDX-License-Identifier: Apache-2.0
// A component on the board: its name and type, its number of instances, and whether it is hidden, folded or faulty.
import type { PointerEvent, ReactElement } from 'react';
import { useEffect, useRef } from 'react';

import { use_store } from '../base/store.ts';
import { Icon } from '../controls/icon.tsx';
import { use_document, use_page } from '../page/use_page.ts';
import { use_faults } from '../rows/row_actions.ts';
import { Board } from './board.ts';
import { component_of, component_path, link_of, link_path } from './board_edits.ts';
import type { BoardGesture } from './board_gesture.ts';
import type { BoardLayout, BoardNode } from './board_layout.ts';
import type { Place } from './board_places.ts';
import { kNode } from './board_places.ts';
import { icon_of } from './component_icon.ts';
import type { PlantGraph } from './plant_graph.ts';

interface BoardNodeProps {
  node: BoardNode;
  graph: PlantGraph;
  layout: BoardLayout;
  place: Place;
  gesture: BoardGesture;
  is_first: boolean;
}

export function BoardNodeView({ node, graph, layout, place, gesture, is_first }: BoardNodeProps): ReactElement {
  const page = use_page();
  const element = useRef<HTMLDivElement>(null);
  const component = graph.components.get(node.id);
  const path = use_store(page.chosen);
  const { refused, connecting } = use_store(page.tool(Board).state);
  const is_chosen = component_of(path) === node.id && !node.is_end;
  const is_end_of_link =
    link_of(path) !== null && layout.edges.some((edge) => edge.to === node.key && edge.link.index === link_of(path));
  const facts = use_node_facts(node.id, graph);
  const { held } = gesture;
  const is_target = held?.kind === 'link' && held.over === node.key;
  const classes = [
    'board-node',
    is_chosen && 'chosen',
    node.is_end && 'end',
    component?.is_written === false && 'added',
    facts.is_hidden && 'hidden',
    facts.errors > 0 && 'faulty',
    (is_target ? held.refused !== null : refused?.to === node.id) && 'refused',
    is_target && held.refused === null && 'target',
    held?.kind === 'node' && held.moved && held.key === node.key && 'held',
  ];
  const had_keyboard = useRef(false);
  useEffect(() => {
    // The focus follows the choice on the board, but is never taken from elsewhere.
    if (
      is_chosen &&
      had_keyboard.current === false &&
      element.current?.closest('.board-canvas')?.contains(document.activeElement)
    )
      element.current.focus({ preventScroll: true });
    had_keyboard.current = is_chosen;
  }, [is_chosen]);
  const press = (): void => {
    if (connecting !== null)
      void page
        .tool(Board)
        .actions.connect(connecting, node.id, page.tool(Board).actions.usual_kind(connecting, node.id));
    else page.tool(Board).actions.choose(node.id);
  };
  const nobody_is_chosen = component_of(path) === null || !graph.components.has(component_of(path) ?? '');
  const down = (event: PointerEvent): void => {
    event.stopPropagation();
    gesture.hold(event, 'node', node.key);
  };
  const shift =
    held?.kind === 'node' && held.moved && held.key === node.key
      ? { x: held.x - held.from_x, y: held.y - held.from_y }
      : { x: 0, y: 0 };
  return (
    <div
      ref={element}
      role="treeitem"
      className={classes.filter(Boolean).join(' ')}
      style={{
        width: kNode.width,
        height: kNode.height,
        transform: `translate(${place.x - kNode.width / 2 + shift.x}px, ${place.y - kNode.height / 2 + shift.y}px)`,
      }}
      data-node={node.key}
      data-tip={tip_of(node, facts, component?.is_written !== false)}
      aria-level={node.level + 1}
      aria-selected={is_chosen || is_end_of_link}
      aria-expanded={node.hides > 0 ? false : undefined}
      tabIndex={is_chosen || (nobody_is_chosen && is_first) ? 0 : -1}
      onClick={press}
      onDoubleClick={() => void page.tool(Board).gardens.enter(node.id)}
      onPointerDown={down}
    >
      <span className="board-icon">
        <Icon name={icon_of(page.tables.components, component?.type ?? '')} />
      </span>
      <span className="board-name">
        <b>{node.id}</b> <small>{component?.is_written === false ? 'added' : component?.type}</small>
      </span>
      <span className="spoken">{spoken_of(node, facts)}</span>
      {facts.count !== null && facts.count !== 1 && !node.is_end && (
        <span aria-hidden="true" className={facts.count === 0 ? 'board-count none' : 'board-count'}>
          {short_count(facts.count)}
        </span>
      )}
      <span className="board-marks">
        {facts.note !== undefined && <Icon name="note" />}
        {facts.is_hidden && <Icon name="eye_off" />}
        {facts.faults > 0 && <Icon name={facts.errors > 0 ? 'fault' : 'warning'} />}
      </span>
      {node.hides > 0 && (
        <span aria-hidden="true" className="board-hides">
          +{node.hides}
        </span>
      )}
      {!node.is_end && component?.is_written !== false && (
        <span
          className="board-port"
          data-port={node.key}
          onPointerDown={(event) => gesture.hold(event, 'link', node.key)}
          onClick={(event) => event.stopPropagation()}
        />
      )}
    </div>
  );
}

interface NodeFacts {
  count: number | null; // number of instances, if known
  faults: number;
  errors: number;
  first_fault: string | undefined;
  note: string | undefined;
  is_hidden: boolean;
}

/// Returns facts about a component other than its position.
function use_node_facts(id: string, graph: PlantGraph): NodeFacts {
  const page = use_page();
  const { grown } = use_store(page.growth);
  const { notes } = use_document();
  const view = use_store(page.view_state);
  const own = use_faults(component_path(id), true);
  const link = graph.links.find((one) => one.to === id && one.index !== null)?.index ?? null;
  const of_link = use_faults(link === null ? '-' : link_path(link), true);
  const faults = [...own, ...of_link];
  return {
    count: grown?.placed?.[id] ?? null,
    faults: faults.length,
    errors: faults.filter((one) => one.severity === 'error').length,
    first_fault: faults[0]?.message,
    note: notes[id],
    is_hidden: view.hidden.has(id) || (view.solo !== null && !page.tool(Board).solo_components().has(id)),
  };
}

/// Returns what a screen reader says in addition to name and type.
function spoken_of(node: BoardNode, facts: NodeFacts): string {
  const words = ['', node.is_end ? 'again, where its recursion ends' : ''];
  if (facts.count !== null)
    words.push(facts.count === 1 ? '1 instance' : `${facts.count.toLocaleString('en')} instances`);
  if (facts.is_hidden) words.push('hidden');
  if (node.hides > 0) words.push(`${node.hides} folded away`);
  if (facts.faults > 0) words.push(facts.faults === 1 ? '1 fault' : `${facts.faults} faults`);
  return words.filter((word, k) => k === 0 || word !== '').join(', ');
}

function tip_of(node: BoardNode, facts: NodeFacts, is_written: boolean): string | undefined {
  if (!is_written) return 'The document has no camera, so one is added at its root';
  if (node.is_end) return `Here the recursion leads back to ${node.id}`;
  return facts.first_fault ?? facts.note;
}

/// Returns a count as text that fits on a node: 1,234 or 12k.
function short_count(count: number): string {
  return count < 10_000
    ? count.toLocaleString('en')
    : count < 1e6
      ? `${Math.round(count / 1000)}k`
      : `${(count / 1e6).toFixed(1)}M`;
}
