// SPDX-License-Identifier: Apache-2.0
// Grips that move an object: an arrow along each axis, a square for each plane, a dot for the plane of the screen.

import type { Frame3, Vec } from '../values/space_math.ts';
import { cross, unit } from '../values/space_math.ts';
import type { Amount, Grip, Values } from './grip.ts';

const kAxes = ['x', 'y', 'z'] as const;

/// Returns grips along the axes of a frame.
export function move_grips(at: Vec, frame: Frame3, said: string, values: (amount: Amount) => Values): Grip[] {
  const ways = frame.axes.map((axis) => unit(axis)) as [Vec, Vec, Vec];
  const common = { at, said, now: 0, values };
  const arrows = ways.map(
    (way, k): Grip => ({
      ...common,
      key: `move ${kAxes[k] ?? ''}`,
      label: `Move along ${kAxes[k] ?? ''}`,
      motion: 'line',
      look: 'arrow',
      way,
    }),
  );
  const squares = ways.map((_, k): Grip => {
    const [one, other] = [(k + 1) % 3, (k + 2) % 3];
    const normal = unit(cross(ways[one] ?? [0, 1, 0], ways[other] ?? [0, 0, 1]));
    return {
      ...common,
      key: `move ${kAxes[Math.min(one, other)] ?? ''}${kAxes[Math.max(one, other)] ?? ''}`,
      label: `Move on the plane of ${kAxes[one] ?? ''} and ${kAxes[other] ?? ''}`,
      motion: 'plane',
      look: 'square',
      way: normal,
    };
  });
  return [
    { ...common, key: 'move', label: 'Move across the view', motion: 'free', look: 'dot', way: [0, 1, 0] },
    ...arrows,
    ...squares,
  ];
}
