// SPDX-License-Identifier: Apache-2.0
// Computes positions of the components of a p-graph on the board: a tree whose levels follow from the links, with
// children in the order of the document's links. A component with several parents stands below the deepest one. A
// component to which a recursion leads back is drawn twice, at the beginning and at the end of the recursion. The lines
// between are doubled, as in the source.
//
// Based on: E. Reingold, J. Tilford: Tidier drawings of trees (1981); B. Lintermann, O. Deussen on xfrog (figure 6.7).
// Layered drawings of general graphs were tried. They order children by crossings, not by the document.
import type { GraphLink, PlantGraph } from './plant_graph.ts';

export interface BoardNode {
  key: string; // id of the component; for the end of a recursion, the id with the number of its link
  id: string;
  is_end: boolean; // true: the second node of a recursion's first component
  parent: string | null; // key of the parent node
  level: number;
  across: number; // position of the centre, in widths of a node with its gap
  hides: number; // number of components that are folded below it
}

export interface BoardEdge {
  key: string;
  from: string; // keys of nodes
  to: string;
  link: GraphLink;
  is_doubled: boolean;
}

export interface BoardLayout {
  nodes: BoardNode[];
  edges: BoardEdge[];
  levels: number;
  breadth: number;
}

interface Tree {
  node: BoardNode;
  children: Tree[];
}

const kBetweenTrees = 0.25; // widths between neighbouring subtrees

export function lay_out(graph: PlantGraph, folded: ReadonlySet<string> = new Set()): BoardLayout {
  const level = levels_of(graph);
  const trees = new Map<string, Tree>();
  const edges: BoardEdge[] = [];
  const roots: Tree[] = [];
  const children = children_of(graph, level);
  const nodes: BoardNode[] = [];
  const add = (key: string, id: string, parent: Tree | null, at: number, is_end: boolean): Tree => {
    const node = { key, id, is_end, parent: parent?.node.key ?? null, level: at, across: 0, hides: 0 };
    nodes.push(node);
    const tree = { node, children: [] };
    if (!is_end) trees.set(key, tree);
    return tree;
  };
  // Parents come before children.
  const open: { id: string; parent: Tree | null }[] = graph.roots.map((id) => ({ id, parent: null })).reverse();
  for (let next = open.pop(); next; next = open.pop()) {
    const tree = add(next.id, next.id, next.parent, level.get(next.id) ?? 0, false);
    (next.parent?.children ?? roots).push(tree);
    if (folded.has(next.id)) {
      tree.node.hides = count_below(next.id, children);
      continue;
    }
    open.push(...(children.get(next.id) ?? []).map((id) => ({ id, parent: tree })).reverse());
  }
  for (const [number, link] of graph.links.entries()) {
    const [from, to] = [trees.get(link.from), trees.get(link.to)];
    if (!from || folded.has(link.from)) continue;
    const key = `${number}`;
    if (link.recursion === null) {
      if (to) edges.push({ key, from: link.from, to: link.to, link, is_doubled: is_within(graph, link) });
      continue;
    }
    const end = add(`${link.to}@${number}`, link.to, from, from.node.level + 1, true);
    from.children.push(end);
    edges.push({ key, from: link.from, to: end.node.key, link, is_doubled: true });
  }
  put_in_order(trees, graph);
  const breadth = place(roots);
  return { nodes, edges, levels: 1 + Math.max(0, ...nodes.map((node) => node.level)), breadth };
}

/// Returns the length of the longest path from the root to each component, without links back.
function levels_of(graph: PlantGraph): Map<string, number> {
  const forward = graph.links.filter((link) => link.recursion === null);
  const waits = new Map<string, number>([...graph.components.keys()].map((id) => [id, 0]));
  for (const link of forward) waits.set(link.to, (waits.get(link.to) ?? 0) + 1);
  const level = new Map<string, number>();
  const open = [...waits].filter(([, count]) => count === 0).map(([id]) => id);
  for (const id of open) level.set(id, 0);
  for (let at = open.pop(); at !== undefined; at = open.pop()) {
    for (const link of forward) {
      if (link.from !== at) continue;
      level.set(link.to, Math.max(level.get(link.to) ?? 0, (level.get(at) ?? 0) + 1));
      const left = (waits.get(link.to) ?? 1) - 1;
      waits.set(link.to, left);
      if (left === 0) open.push(link.to);
    }
  }
  return level;
}

/// Returns the children in the tree. A component is a child of the first of its deepest parents.
function children_of(graph: PlantGraph, level: Map<string, number>): Map<string, string[]> {
  const children = new Map<string, string[]>();
  const taken = new Set<string>(graph.roots);
  for (const link of graph.links) {
    if (link.recursion !== null || taken.has(link.to) || (level.get(link.from) ?? 0) + 1 !== level.get(link.to))
      continue;
    taken.add(link.to);
    children.set(link.from, [...(children.get(link.from) ?? []), link.to]);
  }
  return children;
}

function count_below(id: string, children: Map<string, string[]>): number {
  return (children.get(id) ?? []).reduce((sum, one) => sum + 1 + count_below(one, children), 0);
}

/// Returns true if the link lies on the path of a recursion.
function is_within(graph: PlantGraph, link: GraphLink): boolean {
  return graph.recursions.some(({ members }) => {
    const at = members.indexOf(link.from);
    return at >= 0 && members[at + 1] === link.to;
  });
}

/// Sorts children by their links. The ends of recursions are sorted by their links, too.
function put_in_order(trees: Map<string, Tree>, graph: PlantGraph): void {
  const rank = new Map<string, number>();
  for (const [number, link] of graph.links.entries()) {
    const key = link.recursion === null ? link.to : `${link.to}@${number}`;
    rank.set(`${link.from}>${key}`, number);
  }
  for (const [id, tree] of trees) {
    const of = (one: Tree): number => rank.get(`${id}>${one.node.key}`) ?? 0;
    tree.children.sort((a, b) => of(a) - of(b));
  }
}

/// Places all trees side by side. Returns their total width.
function place(roots: Tree[]): number {
  const whole = { node: { level: -1, across: 0 } as BoardNode, children: roots };
  const shape = shape_of(whole);
  const left = Math.min(0, ...shape.left.slice(1));
  spread(whole, 0.5 - left);
  return 1 + Math.max(0, ...shape.right.slice(1)) - left;
}

/// The outline of a subtree by level, relative to its root.
interface Shape {
  left: number[];
  right: number[];
}

/// Sets the positions of children relative to their parents. Returns the outline.
function shape_of(tree: Tree): Shape {
  const shapes = tree.children.map(shape_of);
  const starts: number[] = [];
  const so_far: Shape = { left: [], right: [] };
  for (const [k, shape] of shapes.entries()) {
    const gap = k > 0 && (shape.left.length > 1 || (shapes[k - 1]?.left.length ?? 0) > 1) ? kBetweenTrees : 0;
    const start =
      k === 0
        ? 0
        : Math.max(
            ...shape.left
              .map((left, depth) => (so_far.right[depth] ?? -Infinity) - left + 1 + gap)
              .filter(Number.isFinite),
          );
    starts.push(start);
    for (const [depth, right] of shape.right.entries()) {
      so_far.left[depth] ??= start + (shape.left[depth] ?? 0);
      so_far.right[depth] = start + right;
    }
  }
  const middle = ((starts[0] ?? 0) + (starts.at(-1) ?? 0)) / 2;
  for (const [k, child] of tree.children.entries()) child.node.across = (starts[k] ?? 0) - middle;
  return {
    left: [0, ...so_far.left.map((one) => one - middle)],
    right: [0, ...so_far.right.map((one) => one - middle)],
  };
}

/// Converts positions relative to parents into positions on the board.
function spread(tree: Tree, at: number): void {
  for (const child of tree.children) {
    child.node.across += at;
    spread(child, child.node.across);
  }
}
