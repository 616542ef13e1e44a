// SPDX-License-Identifier: Apache-2.0
import type { IconName } from '../controls/icon.tsx';
import type { Tables } from '../tables/tables.ts';

/// Returns the icon of a component type, chosen by the facts in its table.
export function icon_of(types: Tables['components'], type: string): IconName {
  const facts = types[type];
  if (facts?.is_camera === true) return 'camera';
  if (facts?.makes_stems === true) return 'stem';
  if (facts?.is_whole_plant === true) return 'document';
  if (facts?.has_geometry === false) return 'many';
  return 'leaf';
}
