// SPDX-License-Identifier: Apache-2.0
// The page's central model: the connection, the open document, growth and view. It composes the tools of all panels.
// Panels know it as a `Page` only.
import { Store } from './base/store.ts';
import { ToastList } from './base/toast_list.ts';
import { Board } from './board/board.ts';
import { DocumentModel } from './document/document_model.ts';
import { values_of_variables } from './document/document_state.ts';
import type { EditOptions } from './document/edit_queue.ts';
import { InstanceChoice } from './page/instance_choice.ts';
import type { Page } from './page/page.ts';
import type { GrowthState, PointedPart, ServerState, ShellState, ViewState } from './page/page_state.ts';
import { first_shell, kFirstView, kNoGrowth, with_failure, with_growth, with_work } from './page/page_state.ts';
import type { ToolKind } from './page/tools.ts';
import { Tools } from './page/tools.ts';
import { Keeper } from './saving/keeper.ts';
import { save_document } from './saving/saving.ts';
import { Connection } from './server/connection.ts';
import { LatestSender } from './server/latest_sender.ts';
import { read_packet } from './server/packet.ts';
import type { Edit, Fault, Hello, OpenAnswer, OpenRequest, ServerMessage } from './server/protocol.ts';
import type { Tables } from './tables/tables.ts';
import type { Json } from './values/json.ts';
import { budgets_of } from './view/budgets.ts';
import type { View, ViewFacts } from './view/view.ts';
import { Workbench } from './workbench.ts';

export class Studio implements Page {
  private readonly tools_ = new Tools();
  readonly chosen = new Store('');
  readonly growth = new Store<GrowthState>(kNoGrowth);
  readonly server = new Store<ServerState>({ link: 'connecting', hello: null });
  readonly view_state = new Store(kFirstView);
  readonly view_facts = new Store<ViewFacts | null>(null);
  readonly pointed = new Store<PointedPart | null>(null);
  readonly instance = this.tools_.add(new InstanceChoice(this));
  readonly board = this.tools_.add(new Board(this));
  readonly shell: Store<ShellState>;
  readonly toasts = new ToastList();
  readonly dragged = new Store<Record<string, Json>>({});
  readonly locks = new Store<ReadonlySet<string>>(new Set());
  readonly enlarged = new Store<string | null>(null);
  readonly strip = new Store<string | null>(null);
  readonly first_values = new Store<Record<string, Json>>({});
  readonly bench = new Workbench(this, this.tools_);
  readonly document: DocumentModel;
  readonly connection: Connection;
  readonly keeper: Keeper;
  view: View | null = null;
  private readonly drags_ = new LatestSender(() => this.connection.request('drag', { values: this.dragged.get() }));
  private keeps_camera_ = false; // true: the next packet is the first of a connection, but not of a document

  constructor(
    readonly tables: Tables,
    readonly address: string, // address of the server's socket
    tab: string, // name of this tab
  ) {
    this.shell = new Store(first_shell());
    this.connection = new Connection(address, {
      on_message: (message) => this.take_message(message),
      on_packet: (bytes) => this.show_packet(bytes),
      on_lost: () => this.keeper.note_lost(),
    });
    this.document = new DocumentModel(
      () => this.connection,
      this.chosen.get,
      (message) => this.notify(message, true),
    );
    this.keeper = this.tools_.add(new Keeper(this, tab));
  }

  tool<T>(kind: ToolKind<T>): T {
    return this.tools_.find(kind);
  }

  notify(text: string, is_fault = false, kind = ''): void {
    this.toasts.add(text, is_fault, kind);
  }

  choose(path: string): void {
    this.instance.forget();
    this.chosen.set(path);
    this.view?.unmark();
    this.refresh_view();
  }

  attach_view(view: View): void {
    this.view = view;
    this.refresh_view();
    this.tell_budgets();
  }

  change_view(part: Partial<ViewState>): void {
    const before = this.view_state.get().drawing;
    this.view_state.merge(part);
    this.refresh_view();
    const drawing = this.view_state.get().drawing;
    if ((drawing === 'skeleton') !== (before === 'skeleton')) {
      this.connection.tell('view', { skeleton: drawing === 'skeleton' });
    }
  }

  refresh_view(): void {
    const { drawing, shows_ground, is_sunlit } = this.view_state.get();
    const hidden = this.board.hidden_components(this.view?.plant.components ?? []);
    const chosen = /^components\.([^.[]+)/.exec(this.chosen.get())?.[1] ?? '';
    this.view?.show(drawing, hidden, chosen);
    this.view?.paint(this.shell.get().is_dark, shows_ground);
    this.view?.shine(is_sunlit);
  }

  async edit(edits: Edit[], label: string, options: EditOptions = {}): Promise<Fault[] | null> {
    // Fields show the new values until the text has them.
    const meant = Object.fromEntries(edits.flatMap((edit) => ('set' in edit ? [[edit.set, edit.value]] : [])));
    this.drags_.drop(); // the edit also ends the drag on the server
    this.dragged.set(meant);
    const faults = await this.document.edit(edits, label, options);
    if (this.dragged.get() === meant) this.dragged.set({});
    if (faults === null && options.choose !== undefined) this.choose(options.choose);
    return faults;
  }

  set_value(path: string, value: Json, label: string): void {
    void this.edit([{ set: path, value }], label);
  }

  /// While an answer is open, only the newest values are kept.
  drag(values: Record<string, Json>): void {
    this.dragged.set(values);
    this.drags_.ask();
  }

  stop_drag(): void {
    if (Object.keys(this.dragged.get()).length > 0) this.drag({});
  }

  async undo(): Promise<void> {
    this.take_back(await this.document.undo(), 'Undone');
  }

  async redo(): Promise<void> {
    this.take_back(await this.document.redo(), 'Redone');
  }

  async open(request: OpenRequest): Promise<boolean> {
    const fault = await this.try_open(request);
    if (fault !== null) this.notify(fault, true);
    return fault === null;
  }

  async try_open(request: OpenRequest): Promise<string | null> {
    await this.document.idle();
    await this.keeper.flush();
    const { is_changed } = this.document;
    const left = this.document.state.get();
    const time = this.bench.time.leave();
    try {
      const opened = await this.connection.request('open', request);
      void this.keeper.flush(); // keeps text that was typed meanwhile; not awaited, because packets follow
      this.take_opened(opened);
      const is_another = left.path !== opened.path || left.model !== opened.model;
      if (is_changed && is_another)
        this.notify(`Unsaved changes of ${left.name} are kept: open it again to have them back`);
      await this.keeper.offer(opened);
      return null;
    } catch (fault) {
      this.bench.time.come_back(time);
      this.document.read_again();
      if (fault instanceof Error) return fault.message;
      throw fault;
    }
  }

  /// Saves the document. Returns true on success.
  save(path: string, over = false): Promise<boolean> {
    return save_document(this, path, over);
  }

  private take_opened(opened: OpenAnswer): void {
    this.view?.clear();
    this.growth.set({ ...kNoGrowth, is_paused: this.growth.get().is_paused });
    this.dragged.set({});
    this.locks.set(new Set());
    this.document.take_opened(opened);
    this.first_values.set(values_of_variables(this.document.state.get()));
    this.view_state.merge({ hidden: new Set(), solo: null });
    this.board.begin();
    this.enlarged.set(null);
    this.strip.set(null);
    this.bench.clear();
    this.choose('');
  }

  private take_back(step: { label: string; chosen: string } | null, what: string): void {
    this.dragged.set({});
    if (step && step.chosen !== this.chosen.get()) this.choose(step.chosen);
    if (step) this.notify(`${what}: ${step.label}`, false, 'undo');
  }

  private take_message(message: ServerMessage): void {
    if (message.is === 'hello') void this.greet(message);
    if (message.is === 'working') this.growth.set(with_work(this.growth.get(), message));
    if (message.is === 'grown') this.growth.set(with_growth(this.growth.get(), message));
    if (message.is === 'elsewhere' && message.count > 0) this.shell.merge({ elsewhere: message });
    else if (message.is === 'elsewhere' && this.shell.get().elsewhere?.path === message.path)
      this.shell.merge({ elsewhere: null });
    if (message.is === 'failed') this.growth.set(with_failure(this.growth.get(), message));
  }

  /// Called when the server is connected, first or again. Sends the page's state to the server.
  private async greet(hello: Hello): Promise<void> {
    const is_first = this.server.get().hello === null;
    this.server.set({ link: 'open', hello });
    this.tell_budgets();
    if (this.growth.get().is_paused) this.connection.tell('pause', { paused: true });
    if (!is_first) {
      const { text, path, model } = this.document.state.get();
      this.keeps_camera_ = true;
      const opened = await this.connection
        .request('open', model !== null ? { text, model } : { text, path })
        .catch(() => null);
      if (opened) this.document.take_reading(opened.hash, opened);
      this.document.resume();
      this.keeper.note_link();
      return;
    }
    for (const request of await this.keeper.first_documents(hello)) {
      if (await this.open(request)) return;
    }
  }

  private tell_budgets(): void {
    if (!this.view || !this.connection.is_open) return;
    const skeleton = this.view_state.get().drawing === 'skeleton';
    this.connection.tell('view', { ...budgets_of(this.view), ...this.bench.time.request, skeleton });
  }

  private show_packet(bytes: ArrayBuffer): void {
    const packet = read_packet(bytes);
    if (this.keeps_camera_) packet.head.fit = false;
    this.keeps_camera_ = false;
    const { draft, share, triangles, instances, of, hash } = packet.head;
    this.view?.apply(packet);
    this.growth.merge({ shown: { draft: draft ?? false, share: share ?? 1, triangles, instances, of, hash } });
    this.refresh_view();
    // The next packet comes when this one is visible.
    const seen = this.view ? this.view.drawn() : new Promise(requestAnimationFrame);
    void seen.then(() => this.connection.tell('shown', { packet: packet.head.packet }));
  }
}
