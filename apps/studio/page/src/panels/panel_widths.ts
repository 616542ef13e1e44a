// SPDX-License-Identifier: Apache-2.0
// The widths of the panels, which the browser keeps.
import { useState } from 'react';

import { prefer, preference } from '../base/preferences.ts';

/// The panel to the left of the view, and the panels to its right.
export type Panel = 'left' | 'board' | 'inspector' | 'text' | 'grammar' | 'measures' | 'plan';

/// Allowed widths of each panel, pixels.
export const kWidths: Record<Panel, { low: number; high: number }> = {
  left: { low: 220, high: 480 },
  board: { low: 320, high: 1600 },
  inspector: { low: 300, high: 640 },
  text: { low: 320, high: 1200 },
  measures: { low: 300, high: 900 },
  grammar: { low: 320, high: 1200 },
  plan: { low: 300, high: 900 },
};

/// Returns the width, or null for the default of the style, and a function that changes it.
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
