// SPDX-License-Identifier: Apache-2.0
// A value that tells when it changes, and the hook that lets panels follow it.
import { useRef, useSyncExternalStore } from 'react';

export class Store<T> {
  private value_: T;
  private readonly listeners_ = new Set<() => void>();

  constructor(value: T) {
    this.value_ = value;
  }

  readonly get = (): T => this.value_;

  /// Listeners are called where the value is another one.
  set(value: T): void {
    if (Object.is(value, this.value_)) return;
    this.value_ = value;
    for (const listener of [...this.listeners_]) listener();
  }

  /// Takes over some members of an object.
  merge(part: Partial<T>): void {
    this.set({ ...this.value_, ...part });
  }

  readonly subscribe = (listener: () => void): (() => void) => {
    this.listeners_.add(listener);
    return () => this.listeners_.delete(listener);
  };
}

export function use_store<T>(store: Store<T>): T {
  return useSyncExternalStore(store.subscribe, store.get);
}

/// What `select` takes of a store's value. The panel is drawn anew only where that is another than before, as `same` says,
/// so that rows and items that an edit leaves alone cost nothing.
export function use_part<T, Part>(store: Store<T>, select: (value: T) => Part, same: (one: Part, other: Part) => boolean = Object.is): Part {
  const last = useRef<{ part: Part } | null>(null);
  return useSyncExternalStore(store.subscribe, () => {
    const part = select(store.get());
    if (last.current === null || !same(last.current.part, part)) last.current = { part };
    return last.current.part;
  });
}
