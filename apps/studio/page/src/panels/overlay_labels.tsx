// SPDX-License-Identifier: Apache-2.0
// The labels of all overlays, at their pixels.
import type { ReactElement } from 'react';

import { use_store } from '../base/store.ts';
import { use_page } from '../page/use_page.ts';

export function OverlayLabels(): ReactElement | null {
  const page = use_page();
  use_store(page.view_facts); // the camera may have moved
  const labels = page.view?.overlays.labels ?? [];
  if (labels.length === 0) return null;
  return (
    <div className="overlay-labels" aria-hidden="true">
      {labels.map(({ at, text }, k) => {
        const seen = page.view?.eye.project(at);
        return seen ? (
          <span key={k} style={{ left: seen[0], top: seen[1] }}>
            {text}
          </span>
        ) : null;
      })}
    </div>
  );
}
