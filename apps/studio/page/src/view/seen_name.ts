// SPDX-License-Identifier: Apache-2.0
// Names of visible parts: a component's id, or a path of the scene.
import { steps_of } from '../values/path.ts';

/// Returns the path of a visible obstacle, or null for a component.
export function scene_path(seen: string): string | null {
  return seen.startsWith('scene.') ? seen : null;
}

/// Returns a name for users.
export function seen_name(seen: string): string {
  const [, list, index] = steps_of(seen);
  if (scene_path(seen) === null || typeof index !== 'number') return seen;
  return `${String(list).replace(/s$/, '')} ${index + 1}`;
}
