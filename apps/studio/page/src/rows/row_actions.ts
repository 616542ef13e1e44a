// SPDX-License-Identifier: Apache-2.0
// What all editors of rows do with the value at their path.
import { useContext } from 'react';

import { use_store } from '../base/store.ts';
import type { Json } from '../document/json.ts';
import type { Edit, Fault } from '../server/protocol.ts';
import type { Studio } from '../studio.ts';
import { use_document, use_studio } from '../studio_context.ts';
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
    drag: (value) => studio.drag({ [path]: value }),
    commit: (value) => give(studio, [{ set: path, value }], `Set ${name}`, excluded),
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

/// The value that the row shows: that under the hand, else the text's.
export function use_shown_value(path: string, value: Json | undefined): Json | undefined {
  const dragged = use_store(use_studio().dragged);
  return path in dragged ? dragged[path] : value;
}

/// Faults of the value at a path, and of all below where `deep`.
export function use_faults(path: string, deep = false): Fault[] {
  const { faults } = use_document();
  return faults.filter(
    (fault) => fault.path === path || (deep && (fault.path.startsWith(`${path}.`) || fault.path.startsWith(`${path}[`))),
  );
}
