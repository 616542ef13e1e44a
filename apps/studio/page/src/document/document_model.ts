// SPDX-License-Identifier: Apache-2.0
// The open document: its text, the server's reading of it, and the undo list. All changes of the text are made here,
// one after another.
import { Store } from '../base/store.ts';
import type { Connection } from '../server/connection.ts';
import { Lost } from '../server/connection.ts';
import type { Edit, Fault, OpenAnswer, Reading, SaveAnswer } from '../server/protocol.ts';
import { Refusal } from '../server/protocol.ts';
import type { Patch } from '../values/patch.ts';
import { apply_patch, inverse_patch, patch_between, patch_of_plain, plain_patch, rebased } from '../values/patch.ts';
import type { DocumentState, WaitingEdits } from './document_state.ts';
import { kNoDocument, opened_state, reading_of, tree_of, whole_reading } from './document_state.ts';
import type { EditOptions, QueuedEdit } from './edit_queue.ts';
import { EditQueue, kDropped } from './edit_queue.ts';
import { text_hash } from './hash.ts';
import { text_with_edits } from './text_edits.ts';
import { variables_of_text } from './text_variables.ts';
import type { UndoState, UndoStep } from './undo_list.ts';
import { kTypingPause, step_back, step_forward, with_step, with_typing } from './undo_list.ts';

export class DocumentModel {
  readonly state = new Store<DocumentState>(kNoDocument);
  private readonly waiting_ = new EditQueue();
  private is_asking_ = false;
  private opened_ = 0; // number of documents opened so far
  private is_unread_ = false; // true: the server stopped reading this text because of a newer message
  private typed_: string | null = null; // text of the editor that was typed while an edit was on its way
  private typed_at_ = 0;
  private typed_base_: { text: string; patch: Patch } | null = null; // the edit that was on its way
  private readonly idle_: (() => void)[] = [];

  constructor(
    private readonly connection_: () => Connection,
    private readonly chosen_: () => string,
    private readonly tell_: (message: string) => void,
  ) {}

  get is_changed(): boolean {
    const { hash, base } = this.state.get();
    return hash !== base;
  }

  take_opened(opened: OpenAnswer): void {
    this.opened_ += 1;
    this.is_unread_ = false;
    this.waiting_.drop_all();
    this.typed_ = null;
    this.state.set(opened_state(opened));
  }

  /// Restores the work of an earlier session, and makes the edits that no server has made yet.
  take_kept(text: string, undo: UndoState, waiting: readonly WaitingEdits[] = []): void {
    this.change_text(text, undo);
    this.send_whole();
    for (const { edits, label } of waiting) void this.edit(edits, label);
  }

  take_saved({ path, name, saved, ...read }: SaveAnswer): void {
    this.state.merge({ path, saved, base: saved, model: null, name });
    const reading = whole_reading(read);
    if (reading) this.take_reading(saved, reading);
  }

  take_reading(hash: string, reading: Reading): void {
    // The reading of an outdated text is ignored.
    const { hash: now, tree, variables } = this.state.get();
    if (hash !== now) return;
    this.is_unread_ = reading.superseded ?? false;
    if (!this.is_unread_) this.state.merge(reading_of(reading, tree, variables));
  }

  /// Sends the text again if its reading was stopped for a document that could not be opened.
  read_again(): void {
    if (this.is_unread_) this.send_whole();
  }

  /// Asks the library to change the text, as one step. Waiting edits that set one value repeatedly become one edit with
  /// the last value. Resolves to what was wrong, or null.
  edit(edits: Edit[], label: string, options: EditOptions = {}): Promise<Fault[] | null> {
    const made = this.waiting_.add(edits, label, options);
    void this.ask_next();
    return made;
  }

  /// Applies text that was typed into the editor.
  type(text: string): void {
    if (this.is_asking_) this.typed_ = text;
    else this.put(patch_between(this.state.get().text, text), 'Type');
  }

  /// True if typed text is not in the document yet, because an edit is on its way.
  get awaits_typed(): boolean {
    return this.typed_ !== null;
  }

  /// Replaces the whole text, as one step.
  async replace(text: string, label: string): Promise<void> {
    await this.idle();
    this.put(patch_between(this.state.get().text, text), label);
  }

  async undo(): Promise<Pick<UndoStep, 'label' | 'chosen'> | null> {
    await this.idle();
    const back = step_back(this.state.get().undo);
    if (!back) return null;
    this.splice(back.step.inverse, back.state);
    return { label: back.step.label, chosen: back.step.chosen };
  }

  async redo(): Promise<Pick<UndoStep, 'label' | 'chosen'> | null> {
    await this.idle();
    const forward = step_forward(this.state.get().undo);
    if (!forward) return null;
    this.splice(forward.step.patch, forward.state);
    return { label: forward.step.label, chosen: forward.step.chosen };
  }

  /// Resolves when no edit is on its way. Without a server, no edit ever is.
  idle(): Promise<void> {
    if (!this.is_asking_) return Promise.resolve();
    return new Promise((done) => this.idle_.push(done));
  }

  /// Sends the whole text to the server, for example after a difference.
  send_whole(): void {
    const { text, hash } = this.state.get();
    this.connection_()
      .request('text', { text })
      .then((reading) => this.take_reading(hash, reading))
      .catch(() => undefined);
  }

  /// Called when the server is back and has the text. Sends the waiting edits.
  resume(): void {
    void this.ask_next();
  }

  private put(patch: Patch, label: string): void {
    if (patch.length === 0) return;
    const { text, undo } = this.state.get();
    const step = { label, patch, inverse: inverse_patch(text, patch), chosen: this.chosen_() };
    const now = performance.now();
    const goes_on = label === 'Type' && now - this.typed_at_ < kTypingPause;
    if (label === 'Type') this.typed_at_ = now;
    this.splice(patch, goes_on ? with_typing(undo, step, text) : with_step(undo, step));
  }

  /// Changes the text here and informs the server.
  private splice(patch: Patch, undo: UndoState): void {
    const { text, hash: base } = this.state.get();
    const hash = this.change_text(apply_patch(text, patch), undo);
    this.connection_()
      .request('splice', { base, patch: plain_patch(patch) })
      .then((answer) => (answer.hash === hash ? this.take_reading(hash, answer) : this.send_whole()))
      .catch((fault: unknown) => {
        if (fault instanceof Refusal) this.send_whole();
      });
  }

  private change_text(text: string, undo: UndoState): string {
    const hash = text_hash(text);
    const { tree, good, variables } = this.state.get();
    this.state.merge({ text, hash, undo, ...tree_of(text, tree) });
    // A text without faults is read by the server at once, which then sends the values of expressions.
    if (!good || !this.connection_().is_open)
      this.state.merge({ variables: variables_of_text(variables, this.state.get().tree) });
    return hash;
  }

  private async ask_next(): Promise<void> {
    if (this.is_asking_) return;
    while (this.make_here());
    if (!this.connection_().is_open) return this.note_waiting();
    const next = this.waiting_.take();
    this.note_waiting();
    if (!next) return;
    this.is_asking_ = true;
    this.typed_base_ = null; // set once the edit is made
    const faults = await this.ask(next);
    this.is_asking_ = false;
    if (this.typed_ !== null) this.take_typed(this.typed_);
    if (faults !== 'lost') for (const done of next.done) done(faults);
    if (this.waiting_.first === null || faults === 'lost') for (const done of this.idle_.splice(0)) done();
    void this.ask_next();
  }

  /// Makes the first waiting edit without the server, if the server is missing or the text is not JSON.
  private make_here(): boolean {
    const { text, tree_is } = this.state.get();
    const next = this.waiting_.first;
    if (!next || (this.connection_().is_open && tree_is !== 'mended')) return false;
    const made = text_with_edits(text, next.edits);
    if (made === null) return false;
    this.waiting_.take();
    this.put(patch_between(text, made), next.label);
    for (const done of next.done) done(null);
    return true;
  }

  /// Keeps waiting edits with the text while no server can make them.
  private note_waiting(): void {
    const waiting = this.connection_().is_open ? [] : this.waiting_.plain();
    if (waiting.length > 0 || this.state.get().waiting.length > 0) this.state.merge({ waiting });
  }

  private async ask(queued: QueuedEdit): Promise<Fault[] | null | 'lost'> {
    const opened = this.opened_;
    const condition = queued.options.only_if_good ? { only_if_good: true } : {};
    for (let tries = 0; ; tries += 1) {
      const { text, hash: base, undo } = this.state.get();
      try {
        const edited = await this.connection_().request('edit', { base, edits: queued.edits, ...condition });
        if (opened !== this.opened_) return kDropped; // the edit was made in the previous document
        const patch = patch_of_plain(edited.patch);
        const step = { label: queued.label, patch, inverse: patch_of_plain(edited.inverse), chosen: this.chosen_() };
        this.typed_base_ = { text, patch };
        const hash = this.change_text(apply_patch(text, patch), patch.length > 0 ? with_step(undo, step) : undo);
        if (hash === edited.hash) this.take_reading(hash, edited);
        else this.send_whole();
        return null;
      } catch (fault) {
        if (opened !== this.opened_) return kDropped;
        if (fault instanceof Lost) {
          // The edit stays in the queue and is sent again when the server is back.
          this.waiting_.put_back(queued);
          return 'lost';
        }
        if (!(fault instanceof Refusal)) throw fault;
        if (!fault.facts.stale || tries > 0) return this.refuse(fault, queued);
        this.send_whole();
      }
    }
  }

  private refuse(refusal: Refusal, queued: QueuedEdit): Fault[] {
    if (!queued.options.only_if_good) this.tell_(refusal.message);
    return refusal.reasons;
  }

  /// Text that was typed while an edit was on its way is based on the text before the edit.
  private take_typed(typed: string): void {
    this.typed_ = null;
    const base = this.typed_base_;
    const now = this.state.get().text;
    const moved = base && base.text !== now ? rebased(base.patch, patch_between(base.text, typed)) : null;
    this.put(moved ?? patch_between(now, typed), 'Type');
  }
}
