// SPDX-License-Identifier: Apache-2.0
// The shapes of grips: an arrow, a square of a plane, a ring, a dot, the middle of a face. Each has a wider invisible
// area for grabbing.
import type { ReactElement } from 'react';
import type { Vec } from '../values/space_math.ts';
import { add, beside, cross, times } from '../values/space_math.ts';
import { ProjectedLine } from '../view/projected_line.tsx';
import type { View } from '../view/view.ts';
import type { Grip } from './grip.ts';

const kShortest = 10; // pixels; a shorter arrow, which points at the camera, is not drawn
const kRing = 1.25; // radius of rings, in reaches
const kTip = 9; // pixels
const kSquare = { from: 0.24, to: 0.44 }; // share of a reach, along both directions of a plane

interface GripShapeProps {
  view: View;
  grip: Grip;
  reach: number; // metres
}

export function GripShape({ view, grip, reach }: GripShapeProps): ReactElement | null {
  const { at, way, look } = grip;
  const centre = view.eye.project(at);
  if (!centre) return null;
  if (look === 'arrow') return <Arrow from={centre} to={view.eye.project(add(at, times(way, reach)))} />;
  if (look === 'ring') return <Line view={view} places={circle(at, way, kRing * reach)} />;
  if (look === 'square') return <Square view={view} at={at} way={way} reach={reach} />;
  if (look === 'face') {
    return (
      <g transform={`translate(${centre[0].toFixed(1)} ${centre[1].toFixed(1)})`}>
        <circle className="reach" r="10" />
        <rect x="-4.5" y="-4.5" width="9" height="9" rx="2" />
      </g>
    );
  }
  return (
    <g transform={`translate(${centre[0].toFixed(1)} ${centre[1].toFixed(1)})`}>
      <circle className="reach" r="11" />
      <circle r="6" />
    </g>
  );
}

function Arrow({ from, to }: { from: [number, number]; to: [number, number] | null }): ReactElement | null {
  if (!to) return null;
  const [x, y] = [to[0] - from[0], to[1] - from[1]];
  const long = Math.hypot(x, y);
  if (long < kShortest) return null;
  const [along, aside] = [[x / long, y / long] as const, [-y / long, x / long] as const];
  const tip = (back: number, side: number): string => {
    const place = (axis: 0 | 1): string => (to[axis] - along[axis] * back + aside[axis] * side).toFixed(1);
    return `${place(0)} ${place(1)}`;
  };
  // It begins beside the dot in the middle.
  const start = `${(from[0] + along[0] * 9).toFixed(1)} ${(from[1] + along[1] * 9).toFixed(1)}`;
  return (
    <>
      <path className="reach" d={`M${start}L${to[0].toFixed(1)} ${to[1].toFixed(1)}`} />
      <path className="shaft" d={`M${start}L${tip(kTip, 0)}`} />
      <path className="tip" d={`M${tip(0, 0)}L${tip(kTip + 2, 5)}L${tip(kTip + 2, -5)}Z`} />
    </>
  );
}

function Line({ view, places }: { view: View; places: readonly Vec[] }): ReactElement {
  return (
    <>
      <ProjectedLine view={view} places={places} className="reach" />
      <ProjectedLine view={view} places={places} className="shaft" />
    </>
  );
}

function Square({ view, at, way, reach }: { view: View; at: Vec; way: Vec; reach: number }): ReactElement | null {
  const ways = (
    [
      [1, 0, 0],
      [0, 1, 0],
      [0, 0, 1],
    ] as Vec[]
  )
    .map(
      (axis) =>
        axis.map(
          (one, k) => one - way.reduce((sum, w, j) => sum + w * (axis[j] ?? 0), 0) * (way[k] ?? 0),
        ) as unknown as Vec,
    )
    .filter((one) => Math.hypot(...one) > 0.5);
  const [one, other] = [ways[0] ?? beside(way), ways[1] ?? cross(way, beside(way))];
  const corner = (a: number, b: number): [number, number] | null =>
    view.eye.project(add(at, add(times(one, a * reach), times(other, b * reach))));
  const { from, to } = kSquare;
  const corners = [corner(from, from), corner(to, from), corner(to, to), corner(from, to)];
  if (corners.some((place) => place === null)) return null;
  return (
    <polygon
      className="patch"
      points={corners.map((place) => `${place?.[0].toFixed(1) ?? 0},${place?.[1].toFixed(1) ?? 0}`).join(' ')}
    />
  );
}

function circle(centre: Vec, axis: Vec, radius: number): Vec[] {
  const side = beside(axis);
  const other = cross(axis, side);
  return Array.from({ length: 65 }, (_, k) =>
    add(
      centre,
      add(times(side, radius * Math.cos((Math.PI * k) / 32)), times(other, radius * Math.sin((Math.PI * k) / 32))),
    ),
  );
}
