// SPDX-License-Identifier: Apache-2.0
// Converts levels and positions of a layout into pixels of the board.
import type { BoardEdge, BoardLayout, BoardNode } from './board_layout.ts';
import type { Direction } from './board_state.ts';
import type { PlantGraph } from './plant_graph.ts';

export const kNode = { width: 108, height: 38 };
const kMargin = 16;
const kSteps: Record<Direction, { level: number; across: number }> = {
  down: { level: 68, across: 120 },
  right: { level: 146, across: 47 },
};

export interface Place {
  x: number; // centre of the node
  y: number;
}

export function place_of(node: BoardNode, direction: Direction): Place {
  const step = kSteps[direction];
  const [along, across] = [node.level * step.level, node.across * step.across];
  if (direction === 'down') return { x: kMargin + across, y: kMargin + kNode.height / 2 + along };
  return { x: kMargin + kNode.width / 2 + along, y: kMargin + across };
}

export function size_of(layout: BoardLayout, direction: Direction): [number, number] {
  const step = kSteps[direction];
  const [along, across] = [(layout.levels - 1) * step.level, layout.breadth * step.across];
  return direction === 'down'
    ? [across + 2 * kMargin, along + kNode.height + 2 * kMargin]
    : [along + kNode.width + 2 * kMargin, across + 2 * kMargin];
}

/// Returns the direction in which the whole board is drawn larger.
export function fitting_direction(layout: BoardLayout, width: number, height: number): Direction {
  const scale = (direction: Direction): number => {
    const [w, h] = size_of(layout, direction);
    return Math.min(1, width / w, height / h);
  };
  return scale('right') > scale('down') ? 'right' : 'down';
}

/// Returns the curve between two nodes.
export function curve_between(from: Place, to: Place, direction: Direction): string {
  const down = direction === 'down';
  const [x1, y1] = down ? [from.x, from.y + kNode.height / 2] : [from.x + kNode.width / 2, from.y];
  const [x2, y2] = down ? [to.x, to.y - kNode.height / 2] : [to.x - kNode.width / 2, to.y];
  const half = down ? Math.max(16, (y2 - y1) / 2) : Math.max(16, (x2 - x1) / 2);
  return down
    ? `M${x1} ${y1}C${x1} ${y1 + half} ${x2} ${y2 - half} ${x2} ${y2}`
    : `M${x1} ${y1}C${x1 + half} ${y1} ${x2 - half} ${y2} ${x2} ${y2}`;
}

/// Returns the neighbour of a node in the direction of an arrow key.
export function neighbour(
  layout: BoardLayout,
  key: string,
  way: 'up' | 'down' | 'before' | 'behind',
): BoardNode | undefined {
  const node = layout.nodes.find((one) => one.key === key);
  if (!node) return layout.nodes[0];
  if (way === 'up') return layout.nodes.find((one) => one.key === node.parent);
  if (way === 'down') {
    const children = layout.nodes.filter((one) => one.parent === key);
    return nearest(children, node.across);
  }
  const level = layout.nodes.filter((one) => one.level === node.level);
  const side = level.filter((one) => (way === 'before' ? one.across < node.across : one.across > node.across));
  return nearest(side, node.across);
}

function nearest(nodes: BoardNode[], across: number): BoardNode | undefined {
  return nodes.reduce<BoardNode | undefined>(
    (best, one) => (best && Math.abs(best.across - across) <= Math.abs(one.across - across) ? best : one),
    undefined,
  );
}

/// Returns a node's siblings including itself, in their order.
export function siblings_of(layout: BoardLayout, key: string): BoardNode[] {
  const node = layout.nodes.find((one) => one.key === key);
  return node
    ? layout.nodes.filter((one) => one.parent === node.parent && !one.is_end).sort((a, b) => a.across - b.across)
    : [];
}

/// Returns true if the order of the document's components determines a component's place on the board. Then no link
/// leads to it, except a link from an added camera.
export function stands_free(graph: PlantGraph, layout: BoardLayout, key: string): boolean {
  const node = layout.nodes.find((one) => one.key === key);
  if (!node || node.is_end || graph.components.get(node.id)?.is_written !== true) return false;
  return node.parent === null || graph.components.get(node.parent)?.is_written === false;
}

/// Returns the edge from a node's parent to the node.
export function edge_above(layout: BoardLayout, key: string): BoardEdge | undefined {
  const node = layout.nodes.find((one) => one.key === key);
  return (
    layout.edges.find((edge) => edge.to === key && edge.from === node?.parent) ??
    layout.edges.find((edge) => edge.to === key)
  );
}
