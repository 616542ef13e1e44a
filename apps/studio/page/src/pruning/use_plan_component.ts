// SPDX-License-Identifier: Apache-2.0
import { use_store } from '../base/store.ts';
import { use_document, use_studio } from '../page/use_page.ts';

/// Returns the component whose operations are listed, or null if no component can have operations.
export function use_plan_component(): string | null {
  const studio = use_studio();
  use_document();
  use_store(studio.chosen);
  use_store(studio.bench.pruning.looked_at);
  return studio.bench.pruning.plan_component();
}
