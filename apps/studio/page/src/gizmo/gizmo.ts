// SPDX-License-Identifier: Apache-2.0
// The grips of the chosen part. They are found from the document and the tables, in the frame of the part, at the
// present values of its expressions.
import { Newest } from '../base/newest.ts';
import { Store } from '../base/store.ts';
import type { Page } from '../page/page.ts';
import type { Variable } from '../server/protocol.ts';
import { legal_values } from '../tables/legal.ts';
import { groups_at } from '../tables/resolve.ts';
import { value_now } from '../time/values_now.ts';
import type { Json } from '../values/json.ts';
import { write_json } from '../values/json.ts';
import { path_of, steps_of, value_at } from '../values/path.ts';
import type { Frame3 } from '../values/space_math.ts';
import { frame_of_rows, kWorld } from '../values/space_math.ts';
import type { BoundGroup } from './bound_group.ts';
import { bound_group } from './bound_group.ts';
import type { Expressed } from './expressions.ts';
import { expressed, expressions_in, with_numbers } from './expressions.ts';
import type { Sight } from './grip.ts';
import { groups_of_object } from './row_groups.ts';

const kNothing: Readonly<Record<string, number>> = {};

export class Gizmo {
  readonly active = new Store<string | null>(null); // key of the group whose grips are shown
  readonly stand = new Store<{ component: string; frame: Frame3 } | null>(null);
  readonly told = new Store<Readonly<Record<string, number>>>({}); // values of expressions, by their paths
  /// The expressions that block the last tried grip, and the key of its group.
  readonly refused = new Store<{ group: string; held: readonly Expressed[] } | null>(null);
  private readonly newest_ = new Newest();
  private readonly newest_numbers_ = new Newest();

  constructor(private readonly page_: Page) {}

  /// Resets the grips for another document.
  forget(): void {
    this.newest_.drop();
    this.newest_numbers_.drop();
    this.active.set(null);
    this.stand.set(null);
    this.refused.set(null);
    this.told.set(kNothing);
  }

  /// Shows the grips of a part of the chosen object once it has some: the groups whose keys begin with the path.
  show(path: string): void {
    this.active.set(path);
  }

  /// Requests the position of a component's first instance in the last grown plant.
  ask(component: string): void {
    const counts = this.newest_.begin();
    this.page_.connection
      .request('stand', { component })
      .then(({ stand }) => {
        if (counts()) this.stand.set(stand ? { component, frame: frame_of_rows(stand) } : null);
      })
      .catch(() => undefined);
  }

  /// Requests the values of the expressions of a component or of the scene in the last grown plant.
  ask_numbers(object: string): void {
    const counts = this.newest_numbers_.begin();
    const variables = new Set<Json>(this.variables.map((one) => one.name));
    const unknown = [...this.expressions_of(object)].filter(([, written]) => !variables.has(written));
    if (unknown.length === 0) return this.told.set(kNothing);
    const expressions = Object.fromEntries(
      unknown.map(([path, written]) => [path, typeof written === 'string' ? written : write_json(written)]),
    );
    this.page_.connection
      .request('worked_out', {
        expressions,
        ...(object === 'scene' ? {} : { component: String(steps_of(object)[1]) }),
      })
      .then(({ numbers }) => {
        if (counts()) this.told.set(numbers);
      })
      .catch(() => undefined);
  }

  /// Returns the groups of the chosen part, with values of drags and keys.
  groups(sight: Sight): BoundGroup[] {
    const page = this.page_;
    const object = object_of(page.chosen.get());
    const frame = object === null ? null : this.frame_of(object);
    if (object === null || !frame) return [];
    const { tree } = page.document.state.get();
    const tables = groups_at(page.tables, tree, object).map((one) => one.table);
    const all = expressed(this.expressions_of(object), this.told.get(), this.variables, (variable) =>
      this.number_of(variable),
    );
    const value = with_numbers(this.value_of(object), object, all);
    const groups = groups_of_object(
      page.tables,
      tables,
      value,
      object,
      String(steps_of(object).at(-1) ?? ''),
      frame,
      sight,
    );
    return groups.map((group) =>
      bound_group(
        group,
        all,
        (path) => value_at(tree, path),
        (values) => legal_values(page.tables, tree, values),
      ),
    );
  }

  private get variables(): readonly Variable[] {
    return this.page_.document.state.get().variables;
  }

  private value_of(object: string): Json | undefined {
    return value_now(this.page_, object, value_at(this.page_.document.state.get().tree, object));
  }

  private expressions_of(object: string): Map<string, Json> {
    const { tables, document } = this.page_;
    const row_tables = groups_at(tables, document.state.get().tree, object).map((one) => one.table);
    return expressions_in(tables, row_tables, this.value_of(object), object);
  }

  /// Returns the value of a variable: of a drag, or of its keys.
  private number_of({ name, value }: Variable): number {
    const held = this.page_.dragged.get()[name] ?? value_now(this.page_, path_of(['variables', name]), undefined);
    return typeof held === 'number' ? held : value;
  }

  private frame_of(object: string): Frame3 | null {
    if (object === 'scene') return kWorld;
    const stand = this.stand.get();
    return stand && stand.component === steps_of(object)[1] ? stand.frame : null;
  }
}

/// Returns the component or the scene of a path. Returns null for all other parts, which have no position.
export function object_of(path: string): string | null {
  const steps = steps_of(path);
  if (steps[0] === 'scene') return 'scene';
  return steps[0] === 'components' && steps.length > 1 ? path_of(steps.slice(0, 2)) : null;
}
