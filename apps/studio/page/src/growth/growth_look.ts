// SPDX-License-Identifier: Apache-2.0
// A growth that is looked at: which step the view shows, and what is drawn over it. The server records the growth while
// somebody looks, and gives each step of it without growing anew.
import { Store } from '../base/store.ts';
import { LatestSender } from '../server/latest_sender.ts';
import type { OverlayLayers, OverlayPart } from '../server/growth_protocol.ts';
import type { PacketArrays } from '../server/packet.ts';
import type { Grown } from '../server/protocol.ts';
import { Refusal } from '../server/protocol.ts';
import type { Studio } from '../studio.ts';
import type { LegendKey } from './layers.ts';
import { view_layer } from './layers.ts';

export interface GrowthLookState {
  is_open: boolean;
  step: number | null; // that is asked for; null: the last
  steps: number | null; // that the growth took; null: not known yet
  of: string | null; // component whose plants the step is for; null: all
  growing: Readonly<Record<string, number>>; // steps of the plants of each component
  parts: readonly string[]; // names of the overlays that are shown
  legend: readonly LegendKey[];
}

const kAtRest: GrowthLookState = { is_open: false, step: null, steps: null, of: null, growing: {}, parts: [], legend: [] };

export class GrowthLook {
  readonly state = new Store<GrowthLookState>(kAtRest);
  private heard_: Grown | null = null;
  private readonly views_ = new LatestSender(() => this.studio_.connection.request('view', { growth: this.wish }));
  private readonly overlays_ = new LatestSender(() => this.fetch());

  constructor(private readonly studio_: Studio) {
    studio_.growth.subscribe(() => this.hear(studio_.growth.get().grown));
    // A server that is there again knows nothing of it.
    studio_.server.subscribe(() => {
      if (studio_.server.get().link === 'open' && this.state.get().is_open) this.views_.ask();
    });
  }

  /// The overlays that the server knows.
  get known(): readonly OverlayPart[] {
    return this.studio_.server.get().hello?.overlays ?? [];
  }

  toggle(): void {
    if (this.state.get().is_open) this.close();
    else this.open();
  }

  open(): void {
    this.state.merge({ is_open: true });
    this.views_.ask();
  }

  /// The plant as it is after all steps again, with nothing over it.
  close(): void {
    this.clear_layers();
    this.state.set(kAtRest);
    this.views_.ask();
  }

  show_step(step: number): void {
    const { steps } = this.state.get();
    const wanted = Math.max(0, Math.round(step));
    this.state.merge({ step: steps !== null && wanted >= steps ? null : wanted });
    this.views_.ask();
  }

  /// Goes through the steps of one component's plants, those that it grows or places, or of all side by side.
  look_at(of: string | null): void {
    if (of === this.state.get().of) return;
    this.state.merge({ of, step: null, steps: null });
    this.views_.ask();
  }

  switch_part(name: string): void {
    const { parts } = this.state.get();
    this.state.merge({ parts: parts.includes(name) ? parts.filter((one) => one !== name) : [...parts, name] });
    if (parts.includes(name)) this.studio_.view?.overlays.put(layer_name(name), null);
    this.overlays_.ask();
  }

  /// Another document is opened: its growth is not looked at yet.
  clear(): void {
    const was_open = this.state.get().is_open;
    this.clear_layers();
    this.state.set(kAtRest);
    if (was_open) this.views_.ask();
  }

  private get wish(): { step: number | null; recorded: boolean; of: string | null } {
    const { is_open, step, of } = this.state.get();
    return { step, recorded: is_open, of };
  }

  /// Each growth, and each step of one, has overlays of its own.
  private hear(grown: Grown | null): void {
    if (grown === this.heard_) return;
    this.heard_ = grown;
    if (!grown || !this.state.get().is_open) return;
    const { of } = this.state.get();
    if (grown.growing) this.state.merge({ growing: grown.growing });
    if (of !== null && grown.growing && !(of in grown.growing)) return this.look_at(null); // it is there no more
    if (grown.steps !== null) this.state.merge({ steps: grown.steps });
    if (this.state.get().parts.length > 0) this.overlays_.ask();
  }

  private async fetch(): Promise<void> {
    const { parts, is_open } = this.state.get();
    if (!is_open) return;
    if (parts.length === 0) return this.state.merge({ legend: [] });
    const answer = await this.studio_.connection.request<{ overlays: OverlayLayers; arrays: PacketArrays }>('overlays', { parts }).catch((fault: unknown) => {
      if (fault instanceof Refusal) this.studio_.tell(fault.message, true, 'overlays');
    });
    if (!answer) return;
    const { overlays, arrays } = answer;
    const wanted = this.state.get().parts;
    const shown = overlays.layers.filter((layer) => wanted.includes(layer.part));
    for (const layer of shown) this.studio_.view?.overlays.put(layer_name(layer.part), view_layer(layer, arrays));
    this.state.merge({ legend: shown.flatMap((layer) => layer.legend) });
  }

  private clear_layers(): void {
    for (const { name } of this.known) this.studio_.view?.overlays.put(layer_name(name), null);
  }
}

function layer_name(part: string): string {
  return `growth.${part}`;
}
