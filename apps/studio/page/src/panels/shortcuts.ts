// SPDX-License-Identifier: Apache-2.0
// Keys that act on the whole page, and the list of all keys.
import { prefer } from '../base/preferences.ts';
import type { Page } from '../page/page.ts';
import { TimeModel } from '../time/time_model.ts';
import { GrowthLook } from '../growth/growth_look.ts';
import { PinList } from '../find/pins.ts';
import { save_document } from '../saving/saving.ts';

export interface Shortcut {
  keys: string;
  text: string;
}

export const kShortcuts: { title: string; keys: Shortcut[] }[] = [
  {
    title: 'Document',
    keys: [
      { keys: 'Ctrl+O', text: 'Open a file' },
      { keys: 'Ctrl+M', text: 'Shipped plants' },
      { keys: 'Ctrl+S', text: 'Save' },
      { keys: 'Ctrl+Shift+S', text: 'Save as' },
      { keys: 'Ctrl+E', text: 'Export' },
      { keys: 'Ctrl+Z', text: 'Undo' },
      { keys: 'Ctrl+Shift+Z', text: 'Redo' },
      { keys: 'R', text: 'Roll the seed' },
      { keys: 'T', text: 'Text or inspector' },
      { keys: 'G', text: 'Grammar or inspector' },
      { keys: 'O', text: 'Plan of operations or inspector' },
      { keys: 'M', text: 'Measures or inspector' },
      { keys: 'N', text: 'Nine plants by chance' },
      { keys: 'P', text: 'Pin the state beside the view' },
    ],
  },
  {
    title: 'Board',
    keys: [
      { keys: 'B', text: 'Board or outline' },
      { keys: 'A', text: 'Add a component below the chosen one' },
      { keys: 'Arrow keys', text: 'Go from component to component' },
      { keys: 'Alt+arrow keys', text: 'Move the component among its siblings; with Shift, in the document' },
      { keys: 'L', text: 'Link from the component: choose the other end, Enter' },
      { keys: 'F2, N', text: 'Rename; note' },
      { keys: 'Ctrl+D, Ctrl+C, Ctrl+V', text: 'Duplicate, copy, paste below' },
      { keys: 'Del', text: 'Delete, with what stands on it alone' },
      { keys: 'Space, H, S', text: 'Fold, hide, show alone' },
    ],
  },
  {
    title: 'View',
    keys: [
      { keys: 'Click', text: 'Choose the component that is seen there' },
      { keys: 'Drag', text: 'Turn' },
      { keys: 'Shift+Drag, right button', text: 'Move' },
      { keys: 'Wheel', text: 'Zoom' },
      { keys: 'F', text: 'Fit the plant' },
      { keys: '1, 3, 7', text: 'From the front, the side, above' },
      { keys: 'W', text: 'Shaded, wireframe, skeleton' },
      { keys: 'E', text: 'Grips of what is chosen' },
      { keys: 'S', text: 'Steps of growth, and what the plant grew by' },
      { keys: 'Arrow keys, +, −', text: 'Turn and zoom, when the view has the keyboard' },
    ],
  },
  {
    title: 'Shoots of a tree',
    keys: [
      { keys: 'Enter', text: 'Take hold of a shoot, when the view has the keyboard' },
      { keys: 'Left, Right', text: 'To the shoot that bears it, to one that it bears' },
      { keys: 'PageUp, PageDown', text: 'To its neighbours' },
      { keys: 'Up, Down, Home, End', text: 'Along the shoot: the place of the cut' },
      { keys: 'C, B, T, M', text: 'Cut, bend, tie, mark; Enter does it' },
      { keys: 'Esc', text: 'Let it go' },
    ],
  },
  {
    title: 'Grips in the view',
    keys: [
      { keys: 'Drag', text: 'Move, size or turn in whole steps; Alt or Shift finely' },
      { keys: 'Arrow keys', text: 'A step along the grip; Shift finely, Ctrl coarsely' },
      { keys: 'PageUp, PageDown', text: 'Choose another grip' },
      { keys: 'Esc', text: 'Back to what it was; then hide the grips' },
    ],
  },
  {
    title: 'Time',
    keys: [
      { keys: 'K', text: 'Timeline' },
      { keys: 'Shift+K', text: 'Play, stop' },
      { keys: 'Left, Right', text: 'A frame back, on; the time or the chosen key. Ten with Shift' },
      { keys: 'Delete', text: 'Remove the chosen key' },
    ],
  },
  {
    title: 'Numbers',
    keys: [
      { keys: 'Drag across', text: 'Change; Shift finely, Ctrl coarsely' },
      { keys: 'Up, Down', text: 'A step; Shift finely, Ctrl coarsely' },
      { keys: 'Enter', text: 'Take over: 1/3, 2*(4+0.5), or an expression' },
      { keys: 'Esc', text: 'Back to what it was' },
    ],
  },
  {
    title: 'Points of curves, outlines and axes',
    keys: [
      { keys: 'Drag', text: 'Move; Alt is drawn to nothing' },
      { keys: 'Double click, +', text: 'Add a point' },
      { keys: 'Delete', text: 'Remove the chosen point' },
      { keys: 'Arrow keys', text: 'Move it; Shift finely, Ctrl coarsely' },
      { keys: 'PageUp, PageDown, Home, End', text: 'Choose another point' },
    ],
  },
];

export function save_here(page: Page): void {
  const { path } = page.document.state.get();
  if (path === null) page.shell.merge({ dialog: 'save' });
  else void save_document(page, path, false);
}

export function toggle_board(page: Page): void {
  const left = page.shell.get().left === 'board' ? 'outline' : 'board';
  prefer('left', left);
  page.shell.merge({ left });
}

function next_drawing(page: Page): void {
  const order = ['shaded', 'wireframe', 'skeleton'] as const;
  const at = order.indexOf(page.view_state.get().drawing);
  page.change_view({ drawing: order[(at + 1) % 3] ?? 'shaded' });
}

const kWithControl: Record<string, (page: Page) => void> = {
  o: (page) => page.shell.merge({ dialog: 'open' }),
  m: (page) => page.shell.merge({ dialog: 'models' }),
  s: save_here,
  S: (page) => page.shell.merge({ dialog: 'save' }),
  e: (page) => page.shell.merge({ dialog: 'export' }),
  z: (page) => void page.undo(),
  Z: (page) => void page.redo(),
  y: (page) => void page.redo(),
};

const kPlain: Record<string, (page: Page) => void> = {
  f: (page) => page.view?.fit(),
  '1': (page) => page.view?.look_from(180, 0),
  '3': (page) => page.view?.look_from(90, 0),
  '7': (page) => page.view?.look_from(180, 89.5),
  w: next_drawing,
  e: (page) => page.change_view({ shows_grips: !page.view_state.get().shows_grips }),
  s: (page) => page.tool(GrowthLook).toggle(),
  r: (page) => page.set_value('seed', 1 + Math.floor(Math.random() * 9999), 'Roll the seed'),
  b: toggle_board,
  a: (page) => page.shell.merge({ dialog: 'palette' }),
  t: (page) => page.shell.merge({ side: page.shell.get().side === 'text' ? 'inspector' : 'text' }),
  g: (page) => page.shell.merge({ side: page.shell.get().side === 'grammar' ? 'inspector' : 'grammar' }),
  o: (page) => page.shell.merge({ side: page.shell.get().side === 'plan' ? 'inspector' : 'plan' }),
  m: (page) => page.shell.merge({ side: page.shell.get().side === 'measures' ? 'inspector' : 'measures' }),
  n: (page) => page.shell.merge({ dialog: 'chance' }),
  p: (page) => page.tool(PinList).add(page.document.state.get()),
  k: (page) => page.tool(TimeModel).toggle(),
  K: (page) => (page.tool(TimeModel).state.get().is_playing ? page.tool(TimeModel).stop() : page.tool(TimeModel).play()),
  '?': (page) => page.shell.merge({ dialog: 'shortcuts' }),
};

function is_typed_into(target: EventTarget | null): boolean {
  return target instanceof HTMLElement && (target.isContentEditable || target.matches('input:not([type=range]):not([type=color]), textarea, select'));
}

/// Undo and redo belong to the field while its typed text is not applied yet.
function belongs_to_field(event: KeyboardEvent): boolean {
  return /^[zy]$/i.test(event.key) && event.target instanceof HTMLElement && event.target.matches('[data-typed]');
}

export function listen_to_keys(page: Page): void {
  document.addEventListener('keydown', (event) => {
    if (page.shell.get().dialog !== null) return;
    const has_control = event.ctrlKey || event.metaKey;
    if (event.key === 'Escape') page.stop_drag();
    const act = has_control ? kWithControl[event.shiftKey ? event.key.toUpperCase() : event.key] : event.altKey || is_typed_into(event.target) ? undefined : kPlain[event.key];
    if (!act || belongs_to_field(event)) return;
    event.preventDefault();
    act(page);
  });
}
