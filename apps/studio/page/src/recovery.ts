// SPDX-License-Identifier: Apache-2.0
// Unsaved work, kept in the browser: text, the hash it was opened with, and the undo list, one record a document.
import type { UndoState } from './document/undo_list.ts';

export interface KeptWork {
  key: string;
  name: string;
  path: string | null;
  model: string | null;
  text: string;
  base: string;
  undo: UndoState;
  at: number; // ms since 1970
}

const kStore = 'work';

function open(): Promise<IDBDatabase> {
  return new Promise((resolve, reject) => {
    const asked = indexedDB.open('meristem-studio', 1);
    asked.onupgradeneeded = () => asked.result.createObjectStore(kStore, { keyPath: 'key' });
    asked.onsuccess = () => resolve(asked.result);
    asked.onerror = () => reject(asked.error ?? new Error('the browser keeps nothing'));
  });
}

async function run<T>(mode: IDBTransactionMode, act: (store: IDBObjectStore) => IDBRequest<T>): Promise<T> {
  const database = await open();
  try {
    return await new Promise<T>((resolve, reject) => {
      const asked = act(database.transaction(kStore, mode).objectStore(kStore));
      asked.onsuccess = () => resolve(asked.result);
      asked.onerror = () => reject(asked.error ?? new Error('the browser keeps nothing'));
    });
  } finally {
    database.close();
  }
}

export function work_key(path: string | null, model: string | null): string {
  return path !== null ? `file:${path}` : model !== null ? `model:${model}` : 'new';
}

/// A browser that keeps nothing, as in a private window, is no fault: work goes on without.
export async function keep(work: KeptWork): Promise<void> {
  await run('readwrite', (store) => store.put(work)).catch(() => undefined);
}

export async function forget(key: string): Promise<void> {
  await run('readwrite', (store) => store.delete(key)).catch(() => undefined);
}

export async function kept_work(): Promise<KeptWork[]> {
  const all = await run('readonly', (store) => store.getAll() as IDBRequest<KeptWork[]>).catch(() => []);
  return all.sort((a, b) => b.at - a.at);
}
