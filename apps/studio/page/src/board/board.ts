// SPDX-License-Identifier: Apache-2.0
// The board's side of the page's model: what it shows, and what hands do on it.
import { Store } from '../base/store.ts';
import type { Json } from '../document/json.ts';
import type { Studio } from '../studio.ts';
import { BoardActions } from './board_actions.ts';
import type { BoardState } from './board_state.ts';
import { kEmptyBoard } from './board_state.ts';
import { Gardens } from './gardens.ts';
import { PartActions } from './part_actions.ts';
import { standing_on } from './plant_graph.ts';

export class Board {
  readonly state = new Store<BoardState>(kEmptyBoard);
  readonly fits = new Store(0); // counts how often the board was to be fitted
  readonly actions: BoardActions;
  readonly parts: PartActions;
  readonly gardens: Gardens;
  /// What components begin with that would have faults without anything, by type.
  starters: Record<string, Json> = {};

  constructor(private readonly studio_: Studio) {
    this.actions = new BoardActions(studio_);
    this.parts = new PartActions(studio_, this.actions);
    this.gardens = new Gardens(studio_);
  }

  /// Another document is open.
  begin(): void {
    this.state.set(kEmptyBoard);
    this.fit();
  }

  fit(): void {
    this.fits.set(this.fits.get() + 1);
  }

  /// Those of all components that are drawn which are not to be seen.
  hidden_components(drawn: string[]): ReadonlySet<string> {
    const { hidden, solo } = this.studio_.view_state.get();
    if (solo === null) return hidden;
    const shown = this.solo_components();
    return new Set([...hidden, ...drawn.filter((one) => !shown.has(one))]);
  }

  /// The component that is drawn alone, with all that stands on it; nothing where none is.
  solo_components(): ReadonlySet<string> {
    const { solo } = this.studio_.view_state.get();
    return solo === null ? new Set() : standing_on(this.actions.graph, solo);
  }
}
