// SPDX-License-Identifier: Apache-2.0
// The open document: its text, what the server reads in it, and the undo list. All changes of the text go through here,
// one after another.
import { Store } from '../base/store.ts';
import type { Connection } from '../server/connection.ts';
import { Lost } from '../server/connection.ts';
import type { Edit, Edited, Fault, Opened, Reading, Saved } from '../server/protocol.ts';
import { Refusal } from '../server/protocol.ts';
import type { DocumentState } from './document_state.ts';
import { kNoDocument, reading_of, sets_the_same, tree_of } from './document_state.ts';
import { text_hash } from './hash.ts';
import type { Patch } from './patch.ts';
import { apply_patch, inverse_patch, patch_between, patch_of_plain, plain_patch, rebased } from './patch.ts';
import type { UndoState } from './undo_list.ts';
import { step_back, step_forward, with_last, with_step } from './undo_list.ts';

/// How an edit is made.
export interface EditWish {
  only_if_good?: boolean | undefined; // not where the text would then have errors
  choose?: string | undefined; // path that is chosen after it
}

interface Waiting {
  edits: Edit[];
  label: string;
  wish: EditWish;
  done: ((faults: Fault[] | null) => void)[];
}

const kTypingPause = 700; // ms after which typing begins a new step

export class DocumentModel {
  readonly state = new Store<DocumentState>(kNoDocument);
  private readonly waiting_: Waiting[] = [];
  private is_asking_ = false;
  private typed_: string | null = null; // text of the editor, typed while an edit was on its way
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

  take_opened(opened: Opened): void {
    this.waiting_.length = 0;
    this.state.set({
      ...kNoDocument,
      ...reading_of(opened),
      path: opened.path,
      model: opened.model,
      name: opened.name,
      text: opened.text,
      hash: opened.hash,
      saved: opened.saved,
      base: opened.hash,
      tree: tree_of(opened.text, null),
    });
  }

  /// Puts back what was kept of an earlier session.
  take_kept(text: string, undo: UndoState): void {
    this.change_text(text, undo);
    this.send_whole();
  }

  take_saved({ path, name, saved, good, faults, variables, implied, notes }: Saved): void {
    const reading = good !== undefined && faults && variables ? reading_of({ good, faults, variables, tree: null, implied: implied ?? [], notes: notes ?? {} }) : {};
    this.state.merge({ ...reading, path, saved, base: saved, model: null, name });
  }

  take_reading(hash: string, reading: Reading): void {
    if (hash === this.state.get().hash) this.state.merge(reading_of(reading));
  }

  /// Has the library change the text, as one step. Edits that set one and the same value while others are on their way
  /// become one: the last counts. Resolves to what was wrong, or null.
  edit(edits: Edit[], label: string, wish: EditWish = {}): Promise<Fault[] | null> {
    return new Promise((done) => {
      const last = this.waiting_.at(-1);
      if (last && sets_the_same(last.edits, edits)) {
        last.edits = edits;
        last.done.push(done);
      } else {
        this.waiting_.push({ edits, label, wish, done: [done] });
      }
      void this.ask_next();
    });
  }

  /// Takes over what was typed into the text.
  type(text: string): void {
    if (this.is_asking_) {
      this.typed_ = text;
      return;
    }
    this.put(patch_between(this.state.get().text, text), 'Type');
  }

  /// Whether something was typed that is not in the text yet, since an edit is on its way.
  get awaits_typed(): boolean {
    return this.typed_ !== null;
  }

  /// Puts another text in the place of this one, as one step.
  async replace(text: string, label: string): Promise<void> {
    await this.idle();
    this.put(patch_between(this.state.get().text, text), label);
  }

  async undo(): Promise<UndoStepTaken | null> {
    await this.idle();
    const back = step_back(this.state.get().undo);
    if (!back) return null;
    this.splice(back.step.inverse, back.state);
    return { label: back.step.label, chosen: back.step.chosen };
  }

  async redo(): Promise<UndoStepTaken | null> {
    await this.idle();
    const forward = step_forward(this.state.get().undo);
    if (!forward) return null;
    this.splice(forward.step.patch, forward.state);
    return { label: forward.step.label, chosen: forward.step.chosen };
  }

  /// When no edit is on its way; without a server nothing is.
  idle(): Promise<void> {
    if (!this.is_asking_) return Promise.resolve();
    return new Promise((done) => this.idle_.push(done));
  }

  /// Tells the server the whole text, as after a difference.
  send_whole(): void {
    const { text, hash } = this.state.get();
    this.connection_()
      .request<Reading>('text', { text })
      .then((reading) => this.take_reading(hash, reading))
      .catch(() => undefined);
  }

  /// The server is there again and has been told the text: asks what waits.
  resume(): void {
    void this.ask_next();
  }

  private put(patch: Patch, label: string): void {
    if (patch.length === 0) return;
    const { text, undo } = this.state.get();
    const step = { label, patch, inverse: inverse_patch(text, patch), chosen: this.chosen_() };
    const last = undo.done.at(-1);
    const now = performance.now();
    const goes_on = label === 'Type' && last?.label === 'Type' && now - this.typed_at_ < kTypingPause;
    if (label === 'Type') this.typed_at_ = now;
    if (!goes_on || !last) return this.splice(patch, with_step(undo, step));
    const before = apply_patch(text, last.inverse);
    const joined = patch_between(before, apply_patch(text, patch));
    this.splice(patch, with_last(undo, { ...step, patch: joined, inverse: inverse_patch(before, joined) }));
  }

  /// Changes the text here and tells the server.
  private splice(patch: Patch, undo: UndoState): void {
    const { text, hash: base } = this.state.get();
    const hash = this.change_text(apply_patch(text, patch), undo);
    this.connection_()
      .request<Reading & { hash: string }>('splice', { base, patch: plain_patch(patch) })
      .then((answer) => (answer.hash === hash ? this.take_reading(hash, answer) : this.send_whole()))
      .catch((fault: unknown) => {
        if (fault instanceof Refusal) this.send_whole();
      });
  }

  private change_text(text: string, undo: UndoState): string {
    const hash = text_hash(text);
    this.state.merge({ text, hash, undo, tree: tree_of(text, this.state.get().tree) });
    return hash;
  }

  private async ask_next(): Promise<void> {
    if (this.is_asking_ || !this.connection_().is_open) return;
    const next = this.waiting_.shift();
    if (!next) return;
    this.is_asking_ = true;
    const faults = await this.ask(next);
    this.is_asking_ = false;
    if (this.typed_ !== null) this.take_typed(this.typed_);
    if (faults !== 'lost') for (const done of next.done) done(faults);
    if (this.waiting_.length === 0 || faults === 'lost') for (const done of this.idle_.splice(0)) done();
    void this.ask_next();
  }

  private async ask(wish: Waiting): Promise<Fault[] | null | 'lost'> {
    for (let tries = 0; ; tries += 1) {
      const { text, hash: base, undo } = this.state.get();
      try {
        const edited = await this.connection_().request<Edited>('edit', { base, edits: wish.edits, ...(wish.wish.only_if_good ? { only_if_good: true } : {}) });
        const patch = patch_of_plain(edited.patch);
        const after = apply_patch(text, patch);
        const step = { label: wish.label, patch, inverse: patch_of_plain(edited.inverse), chosen: this.chosen_() };
        this.typed_base_ = { text, patch };
        const hash = this.change_text(after, patch.length > 0 ? with_step(undo, step) : undo);
        if (hash === edited.hash) this.state.merge(reading_of(edited));
        else this.send_whole();
        return null;
      } catch (fault) {
        if (fault instanceof Lost) {
          // The wish stays, and is asked again when the server is back.
          this.waiting_.unshift(wish);
          return 'lost';
        }
        if (!(fault instanceof Refusal)) throw fault;
        if (!fault.facts.stale || tries > 0) return this.refuse(fault, wish);
        this.send_whole();
      }
    }
  }

  private refuse(refusal: Refusal, wish: Waiting): Fault[] {
    const faults = refusal.facts.faults ?? [];
    if (!wish.wish.only_if_good) this.tell_(refusal.message);
    // What was refused always has a reason.
    return faults.length > 0 ? faults : [{ severity: 'error', message: refusal.message, path: '', line: null, column: null, offset: null, text: refusal.message }];
  }

  /// What was typed while an edit was on its way was typed into the text before it.
  private take_typed(typed: string): void {
    this.typed_ = null;
    const base = this.typed_base_;
    const now = this.state.get().text;
    if (!base || base.text === now) return this.put(patch_between(now, typed), 'Type');
    const moved = rebased(base.patch, patch_between(base.text, typed));
    this.put(moved ?? patch_between(now, typed), 'Type');
  }
}

export interface UndoStepTaken {
  label: string;
  chosen: string;
}
