// SPDX-License-Identifier: Apache-2.0
// The name of this browser tab. The name survives a reload, and no other tab has it at the same time. The browser holds
// a lock for each tab, which distinguishes open tabs from closed ones.

const kName = 'meristem.tab';
const kLock = 'meristem-tab-';
const kPatience = 400; // ms that the page before a reload may take to close

/// Returns the name of this tab: the name before a reload, or a new one.
export async function claim_tab(): Promise<string> {
  const before = stored_name();
  if (before !== null && (await hold(before))) return before;
  const name = Array.from(crypto.getRandomValues(new Uint8Array(8)), (byte) => byte.toString(16).padStart(2, '0')).join(
    '',
  );
  store_name(name);
  await hold(name);
  return name;
}

/// Returns the names of all open tabs, including this one.
export async function living_tabs(): Promise<ReadonlySet<string>> {
  const held = await locks()
    ?.query()
    .catch(() => null);
  const names = held?.held?.map((lock) => lock.name ?? '') ?? [];
  return new Set(names.filter((name) => name.startsWith(kLock)).map((name) => name.slice(kLock.length)));
}

/// A duplicated tab begins with the name of the first one, which holds the lock.
function hold(name: string): Promise<boolean> {
  const all = locks();
  if (!all) return Promise.resolve(true);
  return new Promise((done) => {
    all
      .request(kLock + name, { signal: AbortSignal.timeout(kPatience) }, () => {
        done(true);
        return new Promise(() => undefined); // until the tab closes
      })
      .catch(() => done(false));
  });
}

/// Returns the browser's locks. Some browsers give none to pages without encryption.
function locks(): LockManager | undefined {
  return navigator.locks as LockManager | undefined;
}

function stored_name(): string | null {
  try {
    return sessionStorage.getItem(kName);
  } catch {
    return null;
  }
}

function store_name(name: string): void {
  try {
    sessionStorage.setItem(kName, name);
  } catch {
    // This browser stores nothing.
  }
}
