// SPDX-License-Identifier: Apache-2.0
// The number of triangles that a view draws, during movements and at rest. It is smaller if a processor draws them.

export interface Budgets {
  drag_triangles: number;
  rest_triangles: number;
}

const kBySoftware: Budgets = { drag_triangles: 60_000, rest_triangles: 250_000 };
const kByCard: Budgets = { drag_triangles: 1_000_000, rest_triangles: 4_000_000 };

export function budgets_of(view: { is_software: boolean } | null): Budgets {
  return view?.is_software === false ? kByCard : kBySoftware;
}

/// Returns true if a processor draws, and not a graphics card.
export function draws_by_software(): boolean {
  const context = document.createElement('canvas').getContext('webgl2');
  if (!context) return true;
  const facts = context.getExtension('WEBGL_debug_renderer_info');
  const name = String(context.getParameter(facts ? facts.UNMASKED_RENDERER_WEBGL : context.RENDERER));
  context.getExtension('WEBGL_lose_context')?.loseContext();
  return /swiftshader|llvmpipe|softpipe|software|basic render/i.test(name);
}
