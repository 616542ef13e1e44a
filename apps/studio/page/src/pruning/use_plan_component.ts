// SPDX-License-Identifier: Apache-2.0
import { use_store } from '../base/store.ts';
import { use_document, use_page } from '../page/use_page.ts';
import { Pruning } from './pruning.ts';

/// Returns the component whose operations are listed, or null if no component can have operations.
export function use_plan_component(): string | null {
  const page = use_page();
  use_document();
  use_store(page.chosen);
  use_store(page.tool(Pruning).looked_at);
  return page.tool(Pruning).plan_component();
}
