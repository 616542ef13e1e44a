// SPDX-License-Identifier: Apache-2.0
// The positions of drawn modules: seven numbers for each, its index, its beginning and its end.

export type Spot = [number, number, number];

const kNumbers = 7;
const kReach = 14; // distance in pixels within which a line counts as hit

/// Returns the first position of a module, or null if it draws nothing.
export function place_of(places: readonly number[], module: number): { from: Spot; to: Spot } | null {
  // Positions are sorted by module.
  let [low, high] = [0, places.length / kNumbers];
  while (low < high) {
    const middle = Math.floor((low + high) / 2);
    if ((places[middle * kNumbers] ?? 0) < module) low = middle + 1;
    else high = middle;
  }
  const at = low * kNumbers;
  if (places[at] !== module) return null;
  const spot = (k: number): Spot => [places[at + k] ?? 0, places[at + k + 1] ?? 0, places[at + k + 2] ?? 0];
  return { from: spot(1), to: spot(4) };
}

/// Returns the module that is drawn nearest to a pixel, or null if none is near.
export function nearest_place(
  places: readonly number[],
  project: (spot: Spot) => [number, number] | null,
  [x, y]: [number, number],
): number | null {
  let [best, min] = [null as number | null, kReach];
  for (let at = 0; at + kNumbers <= places.length; at += kNumbers) {
    const from = project([places[at + 1] ?? 0, places[at + 2] ?? 0, places[at + 3] ?? 0]);
    const to = project([places[at + 4] ?? 0, places[at + 5] ?? 0, places[at + 6] ?? 0]);
    if (!from || !to) continue;
    const [dx, dy] = [to[0] - from[0], to[1] - from[1]];
    const along = Math.min(1, Math.max(0, ((x - from[0]) * dx + (y - from[1]) * dy) / (dx * dx + dy * dy || 1)));
    const away = Math.hypot(from[0] + along * dx - x, from[1] + along * dy - y);
    if (away < min) [best, min] = [places[at] ?? null, away];
  }
  return best;
}
