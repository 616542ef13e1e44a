// SPDX-License-Identifier: Apache-2.0
// Messages that open, change and read a document.
// `meristem_studio_protocol` writes this file from apps/studio/protocol.
import type { Json } from '../../values/json.ts';

/// An error or a warning about a text.
export interface Fault {
  /// A text with errors is not grown.
  severity: 'error' | 'warning';
  /// Description of the fault.
  message: string;
  /// Expected value, or an empty text.
  expected: string;
  /// The nearest valid name, or an empty text.
  nearest: string;
  /// Path in the document, or an empty text.
  path: string;
  /// Line, from 1. Null: unknown.
  line: number | null;
  /// Column in characters, from 1. Null: unknown.
  column: number | null;
  /// Position in the text. Null: unknown.
  offset: number | null;
  /// The whole fault on one line, as a terminal shows it.
  text: string;
}

/// The reason why a request was refused.
export interface Refused {
  /// Reason of the refusal, for users.
  message: string;
  /// Faults of the document.
  faults?: Fault[];
  /// Name of the reached limit of the server.
  limit?: string;
  /// True: the request was cancelled by the page, or by a newer request.
  cancelled?: boolean;
  /// True: the server has another text than the page.
  stale?: boolean;
  /// True: the file on the disk is not as the page expects.
  changed?: boolean;
}

/// Opens a document. The previous plant is dropped: no packet of another document follows this answer.
export interface OpenRequest {
  /// Path below the root. With `text`: the file beside which the text stands.
  path?: string | null;
  /// Name of a shipped model. With `text`: the model that was changed.
  model?: string | null;
  /// Text of the document, instead of the text of the file or the model.
  text?: string | null;
}

/// A variable of the document.
export interface Variable {
  /// Name in expressions.
  name: string;
  /// Present value, also for variables that have an expression.
  value: number;
  /// Smallest value.
  min: number;
  /// Largest value.
  max: number;
  /// Unit, or an empty text.
  unit: string;
  /// Description, or an empty text.
  doc: string;
  /// The expression that gives the value. Null: the value is a number.
  expression: string | null;
  /// True: the variable is not shown to users.
  private: boolean;
}

/// A link that is not in the text: a component places another one itself.
export interface ImpliedLink {
  /// The component that places.
  from: string;
  /// The component that is placed.
  to: string;
}

/// The facts that the server reads from a text.
export interface Reading {
  /// True: a newer message made the reading useless. The other members are missing.
  superseded?: boolean;
  /// True: the text has no errors.
  good: boolean;
  /// Errors and warnings.
  faults: Fault[];
  /// The text as plain JSON. Null: the text is not JSON, so the page keeps the last tree.
  tree: Json;
  /// Variables. Empty if the text has errors.
  variables: Variable[];
  /// Implied links of the last text without errors.
  implied: ImpliedLink[];
  /// Comments on components, by component.
  notes: Record<string, string>;
}

/// An opened document.
export interface OpenAnswer extends Reading {
  /// Path below the root. Null: a model or a new text.
  path: string | null;
  /// Name of the shipped model. Null: a file or a new text.
  model: string | null;
  /// Name for a title: the name of the file or the model.
  name: string;
  /// Text of the document.
  text: string;
  /// Hash of the text.
  hash: string;
  /// Hash of the file on the disk. Null: no file.
  saved: string | null;
}

/// Replaces pieces of the text.
export interface SpliceRequest {
  /// Hash of the text before the change.
  base: string;
  /// The pieces, in rising order and without overlap.
  patch: readonly (readonly [offset: number, length: number, replacement: string])[];
}

/// A changed text.
export interface TextAnswer extends Reading {
  /// Hash of the new text.
  hash: string;
}

/// Replaces the whole text.
export interface TextRequest {
  /// The new text.
  text: string;
}

/// Sets a value.
export interface SetEdit {
  /// Path of the value.
  set: string;
  /// The new value.
  value: Json;
}

/// Removes a member, so that its default holds.
export interface UnsetEdit {
  /// Path of the member.
  unset: string;
}

/// Inserts an element or a member.
export interface InsertEdit {
  /// Path of the new value. `links[]` is behind the last link.
  insert: string;
  /// The new value.
  value: Json;
  /// Index among the members. Missing: last.
  index?: number | null;
}

/// Removes a member or an element.
export interface RemoveEdit {
  /// Path of the member or element.
  remove: string;
}

/// Renames a member and its uses.
export interface RenameEdit {
  /// Path of the member.
  rename: string;
  /// The new name.
  name: string;
}

/// Moves a member or an element within its object or list.
export interface MoveEdit {
  /// Path of the member or element.
  move: string;
  /// Index after the move, from 0.
  index: number;
}

/// Sets the comment on a member.
export interface NoteEdit {
  /// Path of the member.
  note: string;
  /// The comment. An empty text removes it.
  text: string;
}

/// Inserts a part of a document.
export interface PasteEdit {
  /// The part, as `part` answers it.
  paste: string;
  /// New names of components, by their names in the part.
  names?: Record<string, string> | null;
  /// Index of its first component. Missing: behind the last.
  index?: number | null;
  /// Index of its first link. Missing: behind the last.
  link_index?: number | null;
}

/// Changes values of the document in one step. Ends a drag and removes its values.
export interface EditRequest {
  /// Hash of the text before the change.
  base: string;
  /// The edits, in their order.
  edits: readonly (SetEdit | UnsetEdit | InsertEdit | RemoveEdit | RenameEdit | MoveEdit | NoteEdit | PasteEdit)[];
  /// True: refused with `faults`, without a change, if a text without errors would get errors.
  only_if_good?: boolean | null;
}

/// An edited text.
export interface EditAnswer extends Reading {
  /// The change of the text.
  patch: [offset: number, length: number, replacement: string][];
  /// The patch that undoes the change.
  inverse: [offset: number, length: number, replacement: string][];
  /// Hash of the new text.
  hash: string;
}

/// Sets values for a while, as a slider does. The text does not change, and the latest drag counts.
export interface DragRequest {
  /// Values by their paths: `{"leaf.length": 0.2}`. Empty: ends the drag.
  values: Record<string, Json>;
}

/// The faults of dragged values.
export interface DragAnswer {
  /// Faults of these values.
  faults: Fault[];
  /// True: a newer message made the reading useless.
  superseded?: boolean;
}
