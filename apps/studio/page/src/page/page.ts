// SPDX-License-Identifier: Apache-2.0
// The port between the page's panels and its central model. Panels and their tools import this file and never the
// model, which composes them.
import type { Store } from '../base/store.ts';
import type { ToastList } from '../base/toast_list.ts';
import type { DocumentModel } from '../document/document_model.ts';
import type { EditOptions } from '../document/edit_queue.ts';
import type { Connection } from '../server/connection.ts';
import type { Edit, Fault, OpenRequest } from '../server/protocol.ts';
import type { Tables } from '../tables/tables.ts';
import type { Json } from '../values/json.ts';
import type { View, ViewFacts } from '../view/view.ts';
import type { GrowthState, PointedPart, ServerState, ShellState, ViewState } from './page_state.ts';
import type { ToolKind } from './tools.ts';

/// State that panels show. Panels subscribe to a store and change it.
export interface PageStores {
  readonly chosen: Store<string>; // path of the chosen part; "" for none
  readonly dragged: Store<Record<string, Json>>; // values of the present drag, by path
  readonly enlarged: Store<string | null>; // path of the row with the large editor
  /// Values of the variables when the document was opened, to which handles are reset.
  readonly first_values: Store<Record<string, Json>>;
  readonly growth: Store<GrowthState>;
  readonly locks: Store<ReadonlySet<string>>; // variables that chance does not change
  readonly pointed: Store<PointedPart | null>; // the part under the resting pointer
  readonly server: Store<ServerState>;
  readonly shell: Store<ShellState>;
  readonly strip: Store<string | null>; // path of the row whose strip of plants is shown
  readonly view_facts: Store<ViewFacts | null>; // facts about the last picture
  readonly view_state: Store<ViewState>;
}

export interface Page extends PageStores {
  readonly tables: Tables;
  readonly document: DocumentModel;
  readonly view: View | null; // null until the view is attached, and without WebGL
  readonly toasts: ToastList;
  readonly address: string; // address of the server's socket
  readonly connection: Pick<Connection, 'request' | 'begin' | 'tell'>;

  /// Returns the tool of a class. Throws if the page has no such tool.
  tool<T>(kind: ToolKind<T>): T;

  /// Shows a short message. A message replaces an earlier one of the same kind, if `kind` is not empty.
  notify(text: string, is_fault?: boolean, kind?: string): void;

  /// Chooses the part at a path.
  choose(path: string): void;

  /// Changes the document as one step of the undo list. Returns the faults that prevent the edit, or null.
  edit(edits: Edit[], label: string, options?: EditOptions): Promise<Fault[] | null>;
  set_value(path: string, value: Json, label: string): void;

  /// Grows with other values temporarily. The text stays.
  drag(values: Record<string, Json>): void;

  /// Restores the document's values.
  stop_drag(): void;

  undo(): Promise<void>;
  redo(): Promise<void>;

  /// Opens a document. Returns false and reports the reason if this fails.
  open(request: OpenRequest): Promise<boolean>;

  /// Opens a document. Returns the reason if this fails, else null.
  try_open(request: OpenRequest): Promise<string | null>;

  attach_view(view: View): void;
  change_view(part: Partial<ViewState>): void;
}
