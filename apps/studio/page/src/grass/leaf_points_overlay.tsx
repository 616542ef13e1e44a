// SPDX-License-Identifier: Apache-2.0
// The measured points of a midrib and the fitted curve, drawn beside the leaf in the view. The leaf is the clicked
// instance, or else the first one. The curve has the length of its blade.
import type { ReactElement } from 'react';

import { use_store } from '../base/store.ts';
import { InstanceChoice } from '../page/instance_choice.ts';
import { use_page } from '../page/use_page.ts';
import { frame_of_rows, point_in } from '../values/space_math.ts';
import { ProjectedLine } from '../view/projected_line.tsx';
import { line_length, place_beside } from './curves.ts';
import { LeafCurvesModel } from './leaf_curves.ts';

const kAside = 0.1; // share of the length

export function LeafPointsOverlay(): ReactElement | null {
  const page = use_page();
  const component = use_store(page.tool(LeafCurvesModel).component);
  const curves = use_store(page.tool(LeafCurvesModel).told);
  const seen = use_store(page.tool(InstanceChoice).seen);
  use_store(page.view_facts); // the camera may have moved
  const { view } = page;
  if (!view || !curves || component === null) return null;
  const rows = seen?.component === component ? seen.frame : view.plant.first_frame(component);
  if (!rows) return null;
  // Blades have length 1 and are scaled by their frames.
  const frame = frame_of_rows(rows);
  const scale = 1 / (line_length(curves.midrib) || 1);
  const places = (points: typeof curves.midrib): [number, number, number][] =>
    points.map((one) => [...point_in(frame, place_beside(one, scale, kAside))]);
  return (
    <svg className="leaf-points" aria-hidden="true" data-points={curves.midrib_points.length}>
      <ProjectedLine view={view} places={places(curves.midrib)} className="fitted" />
      {places(curves.midrib_points).map((place, k) => {
        const at = view.eye.project(place);
        return at && <circle key={k} cx={at[0].toFixed(1)} cy={at[1].toFixed(1)} r="3" />;
      })}
    </svg>
  );
}
