// SPDX-License-Identifier: Apache-2.0
// The layout of the page. Each panel beside the view is one line of `kSides`.
import type { ReactElement } from 'react';

import { use_store } from '../base/store.ts';
import { BoardPanel } from '../board/board_panel.tsx';
import { Segments } from '../controls/button.tsx';
import { Splitter } from '../controls/splitter.tsx';
import { Dialogs } from '../dialogs/dialogs.tsx';
import { Drawer } from '../editors/drawer.tsx';
import { PinnedViews } from '../find/pinned_views.tsx';
import { GrammarPanel } from '../grammar/grammar_panel.tsx';
import { CurvePanel } from '../grass/curve_panel.tsx';
import { MeasuresPanel } from '../measures/measures_panel.tsx';
import type { ShellState } from '../page/page_state.ts';
import { use_page } from '../page/use_page.ts';
import { PlanPanel } from '../pruning/plan_panel.tsx';
import { TimelinePanel } from '../timeline/timeline_panel.tsx';
import { ConflictBanner, ElsewhereBanner, KeptBanner, LostBanner } from './banners.tsx';
import { Handles } from './handles.tsx';
import { Hints } from './hints.tsx';
import { Inspector } from './inspector.tsx';
import { Outline } from './outline.tsx';
import { kWidths, use_width } from './panel_widths.ts';
import { toggle_board } from './shortcuts.ts';
import { StatusLine } from './status_line.tsx';
import { TextPanel } from './text_panel.tsx';
import { Toasts } from './toasts.tsx';
import { TopBar } from './top_bar.tsx';
import { ViewPanel } from './view_panel.tsx';

type Side = ShellState['side'];

const kSides: Record<Side, { title: string; Content: () => ReactElement }> = {
  inspector: { title: 'Inspector', Content: InspectorWithHints },
  text: { title: 'Text', Content: TextPanel },
  grammar: { title: 'Grammar', Content: GrammarPanel },
  plan: { title: 'Plan', Content: PlanPanel },
  measures: { title: 'Measures', Content: MeasuresPanel },
};
const kTabs = (Object.keys(kSides) as Side[]).map((name) => [name, kSides[name].title] as const);

export function App(): ReactElement {
  return (
    <div className="app">
      <TopBar />
      <div className="banners">
        <LostBanner />
        <KeptBanner />
        <ConflictBanner />
        <ElsewhereBanner />
      </div>
      <main className="work">
        <LeftPanel />
        <section className="centre" aria-label="The plant">
          <div className="views">
            <PinnedViews />
            <ViewPanel />
          </div>
          <Drawer />
          <CurvePanel />
          <TimelinePanel />
        </section>
        <SidePanel />
      </main>
      <StatusLine />
      <Toasts />
      <Dialogs />
    </div>
  );
}

const kLeft = [
  ['outline', 'Outline'],
  ['board', 'Board'],
] as const;

function LeftPanel(): ReactElement {
  const page = use_page();
  const { left } = use_store(page.shell);
  const panel = left === 'board' ? 'board' : 'left';
  const widths = { left: use_width('left'), board: use_width('board') };
  const [width, change] = widths[panel];
  return (
    <aside className={`left of-${left}`} aria-label="Handles and outline" style={{ width: width ?? undefined }}>
      <Handles />
      <div className="left-tabs">
        <Segments
          label="Outline or board"
          value={left}
          choices={kLeft}
          choose={(one) => one !== left && toggle_board(page)}
        />
      </div>
      {left === 'board' ? <BoardPanel /> : <Outline />}
      <Splitter label="Width of handles and outline" edge="right" width={width} change={change} {...kWidths[panel]} />
    </aside>
  );
}

function SidePanel(): ReactElement {
  const page = use_page();
  const { side } = use_store(page.shell);
  const widths = {
    inspector: use_width('inspector'),
    text: use_width('text'),
    grammar: use_width('grammar'),
    measures: use_width('measures'),
    plan: use_width('plan'),
  };
  const [width, change] = widths[side];
  const { Content } = kSides[side];
  return (
    <aside
      className={`right of-${side}`}
      aria-label="Inspector, text, grammar, measures and plan"
      style={{ width: width ?? undefined }}
    >
      <div className="side-tabs">
        <Segments label="Side panel" value={side} choices={kTabs} choose={(one) => page.shell.merge({ side: one })} />
      </div>
      <Content />
      <Splitter label="Width of inspector and text" edge="left" width={width} change={change} {...kWidths[side]} />
    </aside>
  );
}

function InspectorWithHints(): ReactElement {
  return (
    <>
      <Inspector />
      <Hints />
    </>
  );
}
