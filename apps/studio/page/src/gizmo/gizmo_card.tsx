// SPDX-License-Identifier: Apache-2.0
// The numbers of the shown grips, and the list of all parts with grips.
import type { ReactElement } from 'react';

import { use_store } from '../base/store.ts';
import { Button, IconButton } from '../controls/button.tsx';
import { NumberField, shown_number } from '../controls/number_field.tsx';
import { use_snapping } from '../editors/snapping.ts';
import type { Page } from '../page/page.ts';
import { use_page } from '../page/use_page.ts';
import { drag_values, set_values } from '../time/values_now.ts';
import { tidy } from '../values/arithmetic.ts';
import type { Vec } from '../values/space_math.ts';
import type { Binding, BoundGroup } from './bound_group.ts';
import { step_label } from './bound_group.ts';
import { said_of_held } from './expressions.ts';
import { Gizmo } from './gizmo.ts';
import type { GripField, Values } from './grip.ts';

interface GizmoCardProps {
  groups: readonly BoundGroup[];
  shown: BoundGroup | null;
}

export function GizmoCard({ groups, shown }: GizmoCardProps): ReactElement {
  const page = use_page();
  const { active } = page.tool(Gizmo);
  const { snaps, set_snaps } = use_snapping();
  return (
    <section className="gizmo-card" aria-label="Grips">
      <header>
        <select
          className="select"
          aria-label="What has grips"
          value={shown?.key ?? ''}
          onChange={(event) => active.set(event.target.value === '' ? null : event.target.value)}
        >
          <option value="">{groups.length === 1 ? '1 thing has grips' : `${groups.length} things have grips`}</option>
          {groups.map((group) => (
            <option key={group.key} value={group.key}>
              {group.label}
            </option>
          ))}
        </select>
        <IconButton
          is_small
          icon="magnet"
          label="Move in whole steps; Alt holds it off"
          is_on={snaps}
          press={() => set_snaps(!snaps)}
        />
        {shown && is_out_of_sight(page, shown) && (
          <IconButton
            is_small
            icon="fit"
            label="Some of it is out of sight: see all of it beside the plant"
            press={() => look_at(page, shown)}
          />
        )}
        {shown && <IconButton is_small icon="close" label="Hide the grips" press={() => active.set(null)} />}
      </header>
      {shown && shown.fields.length > 0 && (
        <div className="gizmo-fields">
          {shown.fields.map((field) => (
            <Field key={field.label} group={shown} field={field} />
          ))}
        </div>
      )}
      {shown && <Refused group={shown} />}
    </section>
  );
}

/// The button disappears then, so the focus moves to the view.
function look_at({ view }: Page, group: BoundGroup): void {
  view?.fit(places_of(group));
  document.querySelector<HTMLElement>('.centre .view canvas')?.focus();
}

function places_of({ at, lines }: BoundGroup): Vec[] {
  return [at, ...lines.flat()];
}

/// Returns true if a part of the group is beyond the edges of the view.
function is_out_of_sight({ view }: Page, group: BoundGroup): boolean {
  return view !== null && places_of(group).some((place) => !view.eye.sees(place));
}

/// The reason why the last tried grip does not move, and a way to free it.
function Refused({ group }: { group: BoundGroup }): ReactElement | null {
  const page = use_page();
  const { refused } = page.tool(Gizmo);
  const last = use_store(refused);
  const paths = new Set([...group.grips, ...group.fields].flatMap(({ held }) => held.map((one) => one.path)));
  const held = last?.group === group.key ? last.held.filter((one) => paths.has(one.path)) : [];
  if (held.length === 0) return null;
  const replace = (): void => {
    void page.edit(
      held.map(({ path, value }) => ({ set: path, value: tidy(value) })),
      'Replace an expression by its value',
    );
    refused.set(null);
  };
  return (
    <div className="gizmo-refused" role="status">
      <p>{said_of_held(held)}. Grips move numbers and variables alone.</p>
      <Button press={replace}>
        Replace by {held.length === 1 ? `its value ${shown_number(held[0]?.value ?? 0)}` : 'their values'}
      </Button>
    </div>
  );
}

function Field({ group, field }: { group: BoundGroup; field: GripField & Binding }): ReactElement {
  const page = use_page();
  const give = (one: number, take: (values: Values) => void): void => {
    page.tool(Gizmo).refused.set(field.held.length > 0 ? { group: group.key, held: field.held } : null);
    if (field.held.length === 0) take(field.values(one));
  };
  return (
    <label className={`gizmo-field${field.held.length + field.moves.length > 0 ? ' expressed' : ''}`}>
      <span>{field.label}</span>
      <NumberField
        label={`${group.label}, ${field.label}`}
        value={field.value}
        step={field.step}
        unit={field.unit}
        limit={field.limit}
        drag={(one) => give(one, (values) => drag_values(page, values))}
        commit={(one) => give(one, (values) => set_values(page, values, step_label(group, values, field)))}
        cancel={() => page.stop_drag()}
      />
    </label>
  );
}
