// SPDX-License-Identifier: Apache-2.0
// The numbers of the grips that are shown, and the list of all things that have grips.
import type { ReactElement } from 'react';

import { IconButton } from '../../controls/button.tsx';
import { NumberField } from '../../controls/number_field.tsx';
import { use_snapping } from '../../editors/snapping.ts';
import { use_studio } from '../../studio_context.ts';
import { drag_values, set_values } from '../../time/values_now.ts';
import type { Studio } from '../../studio.ts';
import type { GripField, GripGroup } from './grip.ts';
import type { Vec } from './space_math.ts';

interface GizmoCardProps {
  groups: readonly GripGroup[];
  shown: GripGroup | null;
}

export function GizmoCard({ groups, shown }: GizmoCardProps): ReactElement {
  const studio = use_studio();
  const { active } = studio.bench.gizmo;
  const { snaps, set_snaps } = use_snapping();
  return (
    <section className="gizmo-card" aria-label="Grips">
      <header>
        <select className="select" aria-label="What has grips" value={shown?.key ?? ''} onChange={(event) => active.set(event.target.value === '' ? null : event.target.value)}>
          <option value="">{groups.length === 1 ? '1 thing has grips' : `${groups.length} things have grips`}</option>
          {groups.map((group) => (
            <option key={group.key} value={group.key}>
              {group.label}
            </option>
          ))}
        </select>
        <IconButton is_small icon="magnet" label="Move in whole steps; Alt holds it off" is_on={snaps} press={() => set_snaps(!snaps)} />
        {shown && is_out_of_sight(studio, shown) && <IconButton is_small icon="fit" label="Some of it is out of sight: see all of it beside the plant" press={() => look_at(studio, shown)} />}
        {shown && <IconButton is_small icon="close" label="Hide the grips" press={() => active.set(null)} />}
      </header>
      {shown && shown.fields.length > 0 && (
        <div className="gizmo-fields">
          {shown.fields.map((field) => (
            <Field key={field.label} group={shown} field={field} />
          ))}
        </div>
      )}
    </section>
  );
}

/// The button is gone then, so the keyboard goes to the view.
function look_at({ view }: Studio, group: GripGroup): void {
  view?.fit(places_of(group));
  document.querySelector<HTMLElement>('.centre .view canvas')?.focus();
}

function places_of({ at, lines }: GripGroup): Vec[] {
  return [at, ...lines.flat()];
}

/// Whether some of it lies beyond the edges of the view.
function is_out_of_sight({ view }: Studio, group: GripGroup): boolean {
  return view !== null && places_of(group).some((place) => !view.eye.sees(place));
}

function Field({ group, field }: { group: GripGroup; field: GripField }): ReactElement {
  const studio = use_studio();
  return (
    <label className="gizmo-field">
      <span>{field.label}</span>
      <NumberField label={`${group.label}, ${field.label}`} value={field.value} step={field.step} unit={field.unit} limit={field.limit} drag={(one) => drag_values(studio, field.values(one))} commit={(one) => set_values(studio, field.values(one), `Set ${group.label}`)} cancel={() => studio.stop_drag()} />
    </label>
  );
}
