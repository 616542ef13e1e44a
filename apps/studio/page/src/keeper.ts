// SPDX-License-Identifier: Apache-2.0
// Keeps unsaved work 300 ms after each edit, and offers it again after a reload or a crash.
import { of_this_page, remember_for_this_page } from './base/preferences.ts';
import type { KeptWork } from './recovery.ts';
import { forget, keep, kept_work, work_key } from './recovery.ts';
import type { Hello, Opened } from './server/protocol.ts';
import type { OpenWish, Studio } from './studio.ts';

const kPause = 300;

export class Keeper {
  private timer_ = 0;
  private last_text_ = '';
  private is_first_ = true;

  constructor(private readonly studio_: Studio) {
    studio_.document.state.subscribe(() => this.look());
    document.addEventListener('visibilitychange', () => void this.flush());
  }

  /// What a page begins with: after a reload what it had open, else what the server was started with.
  first_document(hello: Hello): OpenWish {
    const last = of_this_page();
    if (last?.startsWith('model:')) return { model: last.slice(6) };
    if (last?.startsWith('file:')) return { path: last.slice(5) };
    if (hello.document !== null) return { path: hello.document };
    return { model: hello.model ?? 'oak' };
  }

  /// Offers kept work of the document that was opened, where it says something else; on the page's first document also
  /// what was left of another one.
  async offer(opened: Opened): Promise<void> {
    const key = work_key(opened.path, opened.model);
    remember_for_this_page(key);
    const all = await kept_work();
    const work = all.find((one) => one.key === key);
    const other = this.is_first_ ? all.find((one) => one.key !== key) : undefined;
    this.is_first_ = false;
    if (work && work.text === opened.text && key !== 'new') await forget(key);
    if (work && work.text !== opened.text) this.studio_.shell.merge({ kept: { work, before: opened.text } });
    else this.studio_.shell.merge({ kept: other ? { work: other, before: null } : null });
  }

  /// Opens the document of kept work, which is then offered with what differs.
  open_other(work: KeptWork): void {
    this.studio_.shell.merge({ kept: null });
    if (work.model !== null) void this.studio_.open({ model: work.model });
    else if (work.path !== null) void this.studio_.open({ path: work.path });
    else void this.studio_.open({ text: work.text, path: null });
  }

  restore(work: KeptWork): void {
    this.studio_.shell.merge({ kept: null });
    this.studio_.document.take_kept(work.text, work.undo);
    this.studio_.tell('Unsaved changes are back');
  }

  async discard(work: KeptWork): Promise<void> {
    this.studio_.shell.merge({ kept: null });
    await forget(work.key);
  }

  /// Keeps now what waits for its pause, as before another document is opened or the page goes.
  async flush(): Promise<void> {
    if (this.timer_ === 0) return;
    clearTimeout(this.timer_);
    await this.store();
  }

  async forget_open(): Promise<void> {
    this.stop();
    const { path, model } = this.studio_.document.state.get();
    await forget(work_key(path, model));
  }

  private look(): void {
    const { text, undo } = this.studio_.document.state.get();
    if (text === this.last_text_) return;
    this.last_text_ = text;
    this.stop();
    if (undo.done.length === 0 && undo.undone.length === 0) return;
    this.timer_ = window.setTimeout(() => void this.store(), kPause);
  }

  private stop(): void {
    clearTimeout(this.timer_);
    this.timer_ = 0;
  }

  private async store(): Promise<void> {
    this.timer_ = 0;
    const { path, model, name, text, hash, base, undo } = this.studio_.document.state.get();
    const key = work_key(path, model);
    if (hash === base && key !== 'new') return forget(key);
    await keep({ key, name, path, model, text, base, undo, at: Date.now() });
  }
}
