// SPDX-License-Identifier: Apache-2.0
// Keys that act on the whole page.
import { prefer } from '../base/preferences.ts';
import { PinList } from '../find/pins.ts';
import { GrowthLook } from '../growth/growth_look.ts';
import type { Page } from '../page/page.ts';
import { save_document } from '../saving/saving.ts';
import { TimeModel } from '../time/time_model.ts';

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
  K: (page) =>
    page.tool(TimeModel).state.get().is_playing ? page.tool(TimeModel).stop() : page.tool(TimeModel).play(),
  '?': (page) => page.shell.merge({ dialog: 'shortcuts' }),
};

function is_typed_into(target: EventTarget | null): boolean {
  return (
    target instanceof HTMLElement &&
    (target.isContentEditable || target.matches('input:not([type=range]):not([type=color]), textarea, select'))
  );
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
    const act = has_control
      ? kWithControl[event.shiftKey ? event.key.toUpperCase() : event.key]
      : event.altKey || is_typed_into(event.target)
        ? undefined
        : kPlain[event.key];
    if (!act || belongs_to_field(event)) return;
    event.preventDefault();
    act(page);
  });
}
