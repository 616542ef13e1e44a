// SPDX-License-Identifier: Apache-2.0
// The attraction points of a component's crown, drawn behind its outlines. The points are turned about the vertical
// into the plane of an outline.
import { Newest } from '../base/newest.ts';
import { Store } from '../base/store.ts';
import type { Page } from '../page/page.ts';
import { floats } from '../server/packet.ts';
import type { Grown } from '../server/protocol.ts';
import type { Json } from '../values/json.ts';
import { is_object } from '../values/json.ts';
import type { Point } from './shape.ts';

export interface ToldCloud {
  component: string;
  positions: Float32Array; // x, y and z of each point, relative to its root
  count: number; // number of all points; `positions` can hold fewer
}

export class CrownCloud {
  readonly told = new Store<ToldCloud | null>(null);
  private readonly newest_ = new Newest();
  private asked_: { component: string; grown: Grown } | null = null;

  constructor(private readonly page_: Page) {}

  /// Resets the points for another document.
  forget(): void {
    this.newest_.drop();
    this.asked_ = null;
    this.told.set(null);
  }

  /// Requests the points of a component, once for each growth. Only the newest answer counts.
  follow(component: string, grown: Grown): void {
    if (this.asked_?.component === component && this.asked_.grown === grown) return;
    this.asked_ = { component, grown };
    const counts = this.newest_.begin();
    this.page_.connection
      .request('cloud', { component })
      .then(({ cloud, arrays }) => {
        if (counts())
          this.told.set(cloud && { component, positions: floats(arrays, cloud.positions), count: cloud.count });
      })
      .catch(() => undefined);
  }
}

/// Returns the points in the plane of an outline, as radius and height. An outline at an azimuth gets the points that
/// are not nearer to another outline.
export function turned_points(
  positions: ArrayLike<number>,
  azimuth: number | null,
  others: readonly number[],
): Point[] {
  const points: Point[] = [];
  for (let k = 0; k + 2 < positions.length; k += 3) {
    const [x, y, z] = [positions[k] ?? 0, positions[k + 1] ?? 0, positions[k + 2] ?? 0];
    const own = (Math.atan2(x, -z) * 180) / Math.PI; // degrees from north over east
    if (azimuth !== null && others.some((other) => apart(own, other) < apart(own, azimuth))) continue;
    points.push([Math.hypot(x, z), y]);
  }
  return points;
}

/// Returns the smaller angle between two azimuths, degrees.
function apart(one: number, other: number): number {
  const turn = (((one - other) % 360) + 360) % 360;
  return Math.min(turn, 360 - turn);
}

/// Returns the azimuths of a crown's outlines, which are the names in its `profiles`.
export function azimuths_of(profiles: Json | undefined): number[] {
  return is_object(profiles) ? Object.keys(profiles).map(Number).filter(Number.isFinite) : [];
}
