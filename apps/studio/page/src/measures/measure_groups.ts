// SPDX-License-Identifier: Apache-2.0
// Groups of measures with headings, and their values as text.

import type { MeasureRow } from '../server/protocol.ts';
import type { Json } from '../values/json.ts';

export interface MeasureGroup {
  title: string;
  rows: MeasureRow[];
}

/// The first measure under each heading, in the order of all measures.
const kHeadings: readonly (readonly [string, string])[] = [
  ['trees', 'Counts'],
  ['length', 'Size and crown'],
  ['lit_share', 'Light on the crown'],
  ['stem_diameter', 'Stem'],
  ['inclination_azimuth', 'Lean'],
  ['branching_angle_mean', 'Branching'],
  ['pipe_exponent', 'Thickness at forks'],
  ['leaf_count', 'Leaves'],
  ['thickened_below', 'Geometry'],
];

export function groups_of(rows: readonly MeasureRow[]): MeasureGroup[] {
  const groups: MeasureGroup[] = [];
  for (const row of rows) {
    const heading = kHeadings.find(([first]) => first === row.name)?.[1];
    if (heading !== undefined || groups.length === 0) groups.push({ title: heading ?? 'Measures', rows: [] });
    groups.at(-1)?.rows.push(row);
  }
  return groups;
}

/// Returns a value as text: four digits, or whole numbers in full.
export function shown_measure(value: Json | undefined): string {
  if (typeof value === 'number')
    return Number.isInteger(value)
      ? value.toLocaleString('en')
      : Math.abs(value) >= 1000
        ? Math.round(value).toLocaleString('en')
        : String(Number(value.toPrecision(4)));
  if (Array.isArray(value)) return value.map((one) => shown_measure(one)).join(', ');
  return '–';
}
