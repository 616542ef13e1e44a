// SPDX-License-Identifier: Apache-2.0
// How wide the panels are; the browser remembers it.
import { useState } from 'react';

import { prefer, preference } from '../base/preferences.ts';

/// The panel left of the view, and those at its right.
export type Panel = 'left' | 'board' | 'inspector' | 'text' | 'grammar' | 'measures';

/// Pixels that a panel may have.
export const kWidths: Record<Panel, { low: number; high: number }> = {
  left: { low: 220, high: 480 },
  board: { low: 320, high: 1600 },
  inspector: { low: 300, high: 640 },
  text: { low: 320, high: 1200 },
  measures: { low: 300, high: 900 },
  grammar: { low: 320, high: 1200 },
};

/// The width, null where the style says it, and what changes it.
export function use_width(panel: Panel): [number | null, (width: number | null) => void] {
  const name = `width of ${panel}`;
  const [width, set_width] = useState(() => known_width(preference(name), kWidths[panel]));
  const change = (wanted: number | null): void => {
    prefer(name, wanted === null ? '' : String(wanted));
    set_width(wanted);
  };
  return [width, change];
}

function known_width(text: string | null, { low, high }: { low: number; high: number }): number | null {
  const width = Number(text);
  return text && Number.isFinite(width) ? Math.min(high, Math.max(low, width)) : null;
}
