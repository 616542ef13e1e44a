// SPDX-License-Identifier: Apache-2.0
// Actions of all row editors on the value at their path.
import { useContext, useSyncExternalStore } from 'react';

import { use_part } from '../base/store.ts';
import { use_page } from '../page/use_page.ts';
import type { Fault } from '../server/protocol.ts';
import { TimeModel } from '../time/time_model.ts';
import { use_keyed } from '../time/use_keyed.ts';
import { drag_values, has_keys_below, set_values, value_now } from '../time/values_now.ts';
import type { Json } from '../values/json.ts';
import { ExcludedPaths } from './exclusion.ts';

export interface RowActions {
  drag: (value: Json) => void;
  commit: (value: Json) => void;
  cancel: () => void;
  unset: () => void;
}

/// `rivals` are paths that are removed when a value is set.
export function use_row_actions(path: string, name: string, rivals: readonly string[] = []): RowActions {
  const page = use_page();
  const excluded = [...useContext(ExcludedPaths), ...rivals];
  return {
    drag: (value) => drag_values(page, { [path]: value }),
    commit: (value) => set_values(page, { [path]: value }, `Set ${name}`, excluded),
    cancel: () => page.stop_drag(),
    unset: () => void page.edit([{ unset: path }], `Unset ${name}`),
  };
}

/// Returns the value that the row shows: of a drag, else of its keys at the view's time, else of the text.
export function use_shown_value(path: string, value: Json | undefined): Json | undefined {
  const page = use_page();
  const keyed = use_keyed(path);
  const time = page.tool(TimeModel);
  const has_parts = use_part(page.document.state, () => has_keys_below(time.tracks, path));
  useSyncExternalStore(time.state.subscribe, () => (has_parts ? time.time : 0));
  const held = use_part(page.dragged, (dragged) => dragged[path]);
  use_part(page.dragged, (dragged) => (has_parts ? dragged : null));
  if (held !== undefined) return held;
  return keyed ? keyed.value : has_parts ? value_now(page, path, value) : value;
}

/// Returns the faults of the value at a path and, if `deep`, of everything below it.
export function use_faults(path: string, deep = false): Fault[] {
  return use_part(
    use_page().document.state,
    ({ faults }) =>
      faults.filter(
        (fault) =>
          fault.path === path || (deep && (fault.path.startsWith(`${path}.`) || fault.path.startsWith(`${path}[`))),
      ),
    (some, others) =>
      some.length === others.length && (some.length === 0 || JSON.stringify(some) === JSON.stringify(others)),
  );
}
