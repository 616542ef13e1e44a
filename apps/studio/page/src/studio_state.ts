// SPDX-License-Identifier: Apache-2.0
// What the page shows besides the document.
import { preference } from './base/preferences.ts';
import type { Fault, Grown, Hello, Working } from './server/protocol.ts';
import type { PacketHead } from './server/packet.ts';
import type { Drawing } from './view/plant_scene.ts';
import type { KeptWork } from './recovery.ts';

export interface GrowthState {
  grown: Grown | null;
  shown: Pick<PacketHead, 'draft' | 'share' | 'triangles' | 'instances' | 'of' | 'hash'> | null;
  working: Working | null;
  failed: { message: string; faults: Fault[]; continues: boolean } | null;
  is_paused: boolean;
}

export const kNoGrowth: GrowthState = { grown: null, shown: null, working: null, failed: null, is_paused: false };

/// What is not known until full detail is made, or of a drag, stays what it was.
export function with_growth(growth: GrowthState, grown: Grown): GrowthState {
  const before = growth.grown;
  const counts = {
    triangles: grown.triangles ?? before?.triangles ?? null,
    components: grown.components ?? before?.components ?? null,
    placed: grown.placed ?? before?.placed ?? null,
  };
  return { ...growth, grown: { ...grown, ...counts }, failed: null };
}
/// Jobs that panels wait for themselves.
const kBeside: ReadonlySet<Working['job']> = new Set(['stills', 'grammar', 'picture', 'question']);

/// Work of another kind may go on while this one is over.
export function with_work(growth: GrowthState, news: Working): GrowthState {
  if (kBeside.has(news.job)) return growth;
  if (news.stage !== null) return { ...growth, working: news };
  return growth.working?.job === news.job ? { ...growth, working: null } : growth;
}

export interface ServerState {
  link: 'connecting' | 'open' | 'lost';
  hello: Hello | null;
}

export interface ViewState {
  drawing: Drawing;
  hidden: ReadonlySet<string>; // components that are not drawn
  shows_ground: boolean;
  shows_grips: boolean; // of what is chosen
  is_sunlit: boolean; // by the document's sun
  solo: string | null; // the component that is drawn alone, with all that stands on it
}

export type Theme = 'system' | 'light' | 'dark';

export type Dialog = 'open' | 'save' | 'record' | 'still' | 'models' | 'export' | 'shortcuts' | 'palette' | 'chance' | null;

export interface ShellState {
  dialog: Dialog;
  side: 'inspector' | 'text' | 'grammar' | 'measures' | 'plan';
  left: 'outline' | 'board';
  theme: Theme;
  is_dark: boolean;
  shows_hints: boolean;
  /// Unsaved work that is offered again, and the text that was opened; null where it is of another document.
  kept: { work: KeptWork; before: string | null } | null;
  conflict: { path: string } | null; // a file that someone else has changed
  elsewhere: { path: string; count: number } | null; // the file is open in other tabs or programs
}

/// Returns the state of a new page, with what its user preferred last.
export function first_shell(): ShellState {
  return {
    dialog: null,
    side: 'inspector',
    left: preference('left') === 'board' ? 'board' : 'outline',
    theme: (preference('theme') as Theme | null) ?? 'system',
    is_dark: false,
    shows_hints: preference('hints') !== 'seen',
    kept: null,
    conflict: null,
    elsewhere: null,
  };
}
