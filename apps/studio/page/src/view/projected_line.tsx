// SPDX-License-Identifier: Apache-2.0
// Lines of the world, drawn over the view.
import type { ReactElement } from 'react';

import type { Vec } from '../base/vec.ts';
import type { View } from './view.ts';

interface ProjectedLineProps {
  view: View;
  places: readonly Vec[];
  className: string;
}

/// The line is interrupted where it passes behind the camera.
export function ProjectedLine({ view, places, className }: ProjectedLineProps): ReactElement | null {
  let path = '';
  let is_broken = true;
  for (const place of places) {
    const at = view.eye.project(place);
    if (at) path += `${is_broken ? 'M' : 'L'}${at[0].toFixed(1)} ${at[1].toFixed(1)}`;
    is_broken = at === null;
  }
  return path === '' ? null : <path className={className} d={path} />;
}
