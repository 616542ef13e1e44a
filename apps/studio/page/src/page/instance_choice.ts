// SPDX-License-Identifier: Apache-2.0
// The clicked instance of the chosen component, and instances that are selected by clicks.
import { Newest } from '../base/newest.ts';
import { Store } from '../base/store.ts';
import { LatestSender } from '../server/latest_sender.ts';
import type { FoundInstance, Grown, ShootName, ShootWay } from '../server/protocol.ts';
import { path_below } from '../values/path.ts';
import { scene_path } from '../view/seen_name.ts';
import type { SeenInstance } from '../view/view.ts';
import type { Page } from './page.ts';

/// A shoot on which operations can act.
export type FoundShoot = FoundInstance & ShootName & { course: number[]; metamers: number[]; iteration: number };

/// Instances that are selected to be left out, or to be the only ones.
export interface Selecting {
  component: string;
  row: 'omit' | 'only';
  numbers: number[];
}

export class InstanceChoice {
  readonly seen = new Store<SeenInstance | null>(null); // the visible part that was clicked
  readonly found = new Store<FoundInstance | null>(null); // its instance, once the server has found it
  readonly selecting = new Store<Selecting | null>(null);

  private readonly again_ = new LatestSender(() => this.ask_again());
  private readonly newest_ = new Newest();
  private known_grown_: Grown | null = null;

  constructor(private readonly page_: Page) {
    page_.growth.subscribe(() => this.on_grown(page_.growth.get().grown));
  }

  /// Returns the clicked shoot if operations could act on it.
  static shoot_of(found: FoundInstance | null): FoundShoot | null {
    return found && found.shoot !== null && found.iteration !== null && found.course ? (found as FoundShoot) : null;
  }

  /// Forgets the instance because something else was chosen. Open answers are ignored.
  forget(): void {
    this.newest_.drop();
    this.again_.drop();
    this.seen.set(null);
    this.found.set(null);
  }

  /// Chooses the component of a clicked instance, and asks the server for the instance.
  choose(seen: SeenInstance | null): void {
    if (seen === null || this.selecting.get()?.component !== seen.component) {
      this.selecting.set(null);
      this.page_.choose(
        seen === null ? '' : scene_path(seen.component) ? 'scene' : path_below('components', seen.component),
      );
    }
    const obstacle = seen && scene_path(seen.component);
    if (seen === null || obstacle) return;
    this.seen.set(seen);
    const counts = this.newest_.begin();
    this.ask(seen)
      .then((instance) => {
        if (counts()) this.take(instance);
      })
      .catch(() => undefined);
  }

  /// Chooses a shoot by its name, a neighbour of it, or the first shoot of the component. Returns true if there is such
  /// a shoot, and null if something else has been chosen meanwhile.
  async hold(component: string, of: ShootName | null, way: ShootWay | null = null): Promise<boolean | null> {
    const counts = this.newest_.begin();
    const shoot = await this.ask_shoot(component, of, way);
    if (!counts()) return null;
    if (!shoot) return false;
    const path = path_below('components', component);
    this.selecting.set(null);
    if (this.page_.chosen.get() !== path) this.page_.choose(path);
    this.seen.set(null);
    this.take(shoot);
    return true;
  }

  private async ask_shoot(
    component: string,
    of: ShootName | null,
    way: ShootWay | null = null,
  ): Promise<FoundShoot | null> {
    const name = of && { stem: of.stem, tree: of.tree, shoot: of.shoot, metamer: of.metamer };
    const { instance } = await this.page_.connection.request('shoot', {
      component,
      of: name,
      go: way,
    });
    return InstanceChoice.shoot_of(instance);
  }

  private async ask(seen: SeenInstance): Promise<FoundInstance | null> {
    const { instance } = await this.page_.connection.request('instance', {
      ...seen,
    });
    return instance;
  }

  /// Requests the shoot again after a growth, since its course and its year may have changed. Drags are ignored.
  private on_grown(grown: Grown | null): void {
    if (grown === this.known_grown_) return;
    this.known_grown_ = grown;
    if (grown && !grown.dragged && InstanceChoice.shoot_of(this.found.get())) this.again_.ask();
  }

  /// Forgets the shoot if its name no longer exists.
  private async ask_again(): Promise<void> {
    const shoot = InstanceChoice.shoot_of(this.found.get());
    if (!shoot) return;
    const counts = this.newest_.begin();
    const now = await this.ask_shoot(shoot.component, shoot);
    if (!counts()) return;
    if (this.found.get() !== shoot)
      this.again_.ask(); // the position on the shoot has moved meanwhile
    else if (now && now.key === shoot.key) this.found.set(now);
    else this.forget();
  }

  private take(instance: FoundInstance | null): void {
    this.found.set(instance);
    // The tool draws over the shoot only, and not over the whole instance.
    if (InstanceChoice.shoot_of(instance)) this.page_.view?.unmark();
    const now = this.selecting.get();
    if (now && now.component === instance?.component)
      this.selecting.set({ ...now, numbers: toggled(now.numbers, instance.i) });
  }
}

function toggled(numbers: number[], one: number): number[] {
  return numbers.includes(one) ? numbers.filter((other) => other !== one) : [...numbers, one].sort((a, b) => a - b);
}
