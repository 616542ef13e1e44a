// SPDX-License-Identifier: Apache-2.0
// The state of the board. It is not saved.
export type Direction = 'down' | 'right';

export interface BoardState {
  folded: ReadonlySet<string>;
  direction: Direction | null; // null: the direction in which the graph is larger
  connecting: string | null; // the component whose link waits for its other end, chosen by the keyboard
  refused: { from: string; to: string; reason: string } | null; // a link that was refused
  renaming: string | null;
  noting: string | null; // component whose note is being written
}

export const kEmptyBoard: BoardState = {
  folded: new Set(),
  direction: null,
  connecting: null,
  refused: null,
  renaming: null,
  noting: null,
};
