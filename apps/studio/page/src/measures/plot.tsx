// SPDX-License-Identifier: Apache-2.0
// A line over values with a point for each, the present value, and a published range.
import type { KeyboardEvent, ReactElement } from 'react';

import { fitting_step, rounded } from '../values/arithmetic.ts';

export type PlotPoint = readonly [number, number];

interface PlotProps {
  label: string;
  points: readonly PlotPoint[];
  now: number | null; // present value, drawn as a line
  band: { low: number; high: number } | null;
  text: (point: PlotPoint) => string;
  take: (value: number) => void;
}

const kSize = { wide: 300, high: 120, left: 40, right: 8, top: 8, bottom: 20 };

function span(values: readonly number[]): [number, number] {
  const [low, high] = [Math.min(...values), Math.max(...values)];
  const room = high > low ? 0.06 * (high - low) : Math.max(1e-6, 0.5 * Math.abs(high));
  return [low - room, high + room];
}

function marks(low: number, high: number, count: number): number[] {
  const step = fitting_step(low, high, count);
  return Array.from({ length: Math.floor(high / step + 1e-9) - Math.ceil(low / step - 1e-9) + 1 }, (_, k) =>
    rounded((Math.ceil(low / step - 1e-9) + k) * step, step),
  );
}

export function Plot({ label, points, now, band, text, take }: PlotProps): ReactElement | null {
  if (points.length === 0) return null;
  const [x_low, x_high] = [Math.min(...points.map((one) => one[0])), Math.max(...points.map((one) => one[0]))];
  const [y_low, y_high] = span(points.map((one) => one[1]));
  const { wide, high, left, right, top, bottom } = kSize;
  const x = (value: number): number => left + ((wide - left - right) * (value - x_low)) / (x_high - x_low || 1);
  const y = (value: number): number => high - bottom - ((high - top - bottom) * (value - y_low)) / (y_high - y_low);
  const within = (value: number): number => Math.min(high - bottom, Math.max(top, y(value)));
  const press = (value: number) => (event: KeyboardEvent) => {
    if (event.key !== 'Enter' && event.key !== ' ') return;
    event.preventDefault();
    take(value);
  };
  return (
    <svg className="plot" viewBox={`0 0 ${wide} ${high}`} role="group" aria-label={label}>
      {band && within(band.high) < within(band.low) && (
        <rect
          className="plot-band"
          x={left}
          width={wide - left - right}
          y={within(band.high)}
          height={within(band.low) - within(band.high)}
        />
      )}
      {marks(y_low, y_high, 3).map((one) => (
        <g key={`y${one}`} aria-hidden="true">
          <line x1={left} x2={wide - right} y1={y(one)} y2={y(one)} />
          <text x={left - 4} y={y(one) + 3} textAnchor="end">
            {one}
          </text>
        </g>
      ))}
      {marks(x_low, x_high, 4).map((one) => (
        <text key={`x${one}`} aria-hidden="true" x={x(one)} y={high - 6} textAnchor="middle">
          {one}
        </text>
      ))}
      {now !== null && now >= x_low && now <= x_high && (
        <line className="plot-now" x1={x(now)} x2={x(now)} y1={top} y2={high - bottom} />
      )}
      <polyline points={points.map(([at, value]) => `${x(at).toFixed(1)},${y(value).toFixed(1)}`).join(' ')} />
      {points.map((point) => (
        <circle
          key={point[0]}
          cx={x(point[0])}
          cy={y(point[1])}
          r={4}
          role="button"
          tabIndex={0}
          aria-label={`Take ${text(point)}`}
          data-tip={text(point)}
          onClick={() => take(point[0])}
          onKeyDown={press(point[0])}
        />
      ))}
    </svg>
  );
}
