// SPDX-License-Identifier: Apache-2.0
// Unsaved work in the browser: text, the hash with which it was opened, the undo list, and edits that no server has
// made yet. Each document of each tab has one record.
import type { WaitingEdits } from './document_state.ts';
import type { UndoState } from './undo_list.ts';

export interface KeptWork {
  slot: string;
  tab: string;
  key: string; // key of the document
  name: string;
  path: string | null;
  model: string | null;
  text: string;
  base: string;
  undo: UndoState;
  waiting: WaitingEdits[];
  is_lost: boolean; // true: its tab has no server, so another tab may take the work over
  at: number; // ms since 1970
}

const kStore = 'slots';
const kVersion = 2;

function open(): Promise<IDBDatabase> {
  return new Promise((resolve, reject) => {
    const asked = indexedDB.open('meristem-studio', kVersion);
    asked.onupgradeneeded = () => {
      const { result: database } = asked;
      if (!database.objectStoreNames.contains(kStore)) database.createObjectStore(kStore, { keyPath: 'slot' });
      if (database.objectStoreNames.contains('work')) database.deleteObjectStore('work');
    };
    asked.onblocked = () => reject(new Error('another page holds an older store'));
    asked.onsuccess = () => {
      asked.result.onversionchange = () => asked.result.close();
      resolve(asked.result);
    };
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

/// Returns the key of a document in the browser. `root` distinguishes served folders.
export function work_key(path: string | null, model: string | null, root: string): string {
  return path !== null ? `file:${root}:${path}` : model !== null ? `model:${model}` : 'new';
}

export function slot_of(tab: string, key: string): string {
  return `${tab} ${key}`;
}

/// A browser that stores nothing, for example in a private window, causes no fault: work continues without.
export async function keep(work: KeptWork): Promise<void> {
  await run('readwrite', (store) => store.put(work)).catch(() => undefined);
}

export async function forget(slot: string): Promise<void> {
  await run('readwrite', (store) => store.delete(slot)).catch(() => undefined);
}

/// Returns the kept work, the newest first.
export async function kept_work(): Promise<KeptWork[]> {
  const all = await run('readonly', (store) => store.getAll() as IDBRequest<KeptWork[]>).catch(() => []);
  return all.sort((a, b) => b.at - a.at);
}
