// SPDX-License-Identifier: Apache-2.0
// Copies, pastes and duplicates parts of plants, and adds parts of shipped plants.

import type { Page } from '../page/page.ts';
import type { Edit, PartAnswer } from '../server/protocol.ts';
import type { BoardActions } from './board_actions.ts';
import { component_path, copied_link, free_name, link_edit, place_behind, place_of_link } from './board_edits.ts';
import type { LinkKind, PlantGraph } from './plant_graph.ts';
import { standing_on } from './plant_graph.ts';

export class PartActions {
  private clip_: PartAnswer | null = null; // the part that was copied last

  constructor(
    private readonly page_: Page,
    private readonly actions_: BoardActions,
  ) {}

  /// Returns a component as a part that can be pasted elsewhere, with its descendants or alone.
  part(id: string, alone = false): Promise<PartAnswer | null> {
    return this.part_of(this.actions_.graph, id, alone);
  }

  /// Like `part`, for a shipped model with this graph.
  async part_of(graph: PlantGraph, id: string, alone = false, model?: string): Promise<PartAnswer | null> {
    const all = alone ? new Set([id]) : standing_on(graph, id);
    const components = [...graph.components.values()]
      .filter((one) => all.has(one.id) && one.is_written && !one.is_camera)
      .map((one) => one.id);
    try {
      return await this.page_.connection.request('part', {
        components,
        ...(model === undefined ? {} : { model }),
      });
    } catch (fault) {
      if (fault instanceof Error) this.page_.notify(fault.message, true);
      return null;
    }
  }

  /// Pastes a part below a component, with free names.
  async paste(
    part: PartAnswer,
    below: string | null,
    label: string,
    kinds: Record<string, LinkKind> = {},
  ): Promise<void> {
    const { graph, document } = this.actions_;
    const taken = new Set(graph.components.keys());
    const names: Record<string, string> = {};
    for (const one of part.components) {
      names[one] = free_name(one, taken);
      taken.add(names[one]);
    }
    const parent = below === null ? undefined : graph.components.get(below);
    const place = place_of_link(document, below ?? '');
    const edits: Edit[] = [{ paste: part.text, names, index: place_behind(document, graph, below), link_index: place }];
    if (parent?.is_written)
      for (const root of [...part.roots].reverse())
        edits.push(link_edit(document, parent.id, names[root] ?? root, kinds[root] ?? 'child', place));
    const first = part.roots[0];
    await this.actions_.make(edits, label, first === undefined ? undefined : component_path(names[first] ?? first));
  }

  /// Copies a component without its children. The copy has the component's parents.
  async duplicate(id: string): Promise<void> {
    const part = await this.part(id, true);
    if (!part) return;
    const { graph, document } = this.actions_;
    const name = free_name(id, graph.components);
    const parents = graph.links.filter((link) => link.to === id && link.from !== id && link.index !== null);
    const ids = [...graph.components.keys()].filter((one) => graph.components.get(one)?.is_written);
    const edits: Edit[] = [{ paste: part.text, names: { [id]: name }, index: ids.indexOf(id) + 1 }];
    // The last link is copied first, so that other indices stay valid.
    for (const parent of [...parents].reverse()) edits.push(...copied_link(document, parent, name));
    await this.actions_.make(edits, `Duplicate ${id}`, component_path(name));
  }

  async copy(id: string): Promise<void> {
    const part = await this.part(id);
    if (!part) return;
    this.clip_ = part;
    await navigator.clipboard.writeText(part.text).catch(() => undefined);
    this.page_.notify(
      part.components.length > 1 ? `Copied ${id} and ${part.components.length - 1} that stand on it` : `Copied ${id}`,
    );
  }

  /// Pastes the part that was copied here or in another tab, below a component.
  async paste_clip(below: string | null): Promise<void> {
    const text = await navigator.clipboard.readText().catch(() => '');
    const own = this.clip_;
    if (own && (text === '' || text.replaceAll('\r\n', '\n') === own.text.replaceAll('\r\n', '\n')))
      return this.paste(own, below, `Paste ${own.roots.join(', ')}`);
    if (text === '') return this.page_.notify('Nothing was copied yet', true);
    try {
      const part = await this.page_.connection.request('part', { text });
      await this.paste(part, below, `Paste ${part.roots.join(', ')}`);
    } catch {
      this.page_.notify('What was copied is no part of a plant', true);
    }
  }
}
