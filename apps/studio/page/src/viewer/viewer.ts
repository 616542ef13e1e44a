// SPDX-License-Identifier: Apache-2.0
// The view alone, in a page that holds one plant and needs no server. The page's template contains the bundle of this
// file. Programs that write pages, such as the Python module, insert a scene packet and a title.
import { read_packet } from '../server/packet.ts';
import { scale_bar } from '../view/scale_bar.ts';
import type { ViewFacts } from '../view/view.ts';
import { View } from '../view/view.ts';

const kNumbers = new Intl.NumberFormat('en');

/// `viewer` is the view, set once the packet is applied. Tests wait for it.
declare global {
  interface Window {
    viewer?: View;
  }
}

function element<T extends HTMLElement>(id: string): T {
  const found = document.getElementById(id);
  if (!found) throw new Error(`the page has no element ${id}`);
  return found as T;
}

function show_scale(facts: ViewFacts): void {
  const { pixels, text } = scale_bar(facts.metres_per_pixel);
  const scale = element('scale');
  scale.hidden = false;
  scale.style.setProperty('--pixels', `${pixels}px`);
  element('scale-text').textContent = text;
}

/// Within another page, such as a notebook, the wheel scrolls that page until the view has been clicked.
function leave_the_wheel(canvas: HTMLCanvasElement): void {
  if (window.parent === window) return;
  const leave = (event: WheelEvent) => {
    if (document.activeElement !== canvas) event.stopImmediatePropagation();
  };
  canvas.addEventListener('wheel', leave, { capture: true, passive: true });
}

/// Hides the hint at the first touch; F fits the plant.
function listen_to_hands(view: View, canvas: HTMLCanvasElement): void {
  const touch = () => (element('hint').hidden = true);
  for (const kind of ['pointerdown', 'keydown'] as const) canvas.addEventListener(kind, touch);
  canvas.addEventListener('wheel', () => document.activeElement === canvas && touch(), { passive: true });
  canvas.addEventListener('keydown', (event) => {
    if (event.key.toLowerCase() === 'f' && !event.ctrlKey && !event.metaKey && !event.altKey) view.fit();
  });
}

function follow_theme(view: View): void {
  const is_dark = window.matchMedia('(prefers-color-scheme: dark)');
  const paint = () => view.paint(is_dark.matches, true);
  is_dark.addEventListener('change', paint);
  paint();
}

function open_page(bytes: ArrayBuffer): void {
  const packet = read_packet(bytes);
  const canvas = element<HTMLCanvasElement>('canvas');
  let view: View;
  leave_the_wheel(canvas); // before the view listens
  try {
    view = new View(canvas, { drawn: show_scale, restored: () => undefined });
  } catch {
    throw new Error('This browser gives no WebGL, so the plant cannot be drawn.');
  }
  const [azimuth, altitude] = (canvas.dataset['look'] ?? '').split(' ').map(Number);
  if (azimuth !== undefined && altitude !== undefined) view.look_from(azimuth, altitude);
  view.apply(packet);
  follow_theme(view);
  view.fit();
  listen_to_hands(view, canvas);
  const { triangles, of } = packet.head;
  element('note').textContent =
    triangles < of.triangles ? `${kNumbers.format(triangles)} of ${kNumbers.format(of.triangles)} triangles` : '';
  if (triangles === 0) element('note').textContent = 'Nothing of this plant can be seen.';
  window.viewer = view;
}

/// Called by the page's own script with the unpacked data.
Object.assign(window, { open_page });
