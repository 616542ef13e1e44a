// SPDX-License-Identifier: Apache-2.0
// States of the document that stay visible beside the present one.
import { Store } from '../base/store.ts';

export interface Pin {
  id: number;
  name: string; // A, B
  text: string;
  path: string | null;
  model: string | null;
}

const kNames = ['A', 'B'];

export class PinList {
  readonly shown = new Store<readonly Pin[]>([]);
  private next_ = 1;

  get is_full(): boolean {
    return this.shown.get().length >= kNames.length;
  }

  add(state: { text: string; path: string | null; model: string | null }): void {
    if (this.is_full) return;
    const taken = this.shown.get().map((one) => one.name);
    const name = kNames.find((one) => !taken.includes(one)) ?? '';
    const pin = { id: this.next_, name, text: state.text, path: state.path, model: state.model };
    this.next_ += 1;
    this.shown.set([...this.shown.get(), pin].sort((a, b) => a.name.localeCompare(b.name)));
  }

  remove(id: number): void {
    this.shown.set(this.shown.get().filter((one) => one.id !== id));
  }

  clear(): void {
    if (this.shown.get().length > 0) this.shown.set([]);
  }
}
