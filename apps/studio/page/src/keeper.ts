// SPDX-License-Identifier: Apache-2.0
// Keeps unsaved work 300 ms after each edit, and offers it again after a reload or a crash.
import { preference, prefer } from './base/preferences.ts';
import type { KeptWork } from './recovery.ts';
import { forget, keep, kept_work, work_key } from './recovery.ts';
import type { Hello, Opened } from './server/protocol.ts';
import type { OpenWish, Studio } from './studio.ts';

const kPause = 300;

export class Keeper {
  private timer_ = 0;
  private last_text_ = '';

  constructor(private readonly studio_: Studio) {
    studio_.document.state.subscribe(() => this.look());
  }

  /// What a page without a wish of its own begins with: what was open last, or the oak.
  async first_document(hello: Hello): Promise<OpenWish> {
    if (hello.document !== null) return { path: hello.document };
    if (hello.model !== null) return { model: hello.model };
    const last = preference('last') ?? 'model:oak';
    if (last.startsWith('model:')) return { model: last.slice(6) };
    const kept = (await kept_work()).find((one) => one.key === last);
    if (last.startsWith('file:')) {
      const path = last.slice(5);
      return (await this.is_there(path)) ? { path } : kept ? { text: kept.text, path: null } : { model: 'oak' };
    }
    return kept ? { text: kept.text, path: null } : { model: 'oak' };
  }

  /// Offers kept work of the document that was opened, where it says something else.
  async offer(opened: Opened, model: string | null): Promise<void> {
    const key = work_key(opened.path, model);
    prefer('last', key);
    const work = (await kept_work()).find((one) => one.key === key);
    if (!work) return this.studio_.shell.merge({ kept: null });
    if (work.text === opened.text) {
      if (key !== 'new') await forget(key);
      return;
    }
    this.studio_.shell.merge({ kept: { work, before: opened.text } });
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

  async forget_open(): Promise<void> {
    clearTimeout(this.timer_);
    const { path, model } = this.studio_.document.state.get();
    await forget(work_key(path, model));
  }

  private async is_there(path: string): Promise<boolean> {
    const cut = path.lastIndexOf('/');
    const folder = cut < 0 ? '' : path.slice(0, cut);
    const listed = await this.studio_.connection
      .request<{ files: { name: string }[] }>('files', { folder })
      .catch(() => ({ files: [] }));
    return listed.files.some((one) => one.name === path.slice(cut + 1));
  }

  private look(): void {
    const { text, undo } = this.studio_.document.state.get();
    if (text === this.last_text_) return;
    this.last_text_ = text;
    clearTimeout(this.timer_);
    if (undo.done.length === 0 && undo.undone.length === 0) return;
    this.timer_ = window.setTimeout(() => void this.store(), kPause);
  }

  private async store(): Promise<void> {
    const { path, model, name, text, hash, base, undo } = this.studio_.document.state.get();
    const key = work_key(path, model);
    if (hash === base && key !== 'new') return forget(key);
    await keep({ key, name, path, model, text, base, undo, at: Date.now() });
  }
}
