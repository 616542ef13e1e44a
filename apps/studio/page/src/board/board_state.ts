// SPDX-License-Identifier: Apache-2.0
// What the board shows besides the document. Nothing of it is saved.
export type Direction = 'down' | 'right';

export interface BoardState {
  folded: ReadonlySet<string>;
  direction: Direction | null; // null: the one in which the graph is larger
  connecting: string | null; // the component whose link waits for its other end, by the keyboard
  refused: { from: string; to: string; reason: string } | null; // a link that could not be made
  renaming: string | null;
  noting: string | null; // the component whose note is being written
}

export const kEmptyBoard: BoardState = { folded: new Set(), direction: null, connecting: null, refused: null, renaming: null, noting: null };
