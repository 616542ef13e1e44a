// SPDX-License-Identifier: Apache-2.0
// The state of the page, except the document.
import { preference } from '../base/preferences.ts';
import type { KeptWork } from '../document/recovery.ts';
import type { PacketHead } from '../server/packet.ts';
import type { Failed, Fault, Grown, Hello, Working } from '../server/protocol.ts';
import type { Drawing } from '../view/plant_scene.ts';

export interface GrowthState {
  grown: Grown | null;
  shown: Pick<PacketHead, 'draft' | 'share' | 'triangles' | 'instances' | 'of' | 'hash'> | null;
  working: Working | null;
  failed: { message: string; faults: Fault[]; continues: boolean } | null;
  is_paused: boolean;
}

export const kNoGrowth: GrowthState = { grown: null, shown: null, working: null, failed: null, is_paused: false };

/// Facts that are unknown before full detail is made, or during a drag, keep their previous values.
export function with_growth(growth: GrowthState, grown: Grown): GrowthState {
  const before = growth.grown;
  const counts = {
    triangles: grown.triangles ?? before?.triangles ?? null,
    components: grown.components ?? before?.components ?? null,
    placed: grown.placed ?? before?.placed ?? null,
  };
  return { ...growth, grown: { ...grown, ...counts }, failed: null };
}

export function with_failure(growth: GrowthState, { message, faults = [], continues = false }: Failed): GrowthState {
  return { ...growth, failed: { message, faults, continues } };
}

/// Jobs whose progress panels show themselves.
const kBeside: ReadonlySet<Working['job']> = new Set(['stills', 'grammar', 'picture', 'question']);

/// Other work may continue when this work ends.
export function with_work(growth: GrowthState, message: Working): GrowthState {
  if (kBeside.has(message.job)) return growth;
  if (message.stage !== null) return { ...growth, working: message };
  return growth.working?.job === message.job ? { ...growth, working: null } : growth;
}

export interface ServerState {
  link: 'connecting' | 'open' | 'lost';
  hello: Hello | null;
}

export interface ViewState {
  drawing: Drawing;
  hidden: ReadonlySet<string>; // hidden components
  shows_ground: boolean;
  shows_grips: boolean; // whether grips of the chosen part are shown
  is_sunlit: boolean; // true: lit by the document's sun
  solo: string | null; // the component that is drawn alone with its descendants
}

export const kFirstView: ViewState = {
  drawing: 'shaded',
  hidden: new Set(),
  shows_ground: true,
  shows_grips: true,
  is_sunlit: false,
  solo: null,
};

/// A part under the resting pointer, with its place in the view in pixels.
export interface PointedPart {
  component: string;
  x: number;
  y: number;
}

export type Theme = 'system' | 'light' | 'dark';

export type Dialog =
  | 'open'
  | 'save'
  | 'record'
  | 'still'
  | 'models'
  | 'export'
  | 'shortcuts'
  | 'palette'
  | 'chance'
  | null;

export interface ShellState {
  dialog: Dialog;
  side: 'inspector' | 'text' | 'grammar' | 'measures' | 'plan';
  left: 'outline' | 'board';
  theme: Theme;
  is_dark: boolean;
  shows_hints: boolean;
  /// Unsaved work that is offered again, and the text that was opened. `before` is null if the work is of another
  /// document.
  kept: { work: KeptWork; before: string | null } | null;
  conflict: { path: string } | null; // a file that someone else has changed
  elsewhere: { path: string; count: number } | null; // the file is open in other tabs or programs
}

/// Returns the state of a new page, with the user's last settings.
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
