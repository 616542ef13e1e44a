// SPDX-License-Identifier: Apache-2.0
// The p-graph of a document, read from its text: components, links, and links back to an ancestor. It exists even while
// the text has faults. Facts that only the library knows, such as components that a grammar places, are passed in.

import type { Tables } from '../tables/tables.ts';
import type { Json } from '../values/json.ts';
import { is_object } from '../values/json.ts';
import { member_of } from '../values/path.ts';

export type LinkKind = 'child' | 'branch' | 'leaf' | 'crown' | 'placed';

export interface GraphComponent {
  id: string;
  type: string;
  is_camera: boolean;
  is_written: boolean; // false: the library has added the camera
}

export interface GraphLink {
  from: string;
  to: string;
  kind: LinkKind;
  index: number | null; // index in the document's links; null: the document has no such link
  recursion: number | null; // index of the graph's recursion for a link back; else null
}

/// A link back, and the path from the ancestor down to the beginning of the link.
export interface Recursion {
  head: string;
  members: string[];
}

export interface PlantGraph {
  components: Map<string, GraphComponent>;
  links: GraphLink[]; // links of one component are adjacent, in the document's order
  roots: string[]; // the camera, then components that cannot be reached from it
  recursions: Recursion[];
}

export interface ImpliedLink {
  from: string;
  to: string;
}

const kKinds = new Set<string>(['child', 'branch', 'leaf', 'crown']);
const kAddedCamera = 'camera';

export function ends_of(link: Json | undefined): [string, string] {
  const ends = Array.isArray(link) ? link : [member_of(link, 'from'), member_of(link, 'to')];
  return [String(ends[0] ?? ''), String(ends[1] ?? '')];
}

/// Returns the usual kind of a new link between components of these types. Leaves and multipliers stand along stems.
export function usual_kind(types: Tables['components'], from: string, to: string): LinkKind {
  return types[from]?.makes_stems === true && types[to]?.makes_stems !== true ? 'branch' : 'child';
}

function kind_of(link: Json | undefined): LinkKind {
  const kind = member_of(link, 'kind');
  return typeof kind === 'string' && kKinds.has(kind) ? (kind as LinkKind) : 'child';
}

export function graph_of(
  document: Json | undefined,
  types: Tables['components'],
  implied: readonly ImpliedLink[] = [],
): PlantGraph {
  const components = new Map<string, GraphComponent>();
  const said = member_of(document, 'components');
  for (const id of is_object(said) ? Object.keys(said) : []) {
    const type = String(member_of(member_of(said, id), 'type') ?? '');
    components.set(id, { id, type, is_camera: types[type]?.is_camera === true, is_written: true });
  }
  const written = member_of(document, 'links');
  const links: GraphLink[] = [];
  for (const [index, link] of (Array.isArray(written) ? written : []).entries()) {
    const [from, to] = ends_of(link);
    if (components.has(from) && components.has(to))
      links.push({ from, to, kind: kind_of(link), index, recursion: null });
  }
  for (const { from, to } of implied) {
    if (components.has(from) && components.has(to))
      links.push({ from, to, kind: 'placed', index: null, recursion: null });
  }
  add_camera(components, links);
  return with_recursions(components, links);
}

/// Adds a camera if the document has none. The camera links to all components without a parent.
function add_camera(components: Map<string, GraphComponent>, links: GraphLink[]): void {
  if ([...components.values()].some((one) => one.is_camera) || components.size === 0) return;
  let id = kAddedCamera;
  while (components.has(id)) id += '_';
  const below = new Set(links.map((link) => link.to));
  const first = [...components.keys()].filter((one) => !below.has(one));
  components.set(id, { id, type: 'camera', is_camera: true, is_written: false });
  const reached = new Set<string>();
  const link_to = (to: string): void => {
    links.push({ from: id, to, kind: 'child', index: null, recursion: null });
    for (const one of reached_from(to, links)) reached.add(one);
  };
  first.forEach(link_to);
  // A circle has no first component, so the camera links to its first component in the document.
  for (const one of components.keys()) if (one !== id && !reached.has(one)) link_to(one);
}

export function reached_from(start: string, links: readonly GraphLink[]): Set<string> {
  const reached = new Set([start]);
  const open = [start];
  for (let from = open.pop(); from !== undefined; from = open.pop()) {
    for (const link of links) {
      if (link.from !== from || reached.has(link.to)) continue;
      reached.add(link.to);
      open.push(link.to);
    }
  }
  return reached;
}

/// Walks depth-first from each root. A link to a component on the present path is a link back.
function with_recursions(components: Map<string, GraphComponent>, all: GraphLink[]): PlantGraph {
  const outgoing = new Map<string, GraphLink[]>([...components.keys()].map((id) => [id, []]));
  for (const link of all) outgoing.get(link.from)?.push(link);
  const graph: PlantGraph = { components, links: [], roots: [], recursions: [] };
  const done = new Set<string>();
  const below = new Set(all.map((link) => link.to));
  const visit = (root: string): void => {
    if (done.has(root)) return;
    graph.roots.push(root);
    const way = [{ id: root, next: 0 }];
    done.add(root);
    for (let top = way.at(-1); top; top = way.at(-1)) {
      const link = outgoing.get(top.id)?.[top.next];
      top.next += 1;
      if (!link) {
        way.pop();
        continue;
      }
      const at = way.findIndex((one) => one.id === link.to);
      if (at >= 0) {
        link.recursion = graph.recursions.length;
        graph.recursions.push({ head: link.to, members: way.slice(at).map((one) => one.id) });
      } else if (!done.has(link.to)) {
        done.add(link.to);
        way.push({ id: link.to, next: 0 });
      }
    }
  };
  const ids = [...components.values()];
  for (const one of ids) if (one.is_camera) visit(one.id);
  for (const one of ids) if (!below.has(one.id)) visit(one.id);
  for (const one of ids) visit(one.id);
  graph.links = [...outgoing.values()].flat();
  return graph;
}

/// Returns the reason why the document cannot have a link, or null. `recursion_of` returns the recursion of a
/// component.
export function refusal_of_link(
  graph: PlantGraph,
  from: string,
  to: string,
  recursion_of: (id: string) => number,
): string | null {
  const target = graph.components.get(to);
  if (!target || !graph.components.has(from)) return 'A link joins two components.';
  if (target.is_camera) return `${to} is the camera, the root of all links: nothing leads to it.`;
  if (graph.links.some((link) => link.from === from && link.to === to && link.index !== null))
    return `${from} links to ${to} already.`;
  const way = way_between(graph, to, from);
  if (!way || recursion_of(to) >= 2) return null;
  const links = [...way, to].join(' > ');
  return `The links ${links} would form an endless circle. A recursion of at least 2 in ${to} allows it.`;
}

/// Returns the components on a path from one component down to another, both included. Returns null if no links lead
/// there.
export function way_between(graph: PlantGraph, from: string, to: string): string[] | null {
  const before = new Map<string, string | null>([[from, null]]);
  const open = [from];
  for (let at = open.shift(); at !== undefined; at = open.shift()) {
    if (at === to) break;
    for (const link of graph.links) {
      if (link.from !== at || before.has(link.to)) continue;
      before.set(link.to, at);
      open.push(link.to);
    }
  }
  if (!before.has(to)) return null;
  const way: string[] = [];
  for (let at: string | null = to; at !== null; at = before.get(at) ?? null) way.unshift(at);
  return way;
}

/// Returns a component with all its descendants.
export function standing_on(graph: PlantGraph, id: string): Set<string> {
  return reached_from(id, graph.links);
}

/// Returns a component with the descendants that no other component holds.
export function held_by(graph: PlantGraph, id: string): Set<string> {
  const left = new Set<string>();
  const open = graph.roots.filter((root) => root !== id);
  for (let at = open.pop(); at !== undefined; at = open.pop()) {
    if (left.has(at)) continue;
    left.add(at);
    for (const link of graph.links) if (link.from === at && link.to !== id) open.push(link.to);
  }
  return new Set([...standing_on(graph, id)].filter((one) => !left.has(one)));
}
