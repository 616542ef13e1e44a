// SPDX-License-Identifier: Apache-2.0
// A row with keys: its value at the view's time, and edits at that time.
import { useSyncExternalStore } from 'react';

import { without } from '../base/lists.ts';
import { use_part } from '../base/store.ts';
import type { Page } from '../page/page.ts';
import { use_page } from '../page/use_page.ts';
import type { Json } from '../values/json.ts';
import { member_of } from '../values/path.ts';
import type { Track } from './keys.ts';
import { dragged_keys, key_at, keys_edits, kKeysPath, name_of_path, track_path, tracks_of, with_key } from './keys.ts';
import { TimeModel } from './time_model.ts';
import type { Key } from './track.ts';
import { value_at_time } from './track.ts';

export interface Keyed {
  track: Track; // track, including a present drag
  value: Json;
  index: number; // index of the key at this time; -1: no key
}

const kNothing: Record<string, Json> = {};

/// Returns the path that can have keys. Variables have keys as a whole.
export function keyed_path(path: string): string {
  return path.startsWith('variables.') ? path.replace(/\.value$/, '') : path;
}

/// Returns the keys at a path, or null if it has no keys.
export function use_keyed(path: string): Keyed | null {
  const page = use_page();
  const model = page.tool(TimeModel);
  const wanted = keyed_path(path);
  const written = use_part(page.document.state, () => model.tracks.find((one) => one.path === wanted) ?? null);
  const time = useSyncExternalStore(model.state.subscribe, () => (written ? model.time : 0));
  const dragged = use_part(page.dragged, (values) => (written ? values : kNothing));
  const track = written && with_dragged(written, dragged, model.document, model.tops);
  if (!track) return null;
  return { track, value: value_at_time(track.keys, time), index: key_at(track.keys, time) };
}

/// Returns the track with the temporary keys of a drag.
export function with_dragged(
  track: Track,
  dragged: Record<string, Json>,
  document: Json | undefined,
  tops: ReadonlySet<string>,
): Track {
  const own = dragged[track_path(track.name)];
  const all = dragged[kKeysPath] ?? member_of(dragged['animation'], 'keys');
  const keys = own !== undefined ? { [track.name]: own } : all;
  if (keys === undefined) return track;
  return tracks_of(document, tops, keys).find((one) => one.name === track.name) ?? track;
}

export function commit_keys(page: Page, name: string, keys: readonly Key[], label: string): void {
  void page.edit(keys_edits(page.tool(TimeModel).document, name, keys), label);
}

export function drag_keys(page: Page, name: string, keys: readonly Key[]): void {
  page.drag(dragged_keys(page.tool(TimeModel).document, { [name]: keys }));
}

/// Adds a key at the view's time, or removes the key there.
export function toggle_key(page: Page, path: string, keyed: Keyed | null, value: Json): void {
  const model = page.tool(TimeModel);
  const name = keyed?.track.name ?? name_of_path(model.tops, keyed_path(path));
  const label = name.replaceAll('_', ' ');
  if (!model.state.get().is_open) model.toggle();
  if (keyed && keyed.index >= 0)
    commit_keys(page, name, without(keyed.track.keys, keyed.index), `Remove a key of ${label}`);
  else commit_keys(page, name, with_key(keyed?.track.keys ?? [], model.time, value), `Key ${label}`);
}
