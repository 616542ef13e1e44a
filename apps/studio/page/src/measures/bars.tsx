// SPDX-License-Identifier: Apache-2.0
// Small plots of lists: bars side by side, and the leaf area of layers one above another.
import type { ReactElement } from 'react';

import type { Json } from '../values/json.ts';
import { member_of } from '../values/path.ts';
import { shown_measure } from './measure_groups.ts';

const kHigh = 28; // pixels

export function Bars({ label, values }: { label: string; values: readonly Json[] }): ReactElement {
  const numbers = values.map((one) => (typeof one === 'number' ? one : 0));
  const max = Math.max(...numbers, 1e-12);
  return (
    <span
      className="bars"
      role="img"
      aria-label={`${label}: ${shown_measure([...values])}`}
      data-tip={numbers.map((one, k) => `${k}: ${shown_measure(one)}`).join('\n')}
    >
      {numbers.map((one, k) => (
        <span key={k} style={{ height: `${Math.max(1, (kHigh * one) / max)}px` }} />
      ))}
    </span>
  );
}

/// Leaf area by height, the highest layer on top.
export function Layers({ layers }: { layers: Json }): ReactElement | null {
  const all = Array.isArray(layers) ? layers : [];
  const number = (layer: Json, name: string): number => {
    const value = member_of(layer, name);
    return typeof value === 'number' ? value : 0;
  };
  const shown = (layer: Json, name: string): string => shown_measure(number(layer, name));
  const max = Math.max(...all.map((one) => number(one, 'leaf_area')), 1e-12);
  if (all.length === 0) return null;
  return (
    <div className="row-group">
      <h3>Leaf area by height</h3>
      <ol className="layers" aria-label="Leaf area by height, from above">
        {[...all].reverse().map((one, k) => (
          <li key={k} data-tip={`${shown(one, 'low')} to ${shown(one, 'high')} m: ${shown(one, 'leaf_area')} m²`}>
            <span className="quiet">{shown(one, 'low')} m</span>
            <span className="layer" style={{ width: `${(100 * number(one, 'leaf_area')) / max}%` }} />
            <span>{shown(one, 'leaf_area')} m²</span>
          </li>
        ))}
      </ol>
    </div>
  );
}
