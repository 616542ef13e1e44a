// SPDX-License-Identifier: Apache-2.0
// The 3D view with its buttons: drawing, views along the axes, scale, compass.
import type { ReactElement } from 'react';
import { useEffect, useRef } from 'react';

import { use_store } from '../base/store.ts';
import { CameraMenu } from '../camera/camera_menu.tsx';
import { Button, IconButton, Segments } from '../controls/button.tsx';
import { Icon } from '../controls/icon.tsx';
import { PinButton } from '../find/pinned_views.tsx';
import { Gizmo } from '../gizmo/gizmo.ts';
import { GizmoOverlay } from '../gizmo/gizmo_overlay.tsx';
import { ModuleOverlay } from '../grammar/module_overlay.tsx';
import { LeafPointsOverlay } from '../grass/leaf_points_overlay.tsx';
import { GrowthButton, GrowthPanel } from '../growth/growth_panel.tsx';
import { InstanceChoice } from '../page/instance_choice.ts';
import type { Page } from '../page/page.ts';
import type { GrowthState } from '../page/page_state.ts';
import { use_document, use_page } from '../page/use_page.ts';
import { Pruning } from '../pruning/pruning.ts';
import { PruningOverlay } from '../pruning/pruning_overlay.tsx';
import { ShootTool } from '../pruning/shoot_tool.tsx';
import { TimeButton } from '../timeline/timeline_panel.tsx';
import { scale_bar } from '../view/scale_bar.ts';
import { scene_path, seen_name } from '../view/seen_name.ts';
import { View } from '../view/view.ts';
import type { SeenInstance } from '../view/view_events.ts';
import { OverlayLabels } from './overlay_labels.tsx';

const kDrawings = [
  ['shaded', 'Shaded'],
  ['wireframe', 'Wireframe'],
  ['skeleton', 'Skeleton'],
] as const;

export function ViewPanel(): ReactElement {
  const page = use_page();
  const canvas = useRef<HTMLCanvasElement>(null);
  useEffect(() => {
    if (canvas.current && !page.view) attach(page, canvas.current);
  }, [page]);
  const view = use_store(page.view_state);
  const look = (azimuth: number, altitude: number) => () => page.view?.look_from(azimuth, altitude);
  return (
    <div className="view">
      <canvas
        ref={canvas}
        tabIndex={0}
        role="application"
        aria-label="The plant in three dimensions. Arrow keys turn, Shift with them moves, plus and minus zoom, F fits, Enter takes hold of a shoot."
      />
      <Nothing />
      <StalePlant />
      <ModuleOverlay />
      <PruningOverlay />
      <LeafPointsOverlay />
      <GizmoOverlay />
      <OverlayLabels />
      <div className="view-tools" role="toolbar" aria-label="View">
        <Segments
          label="Drawing"
          value={view.drawing}
          choices={kDrawings}
          choose={(drawing) => page.change_view({ drawing })}
        />
        <IconButton
          icon="ground"
          label="Ground"
          is_on={view.shows_ground}
          press={() => page.change_view({ shows_ground: !view.shows_ground })}
        />
        <IconButton
          icon="grips"
          label="Grips of what is chosen"
          keys="E"
          is_on={view.shows_grips}
          press={() => page.change_view({ shows_grips: !view.shows_grips })}
        />
        <PinButton />
        <GrowthButton />
        <TimeButton />
        <CameraMenu />
      </div>
      <GrowthPanel />
      <div className="view-axes" role="toolbar" aria-label="Look from">
        <Compass />
        <div className="axis-buttons">
          <Button kind="quiet" tip="From the south  1" press={look(180, 0)}>
            Front
          </Button>
          <Button kind="quiet" tip="From the east  3" press={look(90, 0)}>
            Side
          </Button>
          <Button kind="quiet" tip="From above  7" press={look(180, 89.5)}>
            Top
          </Button>
          <IconButton icon="fit" label="Fit the plant" keys="F" press={() => page.view?.fit()} />
        </div>
      </div>
      <Scale />
      <PointedAt />
      <ShootTool />
    </div>
  );
}

function attach(page: Page, canvas: HTMLCanvasElement): void {
  try {
    const view = new View(canvas, {
      drawn: (facts) => page.view_facts.set(facts),
      clicked: (found) => choose_seen(page, found),
      entered: () => void page.tool(Pruning).walk.begin(),
      pointed: (at) => page.pointed.set(at),
      restored: () => page.connection.tell('all'),
    });
    page.attach_view(view);
  } catch {
    page.notify('This browser gives no WebGL, so the plant cannot be drawn; all else works', true);
  }
}

/// Chooses the seen part. The grips of a clicked obstacle are shown at once.
function choose_seen(page: Page, seen: SeenInstance | null): void {
  page.tool(InstanceChoice).choose(seen);
  const obstacle = seen && scene_path(seen.component);
  if (obstacle) page.tool(Gizmo).show(obstacle);
}

function Compass(): ReactElement {
  const facts = use_store(use_page().view_facts);
  const azimuth = facts?.camera.azimuth ?? 180;
  // The compass turns with the camera: up on the screen is the direction of view.
  const north = ((180 - azimuth) * Math.PI) / 180;
  return (
    <svg
      className="compass"
      viewBox="-20 -20 40 40"
      role="img"
      aria-label={`Compass: the camera stands at ${Math.round(azimuth)} degrees`}
    >
      <circle r="17" />
      <g transform={`rotate(${(180 - azimuth).toFixed(1)})`}>
        <path className="north" d="M0 -7L3 1h-6z" />
        <path className="south" d="M0 9L3 1h-6z" />
      </g>
      <text className="compass-letter" x={(11.5 * Math.sin(north)).toFixed(1)} y={(-11.5 * Math.cos(north)).toFixed(1)}>
        N
      </text>
    </svg>
  );
}

function Scale(): ReactElement | null {
  const facts = use_store(use_page().view_facts);
  if (!facts) return null;
  const { pixels, text } = scale_bar(facts.metres_per_pixel);
  return (
    <div className="scale" role="img" aria-label={`This bar is ${text} long where the camera looks`}>
      <span style={{ width: `${pixels}px` }} />
      {text}
    </div>
  );
}

/// The name of the part under the resting pointer.
function PointedAt(): ReactElement | null {
  const at = use_store(use_page().pointed);
  if (!at) return null;
  return (
    <span className="pointed-at" aria-hidden="true" style={{ left: at.x, top: at.y }}>
      {seen_name(at.component)}
    </span>
  );
}

/// Reports that the shown plant is not the text's, since the text has faults: a border, and a link to the first fault.
function StalePlant(): ReactElement | null {
  const page = use_page();
  const { shown } = use_store(page.growth);
  const { side } = use_store(page.shell);
  const { good, faults, text } = use_document();
  const errors = faults.filter((one) => one.severity === 'error');
  if (good || text === '' || !shown) return null;
  const first = errors[0];
  return (
    <div className="stale-plant" role="status" data-mark="stale-plant">
      <p>
        <Icon name="fault" />
        <span>
          <strong>This is the last plant without faults.</strong>{' '}
          {errors.length === 1 ? 'The text has a fault' : `The text has ${errors.length} faults`}
          {first ? `${first.line === null ? '' : ` in line ${first.line}`}: ${first.message}` : ''}
        </span>
        {side !== 'text' && (
          <Button kind="quiet" press={() => page.shell.merge({ side: 'text' })}>
            Show the text
          </Button>
        )}
      </p>
    </div>
  );
}

/// The message of the view if there is nothing to see.
function Nothing(): ReactElement | null {
  const page = use_page();
  const { shown, failed, working } = use_store(page.growth);
  const { good, text, hash } = use_document();
  if (failed) {
    return (
      <p className="view-note fault">
        {failed.message || failed.faults[0]?.message}. {left_to_see(shown, hash)}
        {failed.continues && (
          <Button
            kind="quiet"
            tip="Goes on from what is finished, for as long again"
            press={() => continue_growth(page)}
          >
            Continue
          </Button>
        )}
      </p>
    );
  }
  if (!good && text !== '' && !shown)
    return <p className="view-note fault">The text has faults: there is no plant to show yet.</p>;
  if (!good && text !== '') return null;
  if (shown && shown.of.triangles === 0) return <p className="view-note">Nothing of this document can be seen.</p>;
  if (!shown) return <p className="view-note">{working ? 'Growing…' : 'Waiting for the plant…'}</p>;
  return null;
}

/// Continues the growth that reached its time limit.
function continue_growth(page: Page): void {
  page.growth.merge({ failed: null });
  page.connection.tell('continue');
}

/// Returns a message about what the view still shows of a document whose growth has failed.
function left_to_see(shown: GrowthState['shown'], hash: string): string {
  if (!shown) return 'There is nothing to show yet.';
  return shown.draft && shown.hash === hash
    ? 'What is shown is a draft.'
    : 'What is shown is the last plant that could grow.';
}
