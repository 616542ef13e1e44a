// SPDX-License-Identifier: Apache-2.0
// Actions on the board as edits of the document. New parts are written where a reader would look for them: a component
// after its siblings, a link after the other links of its parent.

import type { Edit } from '../server/protocol.ts';
import type { Json } from '../values/json.ts';
import { is_object } from '../values/json.ts';
import { member_of, path_below } from '../values/path.ts';
import type { GraphLink, LinkKind, PlantGraph } from './plant_graph.ts';
import { ends_of, held_by, standing_on } from './plant_graph.ts';

export function component_path(id: string): string {
  return path_below('components', id);
}

export function link_path(index: number): string {
  return path_below('links', index);
}

/// Returns the component that contains a path, or null.
export function component_of(path: string): string | null {
  const found = /^components(?:\.([^.[]+)|\["((?:[^"\\]|\\.)*)"\])/.exec(path);
  return found ? (found[1] ?? found[2] ?? null) : null;
}

/// Returns the index of the link that contains a path, or null.
export function link_of(path: string): number | null {
  const found = /^links\[(\d+)\]/.exec(path);
  return found ? Number(found[1]) : null;
}

/// Returns a free name: the wanted one, if necessary with a number at its end.
export function free_name(wanted: string, taken: { has(name: string): boolean }): string {
  const plain = wanted.replace(/[^A-Za-z0-9_]/g, '_') || 'part';
  if (!taken.has(plain)) return plain;
  const stem = plain.replace(/_\d+$/, '');
  for (let k = 2; ; k += 1) if (!taken.has(`${stem}_${k}`)) return `${stem}_${k}`;
}

export function written_link(from: string, to: string, kind: LinkKind): Json {
  return kind === 'child' || kind === 'placed' ? [from, to] : { from, to, kind };
}

function listed_links(document: Json | undefined): Json[] {
  const links = member_of(document, 'links');
  return Array.isArray(links) ? links : [];
}

/// Returns the index for a new link of a component: after its other links, else after the links to it, else last.
export function place_of_link(document: Json | undefined, from: string): number {
  const ends = listed_links(document).map(ends_of);
  const last = (end: 0 | 1): number => ends.map((one) => one[end]).lastIndexOf(from);
  const at = last(0) >= 0 ? last(0) : last(1);
  return at < 0 ? ends.length : at + 1;
}

/// Returns the edit that inserts a link at this index.
export function link_edit(
  document: Json | undefined,
  from: string,
  to: string,
  kind: LinkKind,
  place = place_of_link(document, from),
): Edit {
  return { insert: link_path(place), value: written_link(from, to, kind) };
}

/// Returns the index after a component and its descendants, among the document's components.
export function place_behind(document: Json | undefined, graph: PlantGraph, id: string | null): number {
  const said = member_of(document, 'components');
  const ids = is_object(said) ? Object.keys(said) : [];
  if (id === null || !ids.includes(id)) return ids.length;
  // All components descend from the camera, so new ones come last.
  const below = standing_on(graph, id);
  return 1 + Math.max(...ids.map((one, k) => (below.has(one) ? k : -1)));
}

/// Returns the edits that add a component. Its link is added if the document contains the parent.
export function add_edits(
  document: Json | undefined,
  graph: PlantGraph,
  id: string,
  value: Json,
  below: string | null,
  kind: LinkKind,
): Edit[] {
  const parent = below === null ? undefined : graph.components.get(below);
  const is_first = !is_object(member_of(document, 'components'));
  const add: Edit = is_first
    ? { set: 'components', value: { [id]: value } }
    : { insert: component_path(id), value, index: place_behind(document, graph, below) };
  return parent?.is_written ? [add, link_edit(document, parent.id, id, kind)] : [add];
}

/// Returns the edits that remove components with their links and notes. The last ones are removed first, so that other
/// indices stay valid.
export function remove_edits(graph: PlantGraph, ids: Iterable<string>, notes: Record<string, string>): Edit[] {
  const written = [...graph.components.keys()].filter((id) => graph.components.get(id)?.is_written);
  const gone = new Set(ids);
  const edits: Edit[] = [];
  for (const id of written.reverse()) {
    if (!gone.has(id)) continue;
    if (notes[id] !== undefined) edits.push({ note: component_path(id), text: '' });
    edits.push({ remove: component_path(id) });
  }
  return edits;
}

/// Returns the edits that remove one component. Its children move to its parents.
export function remove_alone_edits(
  document: Json | undefined,
  graph: PlantGraph,
  id: string,
  notes: Record<string, string>,
): Edit[] {
  const held = held_by(graph, id);
  const orphans = graph.links.filter(
    (link) => link.from === id && link.to !== id && held.has(link.to) && link.index !== null,
  );
  const parents = graph.links.filter((link) => link.to === id && link.from !== id && link.index !== null);
  // The last link is edited first, so that other indices stay valid.
  const edits: Edit[] = [];
  for (const parent of [...parents].reverse()) {
    for (const orphan of [...orphans].reverse())
      edits.push(link_edit(document, parent.from, orphan.to, orphan.kind, (parent.index ?? 0) + 1));
  }
  return [...edits, ...remove_edits(graph, [id], notes)];
}

/// Changes the kind of a link. Keys that only the old kind has are removed.
export function kind_edits(document: Json | undefined, link: GraphLink, kind: LinkKind): Edit[] {
  if (link.index === null || link.kind === kind) return [];
  const said = listed_links(document)[link.index];
  if (is_object(said) && kind !== 'child') {
    const foreign = Object.keys(said).filter((name) => !['from', 'to', 'kind'].includes(name) && said['kind'] !== kind);
    const path = link_path(link.index);
    return [
      ...foreign.map((name): Edit => ({ unset: path_below(path, name) })),
      { set: path_below(path, 'kind'), value: kind },
    ];
  }
  return [{ set: link_path(link.index), value: written_link(link.from, link.to, kind) }];
}

/// Returns the links of one component in the order of the document.
export function links_from(graph: PlantGraph, from: string): GraphLink[] {
  return graph.links
    .filter((link) => link.from === from && link.index !== null)
    .sort((a, b) => (a.index ?? 0) - (b.index ?? 0));
}

/// Moves a link to this place among the links of its parent.
export function order_edits(graph: PlantGraph, link: GraphLink, place: number): Edit[] {
  const all = links_from(graph, link.from);
  const at = all.indexOf(link);
  const target = all[Math.min(all.length - 1, Math.max(0, place))];
  if (at < 0 || !target || target === link || link.index === null || target.index === null) return [];
  return [{ move: link_path(link.index), index: target.index }];
}

/// Moves a component to this place among some of the document's components. The order of all others stays.
export function component_order_edits(
  document: Json | undefined,
  among: readonly string[],
  id: string,
  place: number,
): Edit[] {
  const said = member_of(document, 'components');
  const ids = is_object(said) ? Object.keys(said) : [];
  const others = among.filter((one) => one !== id && ids.includes(one));
  if (!ids.includes(id) || others.length === 0) return [];
  const at = Math.min(others.length, Math.max(0, place));
  if (at === among.filter((one) => one === id || others.includes(one)).indexOf(id)) return [];
  const without = ids.filter((one) => one !== id);
  const behind = others[at];
  const index = behind === undefined ? without.indexOf(others.at(-1) ?? '') + 1 : without.indexOf(behind);
  return index === ids.indexOf(id) ? [] : [{ move: component_path(id), index }];
}

/// Sets the parent of a link.
export function hang_edits(document: Json | undefined, link: GraphLink, from: string): Edit[] {
  if (link.index === null) return [];
  const said = listed_links(document)[link.index];
  return [
    {
      set: Array.isArray(said) ? path_below(link_path(link.index), 0) : path_below(link_path(link.index), 'from'),
      value: from,
    },
  ];
}

/// Copies a link with another end. The copy follows the link.
export function copied_link(document: Json | undefined, link: GraphLink, to: string): Edit[] {
  if (link.index === null) return [];
  const said = listed_links(document)[link.index];
  const value: Json = is_object(said) ? { ...said, to } : [link.from, to];
  return [{ insert: link_path(link.index + 1), value }];
}
