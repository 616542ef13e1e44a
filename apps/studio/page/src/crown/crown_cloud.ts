// SPDX-License-Identifier: Apache-2.0
// The attraction points of a component's crown, as its outlines are drawn over them: turned about the vertical into the
// plane of an outline.
import { Newest } from '../base/newest.ts';
import { Store } from '../base/store.ts';
import type { Json } from '../document/json.ts';
import { is_object } from '../document/json.ts';
import type { Point } from '../editors/shape.ts';
import type { ArrayPlace, PacketArrays } from '../server/packet.ts';
import { floats } from '../server/packet.ts';
import type { Grown } from '../server/protocol.ts';
import type { Studio } from '../studio.ts';

export interface ToldCloud {
  component: string;
  positions: Float32Array; // x, y, z of each, about its root
  count: number; // of all, where these are some
}

export class CrownCloud {
  readonly told = new Store<ToldCloud | null>(null);
  private readonly newest_ = new Newest();
  private asked_: { component: string; grown: Grown } | null = null;

  constructor(private readonly studio_: Studio) {}

  /// Another document is opened.
  forget(): void {
    this.newest_.drop();
    this.asked_ = null;
    this.told.set(null);
  }

  /// Asks for the points of a component as they have grown last, once for each growth; the newest answer counts.
  follow(component: string, grown: Grown): void {
    if (this.asked_?.component === component && this.asked_.grown === grown) return;
    this.asked_ = { component, grown };
    const counts = this.newest_.begin();
    this.studio_.connection
      .request<{ cloud: { positions: ArrayPlace; count: number } | null; arrays: PacketArrays }>('cloud', { component })
      .then(({ cloud, arrays }) => {
        if (counts()) this.told.set(cloud && { component, positions: floats(arrays, cloud.positions), count: cloud.count });
      })
      .catch(() => undefined);
  }
}

/// The points in the plane of an outline: radius and height. An outline at an azimuth has the points that none of the
/// others is nearer to.
export function turned_points(positions: ArrayLike<number>, azimuth: number | null, others: readonly number[]): Point[] {
  const points: Point[] = [];
  for (let k = 0; k + 2 < positions.length; k += 3) {
    const [x, y, z] = [positions[k] ?? 0, positions[k + 1] ?? 0, positions[k + 2] ?? 0];
    const own = (Math.atan2(x, -z) * 180) / Math.PI; // from north over east
    if (azimuth !== null && others.some((other) => apart(own, other) < apart(own, azimuth))) continue;
    points.push([Math.hypot(x, z), y]);
  }
  return points;
}

/// Degrees between two azimuths, the shorter way round.
function apart(one: number, other: number): number {
  const turn = (((one - other) % 360) + 360) % 360;
  return Math.min(turn, 360 - turn);
}

/// The azimuths of a crown's outlines, as its `profiles` names them.
export function azimuths_of(profiles: Json | undefined): number[] {
  return is_object(profiles) ? Object.keys(profiles).map(Number).filter(Number.isFinite) : [];
}
