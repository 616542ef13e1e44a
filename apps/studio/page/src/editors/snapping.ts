// SPDX-License-Identifier: Apache-2.0
// Whether points snap to the grid and to each other. This setting holds for all editors, and the browser keeps it.
import { prefer, preference } from '../base/preferences.ts';
import { Store, use_store } from '../base/store.ts';

const kSnaps = new Store(true);
let is_read = false;

export function use_snapping(): { snaps: boolean; set_snaps: (snaps: boolean) => void } {
  if (!is_read) {
    is_read = true;
    kSnaps.set(preference('snaps') !== 'no');
  }
  const snaps = use_store(kSnaps);
  const set_snaps = (wanted: boolean): void => {
    prefer('snaps', wanted ? 'yes' : 'no');
    kSnaps.set(wanted);
  };
  return { snaps, set_snaps };
}
