// SPDX-License-Identifier: Apache-2.0
// The measured points of a midrib and the curve that is fitted to them, beside the leaf in the view: in the frame of the
// component's first leaf, as long as its blade.
import type { ReactElement } from 'react';

import { use_store } from '../base/store.ts';
import { member_of, path_below, value_at } from '../document/path.ts';
import { use_document, use_studio } from '../studio_context.ts';
import { point_in } from '../view/gizmo/space_math.ts';
import { ProjectedLine } from '../view/projected_line.tsx';
import { line_length, place_beside } from './curves.ts';

const kUsualLength = 0.3; // metres, of blades whose length nothing says
const kAside = 0.12; // of the length

export function LeafPointsOverlay(): ReactElement | null {
  const studio = use_studio();
  const component = use_store(studio.bench.leaf_curves.component);
  const curves = use_store(studio.bench.leaf_curves.told);
  const stand = use_store(studio.bench.gizmo.stand);
  const { tree } = use_document();
  use_store(studio.view_facts); // the camera may have moved
  const { view } = studio;
  if (!view || !curves || component === null || stand?.component !== component) return null;
  const said = member_of(value_at(tree, path_below('components', component)), 'length');
  const length = typeof said === 'number' ? said : curves.length || kUsualLength;
  const scale = length / (line_length(curves.midrib) || 1);
  const places = (points: typeof curves.midrib): [number, number, number][] => points.map((one) => [...point_in(stand.frame, place_beside(one, scale, kAside * length))]);
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
