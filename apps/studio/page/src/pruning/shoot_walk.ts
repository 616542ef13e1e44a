// SPDX-License-Identifier: Apache-2.0
// Moves the choice from shoot to shoot along the tree, by keys.
import { Store } from '../base/store.ts';
import type { FoundShoot } from '../page/instance_choice.ts';
import { InstanceChoice } from '../page/instance_choice.ts';
import type { Page } from '../page/page.ts';
import type { ShootName, ShootWay } from '../server/protocol.ts';
import type { ActionChoice } from './shoot_cut.ts';
import { bearers_of, kNowhere, moved_metamer } from './shoot_text.ts';

/// The component whose shoots are walked, and the tool that acts on them.
export interface WalkedTrees {
  readonly choice: Store<ActionChoice>;
  plan_component(): string | null;
}

export class ShootWalk {
  readonly note = new Store(''); // reason why the last key had no effect
  readonly wants_keyboard = new Store(false); // true: the tool takes the focus when it appears
  private last_: FoundShoot | null = null;
  private is_asking_ = false;

  constructor(
    private readonly page_: Page,
    private readonly trees_: WalkedTrees,
  ) {
    page_.tool(InstanceChoice).found.subscribe(() => {
      this.note.set('');
      this.last_ = this.shoot ?? this.last_;
    });
  }

  /// Resets the walk for another document.
  forget(): void {
    this.last_ = null;
    this.wants_keyboard.set(false);
  }

  /// Focuses the chosen shoot, or the last chosen one, or its nearest existing ancestor, or the first shoot.
  async begin(): Promise<void> {
    const instance = this.page_.tool(InstanceChoice);
    if (this.shoot) return this.wants_keyboard.set(true);
    const component = this.trees_.plan_component();
    if (component === null) return this.page_.notify('No component of this document has shoots that can be cut');
    this.wants_keyboard.set(true);
    for (const of of this.requests(component)) {
      const is_held = await instance.hold(component, of).catch(() => false);
      if (is_held !== false) return;
    }
    this.wants_keyboard.set(false);
    this.page_.notify(`No shoot of ${component} has grown that could be cut`);
  }

  /// Chooses the parent of the shoot, a child, or a neighbour.
  async go(way: ShootWay): Promise<void> {
    const { shoot } = this;
    if (!shoot || this.is_asking_) return;
    this.is_asking_ = true;
    const is_held = await this.page_
      .tool(InstanceChoice)
      .hold(shoot.component, shoot, way)
      .catch(() => null);
    this.is_asking_ = false;
    if (is_held === false) this.note.set(kNowhere[way](shoot.shoot));
  }

  /// Moves the position on the shoot by metamers, towards its tip or its base.
  along(by: number): void {
    const { shoot } = this;
    if (!shoot) return;
    const metamer = moved_metamer(shoot, by);
    this.trees_.choice.merge({ cut_at: 'here' });
    this.page_.tool(InstanceChoice).found.set({ ...shoot, metamer });
    if (metamer === shoot.metamer) this.note.set(`This is the ${by > 0 ? 'tip' : 'base'} of ${shoot.shoot}`);
  }

  private get shoot(): FoundShoot | null {
    return InstanceChoice.shoot_of(this.page_.tool(InstanceChoice).found.get());
  }

  private requests(component: string): (ShootName | null)[] {
    const last = this.last_?.component === component ? this.last_ : null;
    return last ? [last, ...bearers_of(last.shoot).map((bearer) => ({ ...last, ...bearer })), null] : [null];
  }
}
