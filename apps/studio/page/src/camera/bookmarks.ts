// SPDX-License-Identifier: Apache-2.0
// Saved views of a document, which the browser keeps.
import { prefer, preference } from '../base/preferences.ts';
import type { CameraState } from '../view/orbit.ts';

export interface Bookmark {
  name: string;
  camera: CameraState;
}

const kMax = 12;

function key_of(document: { path: string | null; model: string | null; name: string }): string {
  return `views of ${document.model !== null ? `model ${document.model}` : (document.path ?? `new ${document.name}`)}`;
}

export function bookmarks_of(document: Parameters<typeof key_of>[0]): Bookmark[] {
  try {
    const kept = JSON.parse(preference(key_of(document)) ?? '[]') as unknown;
    return Array.isArray(kept) ? kept.filter(is_bookmark) : [];
  } catch {
    return [];
  }
}

export function keep_bookmarks(document: Parameters<typeof key_of>[0], all: readonly Bookmark[]): void {
  prefer(key_of(document), JSON.stringify(all.slice(-kMax)));
}

/// Returns a name that no bookmark has.
export function next_name(all: readonly Bookmark[]): string {
  for (let k = all.length + 1; ; k += 1) if (!all.some((one) => one.name === `View ${k}`)) return `View ${k}`;
}

function is_bookmark(one: unknown): one is Bookmark {
  const { name, camera } = (one ?? {}) as Partial<Bookmark>;
  const numbers = camera
    ? [camera.azimuth, camera.altitude, camera.distance, ...(Array.isArray(camera.target) ? camera.target : [])]
    : [];
  return typeof name === 'string' && numbers.length === 6 && numbers.every((number) => Number.isFinite(number));
}
