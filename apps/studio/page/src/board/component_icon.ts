// SPDX-License-Identifier: Apache-2.0
import type { IconName } from '../controls/icon.tsx';
import type { Tables } from '../tables/tables.ts';

/// The icon of a component type, by what its table says of it.
export function icon_of(types: Tables['components'], type: string): IconName {
  const facts = types[type];
  if (facts?.is_camera === true) return 'camera';
  if (facts?.makes_stems === true) return 'stem';
  if (facts?.is_whole_plant === true) return 'document';
  if (facts?.has_geometry === false) return 'many';
  return 'leaf';
}
