// SPDX-License-Identifier: Apache-2.0
// What is known of the open document.
import type { Edit, Fault, ImpliedLink, Reading, Variable } from '../server/protocol.ts';
import type { JsonNode } from './json.ts';
import { keep_values, parse_json } from './json.ts';
import type { UndoState } from './undo_list.ts';
import { kNothingDone } from './undo_list.ts';

export interface DocumentState {
  path: string | null; // of the file, below the server's folder
  model: string | null; // the shipped model that it began as
  name: string;
  text: string;
  hash: string;
  saved: string | null; // hash of the file as it is on the disk
  base: string; // hash of the text as it was opened or saved
  tree: JsonNode | null; // of the last text that is JSON
  good: boolean;
  faults: Fault[];
  variables: Variable[];
  implied: ImpliedLink[]; // links that components make themselves
  notes: Record<string, string>; // comments at components, by their ids
  undo: UndoState;
}

export const kNoDocument: DocumentState = {
  path: null,
  model: null,
  name: '',
  text: '',
  hash: '',
  saved: null,
  base: '',
  tree: null,
  good: true,
  faults: [],
  variables: [],
  implied: [],
  notes: {},
  undo: kNothingDone,
};

export function reading_of(reading: Reading): Partial<DocumentState> {
  const { good, faults } = reading;
  const { implied = [], notes = {} } = reading;
  // An empty expression is none.
  const variables = reading.variables.map((one) => ({ ...one, expression: one.expression || null }));
  // The values of a faulty text are not known: the last good ones stay.
  return variables.length > 0 || good ? { good, faults, variables, implied, notes } : { good, faults, notes };
}

export function tree_of(text: string, last: JsonNode | null): JsonNode | null {
  try {
    const tree = parse_json(text);
    keep_values(tree, last?.value);
    return tree;
  } catch {
    return last;
  }
}

export function sets_the_same(a: Edit[], b: Edit[]): boolean {
  const paths = (edits: Edit[]): string => JSON.stringify(edits.map((edit) => ('set' in edit ? edit.set : null)));
  return paths(a) === paths(b) && !paths(a).includes('null');
}
