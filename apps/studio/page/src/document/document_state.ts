// SPDX-License-Identifier: Apache-2.0
// The state of the open document.
import type { Edit, Fault, ImpliedLink, OpenAnswer, Reading, Variable } from '../server/protocol.ts';
import type { Json, JsonNode } from '../values/json.ts';
import { is_object, keep_values, parse_broken_json, parse_json } from '../values/json.ts';
import { variables_of_text } from './text_variables.ts';
import type { UndoState } from './undo_list.ts';
import { kNothingDone } from './undo_list.ts';

/// How the tree was read: from valid JSON, from JSON with a repaired fault, or from an earlier text.
export type TreeIs = 'whole' | 'mended' | 'old';

/// Edits that wait for a server, in the form that the browser keeps.
export interface WaitingEdits {
  edits: Edit[];
  label: string;
}

export interface DocumentState {
  path: string | null; // path of the file below the server's folder
  model: string | null; // the shipped model from which it began
  name: string;
  text: string;
  hash: string;
  saved: string | null; // hash of the file on the disk
  base: string; // hash of the text when it was opened or saved
  tree: JsonNode | null; // tree of the text; `old`: tree of the last text that could be read
  tree_is: TreeIs;
  good: boolean;
  faults: Fault[];
  variables: Variable[];
  implied: ImpliedLink[]; // links that components make without a link in the text
  notes: Record<string, string>; // comments on components, by id
  undo: UndoState;
  waiting: WaitingEdits[]; // edits that wait while there is no server
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

/// Returns the changes of the state by a reading. The server computes no variables of a faulty text; they are then read
/// from the text.
export function reading_of(
  { good, faults, implied = [], notes = {}, variables }: Reading,
  tree: JsonNode | null,
  known: Variable[],
): Partial<DocumentState> {
  if (!good && variables.length === 0) return { good, faults, notes, variables: variables_of_text(known, tree) };
  // An empty expression means that there is no expression.
  return {
    good,
    faults,
    implied,
    notes,
    variables: variables.map((one) => ({ ...one, expression: one.expression || null })),
  };
}

/// Returns the tree of a text. If the text is not JSON, reads around the fault. If top-level names of the last tree are
/// then missing, returns the last tree.
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

/// Returns the values or the expressions of the variables, by name. The server computes no variables of a text with
/// faults; they are then read from the text.
export function values_of_variables({ variables }: DocumentState): Record<string, Json> {
  return Object.fromEntries(variables.map((one) => [one.name, one.expression ?? one.value]));
}

/// Returns the state of a document that was just opened.
export function opened_state({ path, model, name, text, hash, saved, ...reading }: OpenAnswer): DocumentState {
  const read = tree_of(text, null);
  return {
    ...kNoDocument,
    ...reading_of(reading, read.tree, []),
    path,
    model,
    name,
    text,
    hash,
    saved,
    base: hash,
    ...read,
  };
}

/// Returns the reading in an answer, or null if the answer has none.
export function whole_reading({ good, faults, variables, implied, notes }: Partial<Reading>): Reading | null {
  if (good === undefined || !faults || !variables) return null;
  return { good, faults, variables, tree: null, implied: implied ?? [], notes: notes ?? {} };
}
