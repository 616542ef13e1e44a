// SPDX-License-Identifier: Apache-2.0
// Overlays on the plant: the tool's shoot with the part that would be removed, and the positions where an operation
// acted.
import type { ReactElement } from 'react';
import { useEffect } from 'react';

import { use_store } from '../base/store.ts';
import { places_of_numbers } from '../base/vec.ts';
import { InstanceChoice } from '../page/instance_choice.ts';
import { use_page } from '../page/use_page.ts';
import { ProjectedLine } from '../view/projected_line.tsx';
import { Pruning } from './pruning.ts';
import { kept_metamers, parts_of } from './shoot_cut.ts';
import { place_of } from './shoot_text.ts';
import { use_plan_component } from './use_plan_component.ts';

const kMaxDrawn = 400; // number of positions of an operation; more would hide the plant

export function PruningOverlay(): ReactElement | null {
  const page = use_page();
  const pruning = page.tool(Pruning);
  const shoot = InstanceChoice.shoot_of(use_store(page.tool(InstanceChoice).found));
  const choice = use_store(pruning.choice);
  const told = use_store(pruning.told);
  const looked_at = use_store(pruning.looked_at);
  use_told_operations();
  use_store(page.view_facts); // the camera may have moved
  const { view } = page;
  const places = looked_at ? (told?.operations.places.slice(0, kMaxDrawn) ?? []) : [];
  if (!view || (!shoot && places.length === 0)) return null;
  const held = shoot && place_of(shoot);
  const held_at = held && view.eye.project(held);
  const parts = shoot && parts_of(shoot, choice.action === 'cut' ? kept_metamers(shoot, choice) : Infinity);
  return (
    <svg className="pruning-overlay" aria-hidden="true" data-places={places.length} data-shoot={shoot?.shoot}>
      {places.map((place, k) => (
        <ProjectedLine key={k} view={view} places={place.course} className="touched" />
      ))}
      {places.map((place, k) => {
        const at = view.eye.project(place.position);
        return (
          at && <circle key={k} className={`act of-${place.act}`} cx={at[0].toFixed(1)} cy={at[1].toFixed(1)} r="4" />
        );
      })}
      {parts && (
        <>
          <ProjectedLine view={view} places={places_of_numbers(parts.stays)} className="stays" />
          {parts.goes.length > 3 && (
            <ProjectedLine view={view} places={places_of_numbers(parts.goes)} className="goes" />
          )}
        </>
      )}
      {held_at && <circle className="held-place" cx={held_at[0].toFixed(1)} cy={held_at[1].toFixed(1)} r="5" />}
    </svg>
  );
}

/// Keeps the acts of operations up to date while a panel shows them.
function use_told_operations(): void {
  const page = use_page();
  const pruning = page.tool(Pruning);
  const { side } = use_store(page.shell);
  const looked_at = use_store(pruning.looked_at);
  const { shown } = use_store(page.growth);
  const component = use_plan_component();
  const is_wanted = component !== null && (side === 'plan' || looked_at !== null);
  useEffect(() => {
    if (is_wanted && component !== null && shown) pruning.ask(component);
  }, [pruning, is_wanted, component, looked_at, shown]);
}
