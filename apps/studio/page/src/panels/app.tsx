// SPDX-License-Identifier: Apache-2.0
import type { ReactElement } from 'react';

import { use_store } from '../base/store.ts';
import { Segments } from '../controls/button.tsx';
import { Dialogs } from '../dialogs/dialogs.tsx';
import { use_studio } from '../studio_context.ts';
import { ConflictBanner, KeptBanner, LostBanner } from './banners.tsx';
import { Handles } from './handles.tsx';
import { Hints } from './hints.tsx';
import { Inspector } from './inspector.tsx';
import { Outline } from './outline.tsx';
import { StatusLine } from './status_line.tsx';
import { TextPanel } from './text_panel.tsx';
import { Toasts } from './toasts.tsx';
import { TopBar } from './top_bar.tsx';
import { ViewPanel } from './view_panel.tsx';

const kSides = [
  ['inspector', 'Inspector'],
  ['text', 'Text'],
] as const;

export function App(): ReactElement {
  const studio = use_studio();
  const { side } = use_store(studio.shell);
  return (
    <div className={`app side-${side}`}>
      <TopBar />
      <div className="banners">
        <LostBanner />
        <KeptBanner />
        <ConflictBanner />
      </div>
      <main className="work">
        <aside className="left" aria-label="Handles and outline">
          <Handles />
          <Outline />
        </aside>
        <section className="centre" aria-label="The plant">
          <ViewPanel />
        </section>
        <aside className="right" aria-label="Inspector and text">
          <div className="side-tabs">
            <Segments label="Side panel" value={side} choices={kSides} choose={(one) => studio.shell.merge({ side: one })} />
          </div>
          {side === 'inspector' ? <Inspector /> : <TextPanel />}
          {side === 'inspector' && <Hints />}
        </aside>
      </main>
      <StatusLine />
      <Toasts />
      <Dialogs />
    </div>
  );
}
