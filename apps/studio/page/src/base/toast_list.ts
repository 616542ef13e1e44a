// SPDX-License-Identifier: Apache-2.0
// Short messages that disappear after a while.
import { Store } from './store.ts';

export interface Toast {
  id: number;
  text: string;
  is_fault: boolean;
  kind: string; // only the newest message of a kind stays; empty: no kind
}

const kTime = 6000;
const kMax = 4;

export class ToastList {
  readonly shown = new Store<Toast[]>([]);
  private next_ = 1;

  add(text: string, is_fault: boolean, kind = ''): void {
    const toast = { id: this.next_, text, is_fault, kind };
    this.next_ += 1;
    const others = this.shown.get().filter((one) => kind === '' || one.kind !== kind);
    this.shown.set([...others.slice(1 - kMax), toast]);
    setTimeout(() => this.dismiss(toast.id), kTime);
  }

  dismiss(id: number): void {
    this.shown.set(this.shown.get().filter((one) => one.id !== id));
  }
}
