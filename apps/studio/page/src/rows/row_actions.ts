// SPDX-License-Identifier: Apache-2.0
// What all editors of rows do with the value at their path.
import { useContext, useSyncExternalStore } from 'react';

import { use_store } from '../base/store.ts';
import type { Json } from '../document/json.ts';
import type { Fault } from '../server/protocol.ts';
import { use_document, use_studio } from '../studio_context.ts';
import { use_keyed } from '../time/use_keyed.ts';
import { drag_values, has_keys_below, set_values, value_now } from '../time/values_now.ts';
import { ExcludedPaths } from './exclusion.ts';

export interface RowActions {
  drag: (value: Json) => void;
  commit: (value: Json) => void;
  cancel: () => void;
  unset: () => void;
}

/// `rivals` are paths that go where a value is set.
export function use_row_actions(path: string, name: string, rivals: readonly string[] = []): RowActions {
  const studio = use_studio();
  const excluded = [...useContext(ExcludedPaths), ...rivals];
  return {
    drag: (value) => drag_values(studio, { [path]: value }),
    commit: (value) => set_values(studio, { [path]: value }, `Set ${name}`, excluded),
    cancel: () => studio.stop_drag(),
    unset: () => void studio.edit([{ unset: path }], `Unset ${name}`),
  };
}

/// The value that the row shows: that under the hand, else that of its keys at the view's time, else the text's.
export function use_shown_value(path: string, value: Json | undefined): Json | undefined {
  const studio = use_studio();
  const dragged = use_store(studio.dragged);
  const keyed = use_keyed(path);
  const { time } = studio.bench;
  const has_parts = has_keys_below(time.tracks, path);
  useSyncExternalStore(time.state.subscribe, () => (has_parts ? time.time : 0));
  if (path in dragged) return dragged[path];
  return keyed ? keyed.value : has_parts ? value_now(studio, path, value) : value;
}

/// Faults of the value at a path, and of all below where `deep`.
export function use_faults(path: string, deep = false): Fault[] {
  const { faults } = use_document();
  return faults.filter(
    (fault) => fault.path === path || (deep && (fault.path.startsWith(`${path}.`) || fault.path.startsWith(`${path}[`))),
  );
}
