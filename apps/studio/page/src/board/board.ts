// SPDX-License-Identifier: Apache-2.0
// The state of the board, and the actions on it.
import { Store } from '../base/store.ts';
import type { Page } from '../page/page.ts';
import type { Json } from '../values/json.ts';
import { BoardActions } from './board_actions.ts';
import type { BoardState } from './board_state.ts';
import { kEmptyBoard } from './board_state.ts';
import { Gardens } from './gardens.ts';
import { PartActions } from './part_actions.ts';
import { standing_on } from './plant_graph.ts';

export class Board {
  readonly state = new Store<BoardState>(kEmptyBoard);
  readonly fits = new Store(0); // a counter; the board is fitted to the window when it changes
  readonly actions: BoardActions;
  readonly parts: PartActions;
  readonly gardens: Gardens;
  /// Values with which new components begin, by type. Only for types that would otherwise have faults.
  starters: Record<string, Json> = {};

  constructor(private readonly page_: Page) {
    this.actions = new BoardActions(page_, this.state, () => this.starters);
    this.parts = new PartActions(page_, this.actions);
    this.gardens = new Gardens(page_);
  }

  /// Resets the board for another document.
  begin(): void {
    this.state.set(kEmptyBoard);
    this.fit();
  }

  fit(): void {
    this.fits.set(this.fits.get() + 1);
  }

  /// Returns the ids of drawn components that the view must hide.
  hidden_components(drawn: string[]): ReadonlySet<string> {
    const { hidden, solo } = this.page_.view_state.get();
    if (solo === null) return hidden;
    const shown = this.solo_components();
    return new Set([...hidden, ...drawn.filter((one) => !shown.has(one))]);
  }

  /// Returns the component that is drawn alone and its descendants. Returns nothing if all are drawn.
  solo_components(): ReadonlySet<string> {
    const { solo } = this.page_.view_state.get();
    return solo === null ? new Set() : standing_on(this.actions.graph, solo);
  }
}
