// SPDX-License-Identifier: Apache-2.0
// A shoot and a position on it as text and numbers.
import type { Vec } from '../base/vec.ts';
import { places_of_numbers } from '../base/vec.ts';
import type { FoundShoot } from '../page/instance_choice.ts';
import type { ShootWay } from '../server/protocol.ts';

/// Messages for a step along the tree that leads nowhere.
export const kNowhere: Record<ShootWay, (shoot: string) => string> = {
  parent: (shoot) => `No shoot bears ${shoot}`,
  child: (shoot) => `${shoot} bears no shoots`,
  next: (shoot) => `${shoot} has no neighbours`,
  previous: (shoot) => `${shoot} has no neighbours`,
};

/// Returns the ancestors of a shoot, the nearest first, each with the metamer of the branch: "main.4" at 2, then "main"
/// at 4, for "main.4.2".
export function bearers_of(label: string): { shoot: string; metamer: number }[] {
  const parts = label.split('.');
  return parts.slice(1).map((_, k) => {
    const end = parts.length - 1 - k;
    return { shoot: parts.slice(0, end).join('.'), metamer: parseInt(parts[end] ?? '', 10) };
  });
}

/// Returns the metamer that is `by` nodes further along the shoot, or the last one in that direction.
export function moved_metamer({ metamers, metamer }: FoundShoot, by: number): number {
  const at = Math.max(0, metamers.lastIndexOf(metamer));
  return metamers[Math.min(metamers.length - 1, Math.max(0, at + by))] ?? metamer;
}

/// Returns the end of the chosen metamer.
export function place_of({ course, metamers, metamer }: FoundShoot): Vec | null {
  return places_of_numbers(course)[Math.max(0, metamers.lastIndexOf(metamer))] ?? null;
}

/// Returns lengths as text: "Order 1, 0.83 m long, 0.21 m from its base".
export function measures_of(shoot: FoundShoot): string {
  const places = places_of_numbers(shoot.course);
  const long = (to: number): string => {
    let sum = 0;
    for (let k = 1; k <= to; k += 1) sum += distance(places[k - 1], places[k]);
    return `${Number(sum.toPrecision(3))} m`;
  };
  const at = Math.max(0, shoot.metamers.lastIndexOf(shoot.metamer));
  return `Order ${bearers_of(shoot.shoot).length}, ${long(places.length - 1)} long, ${long(at)} from its base`;
}

function distance(a: Vec | undefined, b: Vec | undefined): number {
  return a && b ? Math.hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]) : 0;
}
