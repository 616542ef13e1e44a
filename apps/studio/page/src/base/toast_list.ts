// SPDX-License-Identifier: Apache-2.0
// Short news that go by themselves.
import { Store } from './store.ts';

export interface Toast {
  id: number;
  text: string;
  is_fault: boolean;
}

const kTime = 6000;
const kMost = 4;

export class ToastList {
  readonly shown = new Store<Toast[]>([]);
  private next_ = 1;

  add(text: string, is_fault: boolean): void {
    const toast = { id: this.next_, text, is_fault };
    this.next_ += 1;
    this.shown.set([...this.shown.get().slice(1 - kMost), toast]);
    setTimeout(() => this.dismiss(toast.id), kTime);
  }

  dismiss(id: number): void {
    this.shown.set(this.shown.get().filter((one) => one.id !== id));
  }
}
