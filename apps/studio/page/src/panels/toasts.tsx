// SPDX-License-Identifier: Apache-2.0
import type { ReactElement } from 'react';

import { use_store } from '../base/store.ts';
import { IconButton } from '../controls/button.tsx';
import { use_page } from '../page/use_page.ts';

/// Short messages that disappear after a while.
export function Toasts(): ReactElement {
  const page = use_page();
  const toasts = use_store(page.toasts.shown);
  return (
    <div className="toasts" role="status" aria-live="polite">
      {toasts.map((toast) => (
        <div key={toast.id} className={`toast${toast.is_fault ? ' fault' : ''}`}>
          <span>{toast.text}</span>
          <IconButton is_small icon="close" label="Dismiss" press={() => page.toasts.dismiss(toast.id)} />
        </div>
      ))}
    </div>
  );
}
