// SPDX-License-Identifier: Apache-2.0
// Lines and points of a plane that the user cannot move.
import type { ReactElement } from 'react';
import { useMemo } from 'react';

import type { Scale } from './plane.ts';
import type { Point } from './shape.ts';

export interface PlaneLine {
  points: readonly Point[];
  // Behind: source of the points; dots and cloud: not joined
  kind: 'line' | 'filled' | 'mirror' | 'behind' | 'dots' | 'cloud';
}

export function DrawnLine({ scale, line: { points, kind } }: { scale: Scale; line: PlaneLine }): ReactElement {
  if (kind === 'dots') return <Dots scale={scale} points={points} />;
  if (kind === 'cloud') return <Cloud scale={scale} points={points} />;
  return (
    <polyline
      className={`curve-line ${kind}`}
      points={points
        .map((point) =>
          scale
            .place(point)
            .map((one) => one.toFixed(1))
            .join(','),
        )
        .join(' ')}
    />
  );
}

/// Thousands of small points. Their path is made once and then moved and scaled with the picture.
function Cloud({ scale, points }: { scale: Scale; points: readonly Point[] }): ReactElement {
  const path = useMemo(() => points.map(([x, y]) => `M${x.toFixed(4)} ${y.toFixed(4)}h0`).join(''), [points]);
  const [[left, top], [across, up]] = [scale.place([0, 0]), scale.pixel];
  return (
    <path
      className="curve-cloud"
      aria-hidden="true"
      data-points={points.length}
      d={path}
      transform={`matrix(${1 / across} 0 0 ${-1 / up} ${left} ${top})`}
    />
  );
}

/// Points that the user cannot move.
function Dots({ scale, points }: { scale: Scale; points: readonly Point[] }): ReactElement {
  return (
    <g className="curve-dots" aria-hidden="true">
      {points.map((point, k) => (
        <circle key={k} cx={scale.place(point)[0].toFixed(1)} cy={scale.place(point)[1].toFixed(1)} r="2.5" />
      ))}
    </g>
  );
}
