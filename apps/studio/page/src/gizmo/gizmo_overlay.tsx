// SPDX-License-Identifier: Apache-2.0
// Grips over the view. They are moved with the pointer or the arrow keys. A gesture is one step, and Escape restores.
import type { KeyboardEvent, PointerEvent, ReactElement } from 'react';
import { useEffect, useRef } from 'react';

import { class_names } from '../base/class_names.ts';
import { use_store } from '../base/store.ts';
import { use_held } from '../controls/use_held.ts';
import { use_snapping } from '../editors/snapping.ts';
import type { Page } from '../page/page.ts';
import { use_document, use_page } from '../page/use_page.ts';
import { TimeModel } from '../time/time_model.ts';
import { drag_values, set_values } from '../time/values_now.ts';
import { fitting_step } from '../values/arithmetic.ts';
import { steps_of } from '../values/path.ts';
import { ProjectedLine } from '../view/projected_line.tsx';
import type { View } from '../view/view.ts';
import type { Binding, BoundGroup } from './bound_group.ts';
import { step_label } from './bound_group.ts';
import { said_of_held } from './expressions.ts';
import { Gizmo, object_of } from './gizmo.ts';
import { GizmoCard } from './gizmo_card.tsx';
import type { Grip, GripGroup, Hold, Sight, Values } from './grip.ts';
import { amount_of, amount_of_key } from './grip.ts';
import { GripShape } from './grip_shape.tsx';

const kReach = 72; // pixels from the middle of a group to the ends of its arrows
const kSnap = { pixels: 8, degrees: 5 };
const kFine = { pixels: 0.5, degrees: 0.5 };

export function GizmoOverlay(): ReactElement | null {
  const page = use_page();
  const gizmo = page.tool(Gizmo);
  use_document();
  use_store(page.dragged);
  use_store(page.tool(TimeModel).state); // values with keys move with the time
  use_store(gizmo.stand);
  use_store(gizmo.told);
  use_store(page.view_facts); // the camera may have moved
  const { shows_grips } = use_store(page.view_state);
  const active = use_store(gizmo.active);
  use_stand(page);
  const { view } = page;
  if (!view || !shows_grips) return null;
  const sight = sight_of(view);
  const groups = gizmo.groups(sight);
  if (groups.length === 0) return null;
  const shown =
    groups.find((one) => one.key === active) ??
    groups.find((one) => active !== null && one.key.startsWith(`${active}.`)) ??
    null;
  return (
    <>
      <svg className="gizmo" role="group" aria-label="Grips of what is chosen" data-groups={groups.length}>
        {groups.map(
          (group) =>
            group !== shown && (
              <Dot key={group.key} view={view} group={group} press={() => gizmo.active.set(group.key)} />
            ),
        )}
        {shown && <ActiveGroup key={shown.key} view={view} group={shown} sight={sight} />}
      </svg>
      <GizmoCard groups={groups} shown={shown} />
    </>
  );
}

/// Requests the position of the chosen component and the values of expressions after each growth.
function use_stand(page: Page): void {
  const object = object_of(use_store(page.chosen));
  const { shown } = use_store(page.growth);
  const component = object === null || object === 'scene' ? null : String(steps_of(object)[1]);
  useEffect(() => {
    // During a drag the frame stays, so that nothing moves under the pointer.
    if (object === null || !shown || Object.keys(page.dragged.get()).length > 0) return;
    if (component !== null) page.tool(Gizmo).ask(component);
    page.tool(Gizmo).ask_numbers(object);
  }, [page, object, component, shown]);
}

function sight_of(view: View): Sight {
  return { ...view.eye.sides, reach: kReach * view.eye.metres_per_pixel };
}

/// A group that is not shown in full. The keyboard chooses it in the list beside the view.
function Dot({ view, group, press }: { view: View; group: GripGroup; press: () => void }): ReactElement | null {
  const at = view.eye.project(group.at);
  if (!at) return null;
  return (
    <g
      className="gizmo-dot"
      data-group={group.key}
      transform={`translate(${at[0].toFixed(1)} ${at[1].toFixed(1)})`}
      onPointerDown={(event) => event.stopPropagation()}
      onClick={press}
    >
      <circle className="reach" r="11" />
      <circle r="5" />
      <title>{group.label}</title>
    </g>
  );
}

interface ActiveGroupProps {
  view: View;
  group: BoundGroup;
  sight: Sight;
}

function ActiveGroup({ view, group, sight }: ActiveGroupProps): ReactElement {
  const page = use_page();
  const { snaps } = use_snapping();
  const root = useRef<SVGGElement>(null);
  const held = use_held<{ hold: Hold & { grip: Binding }; values: Values | null }>();
  const chosen = use_held<string>();
  const refuses = (grip: Binding): boolean => {
    page.tool(Gizmo).refused.set(grip.held.length > 0 ? { group: group.key, held: grip.held } : null);
    return grip.held.length > 0;
  };
  const step_of = (grip: Grip, is_fine: boolean): number => {
    const { pixels, degrees } = is_fine ? kFine : kSnap;
    return grip.motion === 'ring' ? degrees : fitting_step(0, pixels * view.eye.metres_per_pixel, 1);
  };
  const ray = (event: PointerEvent): Hold['start'] => {
    const box = root.current?.ownerSVGElement?.getBoundingClientRect();
    return view.eye.ray_at(event.clientX - (box?.left ?? 0), event.clientY - (box?.top ?? 0));
  };
  const down = (event: PointerEvent<SVGGElement>, grip: Grip & Binding): void => {
    if (event.button !== 0) return;
    event.stopPropagation();
    event.currentTarget.focus();
    if (refuses(grip)) return;
    event.currentTarget.setPointerCapture(event.pointerId);
    held.set({ hold: { grip, start: ray(event) }, values: null });
  };
  const move = (event: PointerEvent): void => {
    const hand = held.get();
    if (!hand) return;
    const { grip } = hand.hold;
    const amount = amount_of(
      hand.hold,
      ray(event),
      sight.toward,
      step_of(grip, !snaps || event.altKey || event.shiftKey),
    );
    if (!amount) return;
    if (grip.motion === 'ring') amount.degrees = amount.step * Math.round(amount.degrees / amount.step);
    const is_still = amount.degrees === 0 && amount.by.every((one) => one === 0);
    const values = is_still ? {} : grip.values(amount);
    held.set({ ...hand, values: is_still ? null : values });
    drag_values(page, values);
  };
  const let_go = (commits: boolean): void => {
    const hand = held.get();
    held.set(null);
    if (hand?.values && commits) set_values(page, hand.values, step_label(group, hand.values, hand.hold.grip));
    else if (hand) page.stop_drag();
  };
  const key = (event: KeyboardEvent, grip: Grip & Binding): void => {
    if (event.key === 'Alt') return event.preventDefault();
    const way = ({ ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] } as const)[event.key];
    const go = { PageUp: -1, PageDown: 1 }[event.key];
    if (event.key === 'Escape' && held.get()) let_go(false);
    else if (event.key === 'Escape') page.tool(Gizmo).active.set(null);
    else if (go !== undefined) focus_grip(root.current, grip.key, go);
    else if (way && !refuses(grip)) {
      const step = step_of(grip, event.shiftKey) * (event.ctrlKey || event.metaKey ? 10 : 1);
      const values = grip.values(amount_of_key(grip, way, sight, step));
      set_values(page, values, step_label(group, values, grip));
    } else if (!way) return;
    event.preventDefault();
    event.stopPropagation();
  };
  const first =
    chosen.shown !== null && group.grips.some((one) => one.key === chosen.shown)
      ? chosen.shown
      : (group.grips[0]?.key ?? '');
  const holding = held.shown?.hold.grip.key ?? null;
  return (
    <g ref={root} className="gizmo-group">
      {group.lines.map((line, k) => (
        <ProjectedLine key={k} view={view} places={line} className="gizmo-outline" />
      ))}
      {in_order(group.grips).map((grip) => (
        <g
          key={grip.key}
          className={class_names(
            `gizmo-grip of-${grip.look}`,
            holding === grip.key && 'held',
            grip.held.length > 0 && 'refuses',
            grip.held.length + grip.moves.length > 0 && 'expressed',
          )}
          data-grip={grip.key}
          data-axis={/[xyz]+$/.exec(grip.key)?.[0]}
          tabIndex={grip.key === first ? 0 : -1}
          role="slider"
          aria-label={`${group.label}: ${grip.label}${said_of_binding(grip)}`}
          aria-valuenow={grip.now}
          aria-valuetext={grip.said}
          onPointerDown={(event) => down(event, grip)}
          onPointerMove={move}
          onPointerUp={() => let_go(true)}
          onPointerCancel={() => let_go(false)}
          onFocus={() => chosen.set(grip.key)}
          onKeyDown={(event) => key(event, grip)}
        >
          <GripShape view={view} grip={grip} reach={sight.reach} />
        </g>
      ))}
    </g>
  );
}

function said_of_binding({ held, moves }: Binding): string {
  if (held.length > 0) return `; ${said_of_held(held)}`;
  return moves.length > 0 ? `; moves ${moves.join(' and ')}` : '';
}

/// Returns grips in drawing order: small ones above large ones, so that all can be grabbed.
function in_order<Any extends Grip>(grips: readonly Any[]): Any[] {
  const looks: readonly Grip['look'][] = ['ring', 'square', 'arrow', 'dot', 'face'];
  return [...grips].sort((a, b) => looks.indexOf(a.look) - looks.indexOf(b.look));
}

function focus_grip(root: SVGGElement | null, key: string, by: number): void {
  const all = [...(root?.querySelectorAll<SVGGElement>('.gizmo-grip') ?? [])];
  const at = all.findIndex((one) => one.dataset['grip'] === key);
  all[(at + by + all.length) % all.length]?.focus();
}
