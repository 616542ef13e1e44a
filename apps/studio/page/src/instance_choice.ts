// SPDX-License-Identifier: Apache-2.0
// Which instance of the chosen component was clicked at, and instances that are clicked one after another.
import { Store } from './base/store.ts';
import { path_below } from './document/path.ts';
import type { FoundShoot } from './server/growth_protocol.ts';
import type { FoundInstance } from './server/protocol.ts';
import type { Studio } from './studio.ts';
import { scene_path } from './view/seen_name.ts';
import type { SeenInstance } from './view/view.ts';

/// Instances that are to be left out, or to be the only ones.
export interface Selecting {
  component: string;
  row: 'omit' | 'only';
  numbers: number[];
}

export class InstanceChoice {
  readonly seen = new Store<SeenInstance | null>(null); // where it is seen
  readonly found = new Store<FoundInstance | null>(null); // once it is known
  readonly selecting = new Store<Selecting | null>(null);

  constructor(private readonly studio_: Studio) {}

  /// The shoot that was clicked at, where operations could act on it.
  static shoot_of(found: FoundInstance | null): FoundShoot | null {
    return found && found.shoot !== null && found.iteration !== null && found.course ? (found as FoundShoot) : null;
  }

  /// Something else has been chosen.
  forget(): void {
    this.seen.set(null);
    this.found.set(null);
  }

  /// Chooses the component of an instance that was clicked at, and asks which one it is.
  choose(seen: SeenInstance | null): void {
    if (seen === null || this.selecting.get()?.component !== seen.component) {
      this.selecting.set(null);
      this.studio_.choose(seen === null ? '' : scene_path(seen.component) ? 'scene' : path_below('components', seen.component));
    }
    const obstacle = seen && scene_path(seen.component);
    if (obstacle) this.studio_.bench.gizmo.show(obstacle);
    if (seen === null || obstacle) return;
    this.seen.set(seen);
    const asked = this.studio_.chosen.get();
    this.studio_.connection
      .request<{ instance: FoundInstance | null }>('instance', { ...seen })
      .then(({ instance }) => {
        if (this.studio_.chosen.get() === asked) this.take(instance);
      })
      .catch(() => undefined);
  }

  private take(instance: FoundInstance | null): void {
    this.found.set(instance);
    // The tool draws over the shoot, and not over all that is one with it.
    if (InstanceChoice.shoot_of(instance)) this.studio_.view?.unmark();
    const now = this.selecting.get();
    if (now && now.component === instance?.component) this.selecting.set({ ...now, numbers: toggled(now.numbers, instance.i) });
  }
}

function toggled(numbers: number[], one: number): number[] {
  return numbers.includes(one) ? numbers.filter((other) => other !== one) : [...numbers, one].sort((a, b) => a - b);
}
