// SPDX-License-Identifier: Apache-2.0
// What is known of the open document.
import type { Edit, Fault, ImpliedLink, Reading, Variable } from '../server/protocol.ts';
import type { JsonNode } from './json.ts';
import { is_object, keep_values, parse_broken_json, parse_json } from './json.ts';
import type { UndoState } from './undo_list.ts';
import { variables_of_text } from './text_variables.ts';
import { kNothingDone } from './undo_list.ts';

/// How the tree was read: of JSON, around a fault of its form, or from a text before this one.
export type TreeIs = 'whole' | 'mended' | 'old';

/// Edits that wait for a server, as they are kept in the browser.
export interface WaitingEdits {
  edits: Edit[];
  label: string;
}

export interface DocumentState {
  path: string | null; // of the file, below the server's folder
  model: string | null; // the shipped model that it began as
  name: string;
  text: string;
  hash: string;
  saved: string | null; // hash of the file as it is on the disk
  base: string; // hash of the text as it was opened or saved
  tree: JsonNode | null; // of the text; `old`: of the last text that could be read
  tree_is: TreeIs;
  good: boolean;
  faults: Fault[];
  variables: Variable[];
  implied: ImpliedLink[]; // links that components make themselves
  notes: Record<string, string>; // comments at components, by their ids
  undo: UndoState;
  waiting: WaitingEdits[]; // while no server is there
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
  tree_is: 'old',
  good: true,
  faults: [],
  variables: [],
  implied: [],
  notes: {},
  undo: kNothingDone,
  waiting: [],
};

/// Returns what a reading changes. The server knows no variables of a faulty text: then they are those of the text.
export function reading_of({ good, faults, implied = [], notes = {}, variables }: Reading, tree: JsonNode | null, known: Variable[]): Partial<DocumentState> {
  if (!good && variables.length === 0) return { good, faults, notes, variables: variables_of_text(known, tree) };
  // An empty expression is none.
  return { good, faults, implied, notes, variables: variables.map((one) => ({ ...one, expression: one.expression || null })) };
}

/// Returns the tree of a text. Reads around the fault if the text is no JSON. If names at the top are then missing that
/// the last tree has, the tree is the last one.
export function tree_of(text: string, last: JsonNode | null): { tree: JsonNode | null; tree_is: TreeIs } {
  const read = (parse: (text: string) => JsonNode): JsonNode | null => {
    try {
      const tree = parse(text);
      keep_values(tree, last?.value);
      return tree;
    } catch {
      return null;
    }
  };
  const whole = read(parse_json);
  if (whole) return { tree: whole, tree_is: 'whole' };
  const mended = read(parse_broken_json);
  const found = mended && is_object(mended.value) ? mended.value : {};
  const known = Object.keys(is_object(last?.value) ? last.value : {});
  const is_good = mended !== null && Object.keys(found).length > 0 && known.every((name) => name in found);
  return is_good ? { tree: mended, tree_is: 'mended' } : { tree: last, tree_is: 'old' };
}

/// Returns the reading of an answer that need not have one; null if it has none.
export function whole_reading({ good, faults, variables, implied, notes }: Partial<Reading>): Reading | null {
  if (good === undefined || !faults || !variables) return null;
  return { good, faults, variables, tree: null, implied: implied ?? [], notes: notes ?? {} };
}
