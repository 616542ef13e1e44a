// SPDX-License-Identifier: Apache-2.0
import { StrictMode } from 'react';
import { createRoot } from 'react-dom/client';

import { claim_tab } from './base/tab.ts';
import { start_tooltips } from './controls/tooltip.ts';
import { kRowKinds } from './editors/all_row_kinds.ts';
import { PageContext } from './page/use_page.ts';
import { App } from './panels/app.tsx';
import { listen_to_keys } from './panels/shortcuts.ts';
import { RowKindsContext } from './rows/row_kinds.ts';
import { Studio } from './studio.ts';
import type { Tables } from './tables/tables.ts';
import type { Json } from './values/json.ts';

declare global {
  interface Window {
    studio?: Studio; // for tests and for experiments in the console
  }
}

function follow_theme(studio: Studio): void {
  const system = matchMedia('(prefers-color-scheme: dark)');
  const paint = (): void => {
    const { theme, is_dark } = studio.shell.get();
    const wanted = theme === 'dark' || (theme === 'system' && system.matches);
    document.documentElement.dataset['theme'] = wanted ? 'dark' : 'light';
    if (wanted !== is_dark) studio.shell.merge({ is_dark: wanted });
    studio.refresh_view();
  };
  system.addEventListener('change', paint);
  studio.shell.subscribe(paint);
  paint();
}

async function start(): Promise<void> {
  const tables = (await (await fetch('tables.json')).json()) as Tables;
  const socket = new URL('socket', document.baseURI);
  socket.protocol = socket.protocol === 'https:' ? 'wss:' : 'ws:';
  const studio = new Studio(tables, socket.href, await claim_tab());
  studio.board.starters = await fetch('starters.json').then((answer) =>
    answer.ok ? (answer.json() as Promise<Record<string, Json>>) : {},
  );
  window.studio = studio;
  follow_theme(studio);
  listen_to_keys(studio);
  const root = document.getElementById('root');
  if (!root) return;
  start_tooltips(document.body);
  createRoot(root).render(
    <StrictMode>
      <PageContext.Provider value={studio}>
        <RowKindsContext.Provider value={kRowKinds}>
          <App />
        </RowKindsContext.Provider>
      </PageContext.Provider>
    </StrictMode>,
  );
  studio.connection.connect();
}

void start();
