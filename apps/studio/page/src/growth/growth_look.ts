// SPDX-License-Identifier: Apache-2.0
// The growth that is examined: the step that the view shows, and the overlays on it. The server records the growth
// meanwhile, and shows each step without a new growth.
import { Store } from '../base/store.ts';
import type { Page } from '../page/page.ts';
import { LatestSender } from '../server/latest_sender.ts';
import type { Grown, OverlayPart } from '../server/protocol.ts';
import { Refusal } from '../server/protocol.ts';
import type { LegendKey } from './layers.ts';
import { view_layer } from './layers.ts';

export interface GrowthLookState {
  is_open: boolean;
  step: number | null; // requested step; null: the last
  steps: number | null; // number of steps of the growth; null: not known yet
  of: string | null; // component whose plants the step is for; null: all
  growing: Readonly<Record<string, number>>; // number of steps of each component's plants
  parts: readonly string[]; // names of the shown overlays
  legend: readonly LegendKey[];
}

const kAtRest: GrowthLookState = {
  is_open: false,
  step: null,
  steps: null,
  of: null,
  growing: {},
  parts: [],
  legend: [],
};

export class GrowthLook {
  readonly state = new Store<GrowthLookState>(kAtRest);
  private known_grown_: Grown | null = null;
  private readonly views_ = new LatestSender(() => this.page_.connection.request('view', { growth: this.request }));
  private readonly overlays_ = new LatestSender(() => this.fetch());

  constructor(private readonly page_: Page) {
    page_.growth.subscribe(() => this.on_grown(page_.growth.get().grown));
    // A server that is connected again does not know the step.
    page_.server.subscribe(() => {
      if (page_.server.get().link === 'open' && this.state.get().is_open) this.views_.ask();
    });
  }

  /// The overlays that the server offers.
  get known(): readonly OverlayPart[] {
    return this.page_.server.get().hello?.overlays ?? [];
  }

  toggle(): void {
    if (this.state.get().is_open) this.close();
    else this.open();
  }

  open(): void {
    this.state.merge({ is_open: true });
    this.views_.ask();
  }

  /// Shows the plant after all steps again, without overlays.
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

  /// Shows the steps of one component's plants, which it grows or places, or of all plants together.
  look_at(of: string | null): void {
    if (of === this.state.get().of) return;
    this.state.merge({ of, step: null, steps: null });
    this.views_.ask();
  }

  switch_part(name: string): void {
    const { parts } = this.state.get();
    this.state.merge({ parts: parts.includes(name) ? parts.filter((one) => one !== name) : [...parts, name] });
    if (parts.includes(name)) this.page_.view?.overlays.put(layer_name(name), null);
    this.overlays_.ask();
  }

  /// Resets the growth for another document.
  clear(): void {
    const was_open = this.state.get().is_open;
    this.clear_layers();
    this.state.set(kAtRest);
    if (was_open) this.views_.ask();
  }

  private get request(): { step: number | null; recorded: boolean; of: string | null } {
    const { is_open, step, of } = this.state.get();
    return { step, recorded: is_open, of };
  }

  /// Requests new overlays after each growth and for each step.
  private on_grown(grown: Grown | null): void {
    if (grown === this.known_grown_) return;
    this.known_grown_ = grown;
    if (!grown || !this.state.get().is_open) return;
    const { of } = this.state.get();
    if (grown.growing) this.state.merge({ growing: grown.growing });
    // The component no longer exists
    if (of !== null && grown.growing && !(of in grown.growing)) return this.look_at(null);
    if (grown.steps !== null) this.state.merge({ steps: grown.steps });
    if (this.state.get().parts.length > 0) this.overlays_.ask();
  }

  private async fetch(): Promise<void> {
    const { parts, is_open } = this.state.get();
    if (!is_open) return;
    if (parts.length === 0) return this.state.merge({ legend: [] });
    const answer = await this.page_.connection.request('overlays', { parts }).catch((fault: unknown) => {
      if (fault instanceof Refusal) this.page_.notify(fault.message, true, 'overlays');
    });
    if (!answer) return;
    const { overlays, arrays } = answer;
    const wanted = this.state.get().parts;
    const shown = overlays.layers.filter((layer) => wanted.includes(layer.part));
    for (const layer of shown) this.page_.view?.overlays.put(layer_name(layer.part), view_layer(layer, arrays));
    this.state.merge({ legend: shown.flatMap((layer) => layer.legend) });
  }

  private clear_layers(): void {
    for (const { name } of this.known) this.page_.view?.overlays.put(layer_name(name), null);
  }
}

function layer_name(part: string): string {
  return `growth.${part}`;
}
