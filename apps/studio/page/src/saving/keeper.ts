// SPDX-License-Identifier: Apache-2.0
// Keeps unsaved work 300 ms after each edit, and offers it again after a reload, a crash or the loss of the server.
// Each tab keeps its own work. The work of a tab that was closed or has lost its server is offered to other tabs.
import { of_this_page, remember_for_this_page } from '../base/preferences.ts';
import { living_tabs } from '../base/tab.ts';
import type { KeptWork } from '../document/recovery.ts';
import { forget, keep, kept_work, slot_of, work_key } from '../document/recovery.ts';
import type { Page } from '../page/page.ts';
import type { Hello, OpenAnswer, OpenRequest } from '../server/protocol.ts';

const kPause = 300;
const kFile = 'file:';
const kModel = 'model:';
const kNew = 'new';

export class Keeper {
  private timer_ = 0;
  private last_text_ = '';
  private last_waiting_ = 0;
  private is_first_ = true;

  constructor(
    private readonly page_: Page,
    private readonly tab_: string,
  ) {
    page_.document.state.subscribe(() => this.look());
    document.addEventListener('visibilitychange', () => void this.flush());
    window.addEventListener('pagehide', () => void this.flush());
  }

  /// Returns the documents that a page may begin with, the best first: the open document of before a reload, else the
  /// document with which the server was started.
  async first_documents(hello: Hello): Promise<OpenRequest[]> {
    const last = of_this_page();
    const requests: OpenRequest[] = [];
    if (last?.startsWith(kModel)) requests.push({ model: last.slice(kModel.length) });
    if (last?.startsWith(kFile)) requests.push({ path: last.slice(kFile.length) });
    const own = slot_of(this.tab_, kNew);
    const all = last === kNew ? await kept_work() : [];
    const mine = all.find((one) => one.slot === own) ?? all.find((one) => one.key === kNew && one.tab === this.tab_);
    if (mine) requests.push({ text: mine.text, path: null });
    if (hello.document !== null) requests.push({ path: hello.document });
    return [...requests, { model: hello.model ?? 'oak' }, { model: 'oak' }];
  }

  /// Offers kept work on the opened document if its text differs. On the page's first document, also offers work on
  /// other documents.
  async offer(opened: OpenAnswer): Promise<void> {
    const key = this.key_of(opened.path, opened.model);
    this.remember();
    const living = await living_tabs();
    const all = (await kept_work()).filter((one) => one.tab === this.tab_ || one.is_lost || !living.has(one.tab));
    const own = slot_of(this.tab_, key);
    const work =
      all.find((one) => one.slot === own) ??
      all.find((one) => one.key === key && (key !== kNew || one.tab === this.tab_));
    const other = this.is_first_ ? all.find((one) => one.key !== key) : undefined;
    this.is_first_ = false;
    const differs = work !== undefined && (work.text !== opened.text || work.waiting.length > 0);
    if (differs) this.page_.shell.merge({ kept: { work: await this.moved(work, own), before: opened.text } });
    else this.page_.shell.merge({ kept: other ? { work: other, before: null } : null });
    if (!work || differs) return;
    if (key !== kNew) return forget(work.slot);
    this.page_.document.take_kept(work.text, work.undo);
    if (work.slot === own) return;
    await this.store();
    await forget(work.slot);
  }

  /// Moves offered work from the slot that the next edit overwrites to a slot of its own.
  private async moved(work: KeptWork, own: string): Promise<KeptWork> {
    if (work.slot !== own) return work;
    const moved = { ...work, slot: `${own} ${work.at}` };
    await keep(moved);
    await forget(own);
    this.note_link(); // keeps text that was typed meanwhile
    return moved;
  }

  /// Opens the document of kept work, which is then offered if its text differs.
  async open_other(work: KeptWork): Promise<void> {
    this.page_.shell.merge({ kept: null });
    if (work.model !== null) await this.page_.open({ model: work.model });
    else if (work.path !== null) await this.page_.open({ path: work.path });
    else if (await this.page_.open({ text: work.text, path: null })) await this.restore(work);
  }

  /// Restores kept work. The old record is removed only when this tab has kept the work.
  async restore(work: KeptWork): Promise<void> {
    this.page_.shell.merge({ kept: null });
    await this.page_.document.idle();
    this.page_.document.take_kept(work.text, work.undo, work.waiting);
    this.page_.notify('Unsaved changes are back');
    await this.store();
    if (work.slot !== this.slot()) await forget(work.slot);
  }

  async discard(work: KeptWork): Promise<void> {
    this.page_.shell.merge({ kept: null });
    await forget(work.slot);
  }

  /// Keeps waiting work now, for example before another document is opened or the page closes.
  async flush(): Promise<void> {
    if (this.timer_ === 0) return;
    await this.store();
  }

  /// Called after saving, possibly under a new name. Removes the work kept before, and keeps text that was typed
  /// meanwhile.
  async take_saved(slot_before: string): Promise<void> {
    this.remember();
    await forget(slot_before);
    await this.store();
  }

  /// The server is lost, so another tab may take the work over. Called again after each failed attempt to connect.
  note_lost(): void {
    const { server, shell } = this.page_;
    if (server.get().link === 'lost') return;
    server.merge({ link: 'lost' });
    shell.merge({ elsewhere: null });
    this.note_link();
  }

  /// Keeps with the work whether the server is there.
  note_link(): void {
    const { hash, base, waiting } = this.page_.document.state.get();
    if (hash !== base || waiting.length > 0) void this.store();
  }

  slot(): string {
    const { path, model } = this.page_.document.state.get();
    return slot_of(this.tab_, this.key_of(path, model));
  }

  private key_of(path: string | null, model: string | null): string {
    return work_key(path, model, this.page_.server.get().hello?.root_key ?? '');
  }

  /// Remembers the document that a reload must open.
  private remember(): void {
    const { path, model } = this.page_.document.state.get();
    remember_for_this_page(path !== null ? kFile + path : model !== null ? kModel + model : kNew);
  }

  private look(): void {
    const { text, undo, waiting } = this.page_.document.state.get();
    if (text === this.last_text_ && waiting.length === this.last_waiting_) return;
    this.last_text_ = text;
    this.last_waiting_ = waiting.length;
    this.stop();
    if (undo.done.length === 0 && undo.undone.length === 0 && waiting.length === 0) return;
    this.timer_ = window.setTimeout(() => void this.store(), kPause);
  }

  private stop(): void {
    clearTimeout(this.timer_);
    this.timer_ = 0;
  }

  private async store(): Promise<void> {
    this.stop();
    const { path, model, name, text, hash, base, undo, waiting } = this.page_.document.state.get();
    const key = this.key_of(path, model);
    const slot = slot_of(this.tab_, key);
    if (hash === base && waiting.length === 0 && key !== kNew) return forget(slot);
    const is_lost = this.page_.server.get().link === 'lost';
    await keep({ slot, tab: this.tab_, key, name, path, model, text, base, undo, waiting, is_lost, at: Date.now() });
  }
}
