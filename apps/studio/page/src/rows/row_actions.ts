// SPDX-License-Identifier: Apache-2.0
// What all editors of rows do with the value at their path.
import { use_store } from '../base/store.ts';
import type { Json } from '../document/json.ts';
import type { Fault } from '../server/protocol.ts';
import { use_document, use_studio } from '../studio_context.ts';

export interface RowActions {
  drag: (value: Json) => void;
  commit: (value: Json) => void;
  cancel: () => void;
  unset: () => void;
}

export function use_row_actions(path: string, name: string): RowActions {
  const studio = use_studio();
  return {
    drag: (value) => studio.drag({ [path]: value }),
    commit: (value) => studio.set_value(path, value, `Set ${name}`),
    cancel: () => studio.stop_drag(),
    unset: () => void studio.edit([{ unset: path }], `Unset ${name}`),
  };
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
