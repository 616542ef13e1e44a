// SPDX-License-Identifier: Apache-2.0
// The state of a drag. It is shown in the next rendering and readable at once, because a drag may end before that.
import { useRef, useState } from 'react';

export interface Held<T> {
  shown: T | null; // for rendering
  get: () => T | null; // for event handlers
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
