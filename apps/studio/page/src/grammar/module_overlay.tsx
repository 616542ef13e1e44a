// SPDX-License-Identifier: Apache-2.0
// Marks the module that is pointed at over the plant, and finds the module under the pointer in the view.
import type { ReactElement } from 'react';
import { useEffect } from 'react';

import { use_store } from '../base/store.ts';
import type { Page } from '../page/page.ts';
import { use_page } from '../page/use_page.ts';
import type { View } from '../view/view.ts';
import { DerivationModel } from './derivation.ts';
import { nearest_place, place_of } from './drawn_places.ts';
import { short_module } from './word_view.ts';

export function ModuleOverlay(): ReactElement | null {
  const page = use_page();
  const { told } = use_store(page.tool(DerivationModel).state);
  const pointed = use_store(page.tool(DerivationModel).pointed);
  use_store(page.view_facts); // the camera may have moved
  const has_places = (told?.places.length ?? 0) > 0;
  useEffect(() => (has_places ? listen(page) : undefined), [page, has_places]);
  const place = told && pointed ? place_of(told.places, pointed.module) : null;
  const [from, to] = [place && page.view?.eye.project(place.from), place && page.view?.eye.project(place.to)];
  if (!told || !pointed || !from || !to) return null;
  const [left, top] = [Math.max(from[0], to[0]) + 12, Math.min(from[1], to[1]) - 6];
  return (
    <svg className="module-overlay" aria-hidden="true" data-module={pointed.module}>
      <line className="halo" x1={from[0]} y1={from[1]} x2={to[0]} y2={to[1]} />
      <line x1={from[0]} y1={from[1]} x2={to[0]} y2={to[1]} />
      <text x={left} y={top}>
        {short_module(told.modules[pointed.module - told.first] ?? '')}
      </text>
    </svg>
  );
}

/// Follows the pointer over the view, at most once per picture.
function listen(page: Page): () => void {
  const canvas = document.querySelector<HTMLElement>('.centre .view canvas');
  let waiting = 0;
  const move = (event: PointerEvent): void => {
    if (event.buttons !== 0) return;
    cancelAnimationFrame(waiting);
    const at: [number, number] = [event.offsetX, event.offsetY];
    waiting = requestAnimationFrame(() => page.view && point(page, page.view, at));
  };
  const leave = (): void => {
    cancelAnimationFrame(waiting);
    if (page.tool(DerivationModel).pointed.get()?.by === 'view') page.tool(DerivationModel).pointed.set(null);
  };
  canvas?.addEventListener('pointermove', move);
  canvas?.addEventListener('pointerleave', leave);
  return () => {
    leave();
    canvas?.removeEventListener('pointermove', move);
    canvas?.removeEventListener('pointerleave', leave);
  };
}

function point(page: Page, view: View, at: [number, number]): void {
  const places = page.tool(DerivationModel).state.get().told?.places ?? [];
  const module = nearest_place(places, (place) => view.eye.project(place), at);
  const now = page.tool(DerivationModel).pointed.get();
  if (module === null && now?.by !== 'view') return;
  if (module !== now?.module) page.tool(DerivationModel).pointed.set(module === null ? null : { module, by: 'view' });
}
