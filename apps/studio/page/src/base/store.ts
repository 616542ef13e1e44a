// SPDX-License-Identifier: Apache-2.0
// A value with listeners, and a hook for panels that follow the value.
import { useRef, useSyncExternalStore } from 'react';

export class Store<T> {
  private value_: T;
  private readonly listeners_ = new Set<() => void>();

  constructor(value: T) {
    this.value_ = value;
  }

  readonly get = (): T => this.value_;

  /// Sets the value. Calls the listeners if it has changed.
  set(value: T): void {
    if (Object.is(value, this.value_)) return;
    this.value_ = value;
    for (const listener of [...this.listeners_]) listener();
  }

  /// Sets some members of an object.
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

/// Returns the part of a store's value that `select` picks. The panel is rendered again only if that part has changed,
/// as `same` decides, so rows that an edit does not touch cost nothing.
export function use_part<T, Part>(
  store: Store<T>,
  select: (value: T) => Part,
  same: (one: Part, other: Part) => boolean = Object.is,
): Part {
  const last = useRef<{ part: Part } | null>(null);
  return useSyncExternalStore(store.subscribe, () => {
    const part = select(store.get());
    if (last.current === null || !same(last.current.part, part)) last.current = { part };
    return last.current.part;
  });
}
