// SPDX-License-Identifier: Apache-2.0
// The limits of a row, drawn in the picture of its points.
import type { ReactElement } from 'react';

import type { Limits } from './limits.ts';
import type { PictureSize, Scale } from './plane.ts';
import type { Range } from './shape.ts';

/// Shades the area outside of the legal values, up to a line at the limit.
export function LimitLines({
  scale,
  size,
  limits: { x, y },
}: {
  scale: Scale;
  size: PictureSize;
  limits: Limits;
}): ReactElement {
  const seen = scale.seen;
  const [left, bottom] = scale.place([x.low, y.low]);
  const [right, top] = scale.place([x.high, y.high]);
  const is_seen = (value: number, range: Range): boolean => value > range.low && value < range.high;
  return (
    <g className="curve-limits" aria-hidden="true">
      {is_seen(x.low, seen.x) && (
        <LimitLine name="x-low" box={[0, 0, left, size.high]} line={[left, 0, left, size.high]} />
      )}
      {is_seen(x.high, seen.x) && (
        <LimitLine name="x-high" box={[right, 0, size.wide - right, size.high]} line={[right, 0, right, size.high]} />
      )}
      {is_seen(y.low, seen.y) && (
        <LimitLine
          name="y-low"
          box={[0, bottom, size.wide, size.high - bottom]}
          line={[0, bottom, size.wide, bottom]}
        />
      )}
      {is_seen(y.high, seen.y) && (
        <LimitLine name="y-high" box={[0, 0, size.wide, top]} line={[0, top, size.wide, top]} />
      )}
    </g>
  );
}

interface LimitLineProps {
  name: string;
  box: readonly [number, number, number, number]; // left, top, width, height
  line: readonly [number, number, number, number]; // from, to
}

function LimitLine({ name, box, line }: LimitLineProps): ReactElement {
  return (
    <g data-limit={name}>
      <rect x={box[0]} y={box[1]} width={box[2]} height={box[3]} />
      <line x1={line[0]} y1={line[1]} x2={line[2]} y2={line[3]} />
    </g>
  );
}
