// SPDX-License-Identifier: Apache-2.0
// What a hand holds while it moves: shown by the next picture, and known at once, since hands let go before that.
import { useRef, useState } from 'react';

export interface Held<T> {
  shown: T | null; // for pictures
  get: () => T | null; // for hands
  set: (held: T | null) => void;
}

export function use_held<T>(): Held<T> {
  const now = useRef<T | null>(null);
  const [shown, show] = useState<T | null>(null);
  const set = (held: T | null): void => {
    now.current = held;
    show(held);
  };
  return { shown, get: () => now.current, set };
}
