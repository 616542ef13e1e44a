// SPDX-License-Identifier: Apache-2.0
// What is seen is called by a component's id, or by a path of the scene.
import { steps_of } from '../document/path.ts';

/// The path of an obstacle that is seen; null where it is a component.
export function scene_path(seen: string): string | null {
  return seen.startsWith('scene.') ? seen : null;
}

/// For people.
export function seen_name(seen: string): string {
  const [, list, index] = steps_of(seen);
  if (scene_path(seen) === null || typeof index !== 'number') return seen;
  return `${String(list).replace(/s$/, '')} ${index + 1}`;
}
