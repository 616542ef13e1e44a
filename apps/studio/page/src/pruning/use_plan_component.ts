// SPDX-License-Identifier: Apache-2.0
import { use_store } from '../base/store.ts';
import { steps_of } from '../document/path.ts';
import { use_document, use_studio } from '../studio_context.ts';

/// The component whose operations are listed: the chosen one, that of the operation which is looked at, or the first
/// that could have some; null where none could.
export function use_plan_component(): string | null {
  const studio = use_studio();
  use_document();
  const chosen = steps_of(use_store(studio.chosen));
  const looked_at = steps_of(use_store(studio.bench.pruning.looked_at)?.path ?? '');
  const all = studio.bench.pruning.components();
  const wanted = [chosen[1], looked_at[1]].find((one) => typeof one === 'string' && all.includes(one));
  return typeof wanted === 'string' ? wanted : (all[0] ?? null);
}
