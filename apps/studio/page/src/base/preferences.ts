// SPDX-License-Identifier: Apache-2.0
// Small settings that outlive the page. A browser that stores nothing causes no fault.

export function preference(name: string): string | null {
  try {
    return localStorage.getItem(`meristem.${name}`);
  } catch {
    return null;
  }
}

export function prefer(name: string, value: string): void {
  try {
    localStorage.setItem(`meristem.${name}`, value);
  } catch {
    // This browser stores nothing.
  }
}

/// Returns what this tab of this server had open before a reload.
export function of_this_page(): string | null {
  try {
    return sessionStorage.getItem(location.pathname);
  } catch {
    return null;
  }
}

export function remember_for_this_page(key: string): void {
  try {
    sessionStorage.setItem(location.pathname, key);
  } catch {
    // This browser stores nothing.
  }
}
