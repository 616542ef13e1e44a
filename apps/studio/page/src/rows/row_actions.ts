// SPDX-License-Identifier: Apache-2.0
// What all editors of rows do with the value at their path.
import { useContext } from 'react';

import { use_store } from '../base/store.ts';
import type { Json } from '../document/json.ts';
import type { Edit, Fault } from '../server/protocol.ts';
import type { Studio } from '../studio.ts';
import { use_document, use_studio } from '../studio_context.ts';
import { with_key } from '../time/keys.ts';
import type { Key } from '../time/track.ts';
import { commit_keys, drag_keys, use_keyed } from '../time/use_keyed.ts';
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
  const keyed = use_keyed(path);
  const excluded = [...useContext(ExcludedPaths), ...rivals];
  // What has keys has its value from the key at the time that the view shows.
  const keys = (value: Json): Key[] => with_key(keyed?.track.keys ?? [], studio.bench.time.time, value);
  return {
    drag: (value) => (keyed ? drag_keys(studio, keyed.track.name, keys(value)) : studio.drag({ [path]: value })),
    commit: (value) => (keyed ? commit_keys(studio, keyed.track.name, keys(value), `Key ${name}`) : give(studio, [{ set: path, value }], `Set ${name}`, excluded)),
    cancel: () => studio.stop_drag(),
    unset: () => void studio.edit([{ unset: path }], `Unset ${name}`),
  };
}

/// Gives something and takes what never stands beside it, as one step.
export function give(studio: Studio, edits: Edit[], label: string, excluded: readonly string[]): void {
  void studio.edit([...edits, ...excluded.map((path) => ({ unset: path }))], label);
  if (excluded.length > 0) studio.tell(`Removed ${excluded.map(last_name).join(' and ')}, which cannot stand beside it`);
}

function last_name(path: string): string {
  return path.slice(path.lastIndexOf('.') + 1).replaceAll('_', ' ');
}

/// The value that the row shows: that under the hand, else that of its keys at the view's time, else the text's.
export function use_shown_value(path: string, value: Json | undefined): Json | undefined {
  const dragged = use_store(use_studio().dragged);
  const keyed = use_keyed(path);
  return path in dragged ? dragged[path] : keyed ? keyed.value : value;
}

/// Faults of the value at a path, and of all below where `deep`.
export function use_faults(path: string, deep = false): Fault[] {
  const { faults } = use_document();
  return faults.filter(
    (fault) => fault.path === path || (deep && (fault.path.startsWith(`${path}.`) || fault.path.startsWith(`${path}[`))),
  );
}
