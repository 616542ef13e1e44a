// SPDX-License-Identifier: Apache-2.0
// Operations on trees: their acts, the chosen operation, and additions to the list.
import { Newest } from '../base/newest.ts';
import { Store } from '../base/store.ts';
import { PinList } from '../find/pins.ts';
import type { FoundShoot } from '../page/instance_choice.ts';
import { InstanceChoice } from '../page/instance_choice.ts';
import type { Page } from '../page/page.ts';
import type { Edit, OperationEffects } from '../server/protocol.ts';
import { component_groups } from '../tables/tables.ts';
import type { Json } from '../values/json.ts';
import { member_of, node_at, path_below, steps_of, value_at } from '../values/path.ts';
import { text_with_off } from './operation_text.ts';
import type { ActionChoice } from './shoot_cut.ts';
import { kFirstChoice, label_of, operation_of } from './shoot_cut.ts';
import { ShootWalk } from './shoot_walk.ts';

/// The chosen operation and year; null: all years.
export interface LookedAt {
  path: string;
  iteration: number | null;
}

export class Pruning {
  readonly choice = new Store<ActionChoice>(kFirstChoice);
  readonly looked_at = new Store<LookedAt | null>(null);
  readonly told = new Store<{ component: string; operations: OperationEffects } | null>(null);
  readonly walk: ShootWalk;
  private readonly newest_ = new Newest();

  constructor(private readonly page_: Page) {
    this.walk = new ShootWalk(page_, this);
  }

  /// Resets the state for another document.
  forget(): void {
    this.newest_.drop();
    this.walk.forget();
    this.looked_at.set(null);
    this.told.set(null);
  }

  /// Returns the components that may have a list of operations.
  components(): string[] {
    const all = member_of(this.page_.document.state.get().tree?.value, 'components');
    const types = this.page_.tables;
    return Object.entries(typeof all === 'object' && all !== null ? all : {}).flatMap(([id, component]) => {
      const type = member_of(component as Json, 'type');
      const has_list = component_groups(types, String(type)).some(({ rows }) =>
        rows.some((row) => row.name === 'operations' && row.kinds !== undefined),
      );
      return has_list ? [id] : [];
    });
  }

  /// Returns the component whose operations are listed: the chosen one, the component of the chosen operation, or the
  /// first possible one. Returns null if no component can have operations.
  plan_component(): string | null {
    const all = this.components();
    const wanted = [this.page_.chosen.get(), this.looked_at.get()?.path ?? ''].map((path) => steps_of(path)[1]);
    const known = wanted.find((one) => typeof one === 'string' && all.includes(one));
    return typeof known === 'string' ? known : (all[0] ?? null);
  }

  /// Returns the list of a component's operations, as in the document.
  operations_of(component: string): Json[] {
    const said = value_at(this.page_.document.state.get().tree, list_path(component));
    return Array.isArray(said) ? said : [];
  }

  /// Requests the acts of a component's operations on the last grown plant. Only the newest answer counts.
  ask(component: string): void {
    const counts = this.newest_.begin();
    const { path = '', iteration = null } = this.looked_at.get() ?? {};
    this.page_.connection
      .request('operations', {
        component,
        operation: path,
        ...(iteration === null ? {} : { iteration }),
      })
      .then(({ operations }) => {
        if (counts()) this.told.set(operations ? { component, operations } : null);
      })
      .catch(() => undefined);
  }

  look_at(path: string, iteration: number | null): void {
    const now = this.looked_at.get();
    this.looked_at.set(now?.path === path && now.iteration === iteration ? null : { path, iteration });
  }

  /// Returns the number of trees that may have a shoot of this name, as the document gives it.
  trees_beside(shoot: FoundShoot): number {
    const roots = value_at(
      this.page_.document.state.get().tree,
      path_below(path_below('components', shoot.component), 'roots'),
    );
    return Math.max(Array.isArray(roots) ? roots.length : 1, shoot.tree + 1);
  }

  /// Adds the tool's act on a shoot as the last operation of the list.
  async act(shoot: FoundShoot): Promise<void> {
    const list = list_path(shoot.component);
    const before = this.operations_of(shoot.component);
    const choice = this.choice.get();
    const operation: Json = operation_of(shoot, choice, this.trees_beside(shoot));
    const edit: Edit =
      value_at(this.page_.document.state.get().tree, list) === undefined
        ? { set: list, value: [operation] }
        : { insert: path_below(list, -1), value: operation };
    const faults = await this.page_.edit([edit], label_of(shoot, choice), { only_if_good: true });
    if (faults) return this.page_.notify(faults[0]?.message ?? 'That cannot be done', true);
    this.page_.tool(InstanceChoice).forget();
    this.page_.view?.unmark();
    this.looked_at.set({ path: path_below(list, before.length), iteration: null });
  }

  /// Pins the state without an operation beside the view.
  pin_without(path: string): void {
    const { text, tree, path: file, model } = this.page_.document.state.get();
    const node = node_at(tree, path);
    if (!node?.members) return;
    this.page_
      .tool(PinList)
      .add({ text: text_with_off(text, node.start, node.members.length === 0), path: file, model });
  }

  switch_off(path: string, is_off: boolean): void {
    const at = path_below(path, 'off');
    void this.page_.edit(
      [is_off ? { set: at, value: true } : { unset: at }],
      is_off ? 'Switch an operation off' : 'Switch an operation on',
    );
  }

  /// Moves an operation in the list. The choice follows.
  move(component: string, from: number, to: number): void {
    const list = list_path(component);
    if (this.looked_at.get()?.path === path_below(list, from))
      this.looked_at.set({ path: path_below(list, to), iteration: null });
    void this.page_.edit([{ move: path_below(list, from), index: to }], 'Move an operation');
  }

  remove(path: string): void {
    this.looked_at.set(null);
    void this.page_.edit([{ remove: path }], 'Remove an operation');
  }
}

/// Returns the path under which the operations of a training are counted.
export function trained_path(component: string): string {
  return path_below(path_below(path_below('components', component), 'training'), 'operations');
}

export function list_path(component: string): string {
  return path_below(path_below('components', component), 'operations');
}
