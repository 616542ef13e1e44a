// SPDX-License-Identifier: Apache-2.0
// The grips of what is chosen: found from the document and the tables, in the frame in which it stands.
import { Newest } from '../../base/newest.ts';
import { Store } from '../../base/store.ts';
import { path_of, steps_of, value_at } from '../../document/path.ts';
import type { Studio } from '../../studio.ts';
import { groups_at } from '../../tables/resolve.ts';
import { value_now } from '../../time/values_now.ts';
import type { GripGroup, Sight } from './grip.ts';
import { groups_of_object } from './row_groups.ts';
import type { Frame3 } from './space_math.ts';
import { frame_of_rows, kWorld } from './space_math.ts';

export class Gizmo {
  readonly active = new Store<string | null>(null); // key of the group whose grips are shown
  readonly stand = new Store<{ component: string; frame: Frame3 } | null>(null);
  private readonly newest_ = new Newest();

  constructor(private readonly studio_: Studio) {}

  /// Another document is opened.
  forget(): void {
    this.newest_.drop();
    this.active.set(null);
    this.stand.set(null);
  }

  /// Shows the grips of a part of what is chosen, as soon as it has some: those whose key begins with the path.
  show(path: string): void {
    this.active.set(path);
  }

  /// Asks where the first instance of a component stands, as it has grown last.
  ask(component: string): void {
    const counts = this.newest_.begin();
    this.studio_.connection
      .request<{ stand: number[] | null }>('stand', { component })
      .then(({ stand }) => {
        if (counts()) this.stand.set(stand ? { component, frame: frame_of_rows(stand) } : null);
      })
      .catch(() => undefined);
  }

  /// The groups of what is chosen, with the values under the hand and of keys.
  groups(sight: Sight): GripGroup[] {
    const studio = this.studio_;
    const object = object_of(studio.chosen.get());
    if (object === null) return [];
    const { tree } = studio.document.state.get();
    const frame = this.frame_of(object);
    if (!frame) return [];
    const tables = groups_at(studio.tables, tree, object).map((one) => one.table);
    const value = value_now(studio, object, value_at(tree, object));
    return groups_of_object(studio.tables, tables, value, object, String(steps_of(object).at(-1) ?? ''), frame, sight);
  }

  private frame_of(object: string): Frame3 | null {
    if (object === 'scene') return kWorld;
    const stand = this.stand.get();
    return stand && stand.component === steps_of(object)[1] ? stand.frame : null;
  }
}

/// The component or the scene that a path leads into; null for all else, which stands nowhere.
export function object_of(path: string): string | null {
  const steps = steps_of(path);
  if (steps[0] === 'scene') return 'scene';
  return steps[0] === 'components' && steps.length > 1 ? path_of(steps.slice(0, 2)) : null;
}
