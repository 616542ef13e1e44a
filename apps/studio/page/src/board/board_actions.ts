// SPDX-License-Identifier: Apache-2.0
// The user's actions on the board. Each action is one edit of the document and one step of the undo list.
import type { Store } from '../base/store.ts';
import type { Page } from '../page/page.ts';
import type { Edit } from '../server/protocol.ts';
import { first_object } from '../tables/tables.ts';
import type { Json } from '../values/json.ts';
import {
  add_edits,
  component_of,
  component_order_edits,
  component_path,
  free_name,
  hang_edits,
  kind_edits,
  link_edit,
  link_of,
  link_path,
  links_from,
  order_edits,
  place_of_link,
  remove_alone_edits,
  remove_edits,
} from './board_edits.ts';
import type { BoardState } from './board_state.ts';
import type { GraphLink, LinkKind, PlantGraph } from './plant_graph.ts';
import { graph_of, held_by, refusal_of_link, usual_kind } from './plant_graph.ts';

export class BoardActions {
  /// `starters` returns the values with which new components begin, by type.
  constructor(
    private readonly page_: Page,
    private readonly state_: Store<BoardState>,
    private readonly starters_: () => Record<string, Json>,
  ) {}

  get graph(): PlantGraph {
    const { tree, implied } = this.page_.document.state.get();
    return graph_of(tree?.value, this.page_.tables.components, implied);
  }

  /// The chosen component. For a chosen link, the component at its end.
  get chosen(): string | null {
    const path = this.page_.chosen.get();
    const link = link_of(path);
    if (link === null) return component_of(path);
    return this.graph.links.find((one) => one.index === link)?.to ?? null;
  }

  choose(id: string): void {
    if (this.graph.components.get(id)?.is_written === false) this.page_.choose('');
    else this.page_.choose(component_path(id));
  }

  usual_kind(from: string, to: string): LinkKind {
    const type = (id: string): string => this.graph.components.get(id)?.type ?? '';
    return usual_kind(this.page_.tables.components, type(from), type(to));
  }

  /// Adds a component of this type below another one, and chooses it.
  async add(type: string, below: string | null, kind: LinkKind): Promise<void> {
    const { graph } = this;
    const table = this.page_.tables.components[type]?.table ?? '';
    const id = free_name(type, graph.components);
    const starter = this.starters_()[type] ?? first_object(this.page_.tables, table);
    await this.make(
      add_edits(this.document, graph, id, { type, ...(starter as object) } as Json, below, kind),
      `Add ${id}`,
      component_path(id),
    );
  }

  /// Adds a whole plant, which is described by another document.
  async add_plant(wanted: string, file: string, below: string | null, kind: LinkKind): Promise<void> {
    const { graph } = this;
    const type =
      Object.entries(this.page_.tables.components).find(([, facts]) => facts.is_whole_plant === true)?.[0] ??
      'document';
    const id = free_name(wanted, graph.components);
    await this.make(add_edits(this.document, graph, id, { type, file }, below, kind), `Add ${id}`, component_path(id));
  }

  /// Links two components, or reports why this is impossible.
  async connect(from: string, to: string, kind: LinkKind = 'child'): Promise<void> {
    const { graph } = this;
    const refused = refusal_of_link(graph, from, to, (id) => this.recursion_of(id));
    if (refused !== null) return this.refuse(from, to, refused);
    if (!graph.components.get(from)?.is_written) {
      return this.refuse(
        from,
        to,
        `${from} stands in no text: the document has no camera, and all that nothing links to hangs on an added one.`,
      );
    }
    const place = place_of_link(this.document, from);
    const faults = await this.make(
      [link_edit(this.document, from, to, kind, place)],
      `Link ${from} to ${to}`,
      link_path(place),
      true,
    );
    if (faults !== null) this.refuse(from, to, faults);
  }

  /// Removes a component with everything that only it holds, and reports the number of removed components.
  async remove(id: string): Promise<void> {
    const { graph } = this;
    const gone = held_by(graph, id);
    const next = this.above(id);
    await this.make(remove_edits(graph, gone, this.notes), `Delete ${id}`, next);
    if (gone.size > 1) this.page_.notify(`Deleted ${id} and ${gone.size - 1} that stood on it`);
  }

  async remove_alone(id: string): Promise<void> {
    await this.make(
      remove_alone_edits(this.document, this.graph, id, this.notes),
      `Delete ${id} alone`,
      this.above(id),
    );
  }

  async remove_link(index: number): Promise<void> {
    const link = this.graph.links.find((one) => one.index === index);
    await this.make(
      [{ remove: link_path(index) }],
      `Delete the link to ${link?.to ?? ''}`,
      link ? component_path(link.from) : '',
    );
  }

  async set_kind(link: GraphLink, kind: LinkKind): Promise<void> {
    await this.make(kind_edits(this.document, link, kind), `Make the link to ${link.to} a ${kind} link`);
  }

  /// Moves a link earlier (-1) or later (1) among the links of its parent.
  async shift(link: GraphLink, by: number): Promise<void> {
    await this.put(link, links_from(this.graph, link.from).findIndex((one) => one.index === link.index) + by);
  }

  async put(link: GraphLink, place: number): Promise<void> {
    const { graph } = this;
    const own = graph.links.find((one) => one.index === link.index);
    const edits = own ? order_edits(graph, own, place) : [];
    const path =
      edits[0] && 'move' in edits[0] && link_of(this.page_.chosen.get()) === link.index
        ? link_path(edits[0].index)
        : undefined;
    if (edits.length > 0) await this.make(edits, `Move ${link.to} among its siblings`, path);
  }

  /// Moves a component to this place among others in the document's text, with its comments.
  async put_component(id: string, among: readonly string[], place: number): Promise<void> {
    await this.make(component_order_edits(this.document, among, id, place), `Move ${id} in the document`);
  }

  /// Moves a component earlier (-1) or later (1) among these components, by default among all of the document.
  async shift_component(id: string, by: number, among = this.written_components): Promise<void> {
    await this.put_component(id, among, among.indexOf(id) + by);
  }

  /// The components that the document contains, in their order.
  get written_components(): string[] {
    return [...this.graph.components.values()].filter((one) => one.is_written).map((one) => one.id);
  }

  /// Moves a component to another parent.
  async hang(link: GraphLink, from: string): Promise<void> {
    const { graph } = this;
    const without = { ...graph, links: graph.links.filter((one) => one !== link && one.index !== link.index) };
    const refused = refusal_of_link(without, from, link.to, (id) => this.recursion_of(id));
    if (refused !== null) return this.refuse(from, link.to, refused);
    const faults = await this.make(
      hang_edits(this.document, link, from),
      `Hang ${link.to} on ${from}`,
      undefined,
      true,
    );
    if (faults !== null) this.refuse(from, link.to, faults);
  }

  async rename(id: string, name: string): Promise<void> {
    this.state_.merge({ renaming: null });
    if (name === id || name === '') return;
    const faults = await this.make([{ rename: component_path(id), name }], `Rename ${id}`, component_path(name));
    if (faults === null) this.page_.notify(`${name} has its chance drawn anew: random numbers follow the name`);
  }

  async note(id: string, text: string): Promise<void> {
    this.state_.merge({ noting: null });
    if (text.trim() !== (this.notes[id] ?? ''))
      await this.make([{ note: component_path(id), text: text.trim() }], `Note on ${id}`);
  }

  fold(id: string): void {
    const folded = new Set(this.state_.get().folded);
    if (!folded.delete(id)) folded.add(id);
    this.state_.merge({ folded });
  }

  hide(id: string): void {
    const hidden = new Set(this.page_.view_state.get().hidden);
    if (!hidden.delete(id)) hidden.add(id);
    this.page_.change_view({ hidden });
  }

  solo(id: string): void {
    const now = this.page_.view_state.get().solo;
    this.page_.change_view({ solo: now === id ? null : id });
  }

  refuse(from: string, to: string, reason: string): void {
    const refused = { from, to, reason };
    this.state_.merge({ refused, connecting: null });
    setTimeout(() => {
      if (this.state_.get().refused === refused) this.state_.merge({ refused: null });
    }, 8000);
  }

  get document(): Json | undefined {
    return this.page_.document.state.get().tree?.value;
  }

  private get notes(): Record<string, string> {
    return this.page_.document.state.get().notes;
  }

  recursion_of(id: string): number {
    const value = (this.document as Record<string, Record<string, Record<string, Json>>> | undefined)?.['components']?.[
      id
    ]?.['recursion'];
    return typeof value === 'number' ? value : 1;
  }

  private above(id: string): string {
    const link = this.graph.links.find((one) => one.to === id && one.from !== id);
    const parent = link ? this.graph.components.get(link.from) : undefined;
    return parent?.is_written ? component_path(parent.id) : '';
  }

  /// Makes the edits as one step and then chooses a path. Returns what was wrong, or null.
  async make(edits: Edit[], label: string, choose?: string, only_if_good = false): Promise<string | null> {
    if (edits.length === 0) return null;
    this.state_.merge({ refused: null, connecting: null });
    const faults = await this.page_.edit(edits, label, { only_if_good, choose });
    return faults === null ? null : (faults[0]?.message ?? 'The document does not allow it.');
  }
}
