// SPDX-License-Identifier: Apache-2.0
// The graph of the open document and its layout, computed once per text.
import { useMemo } from 'react';

import { use_store } from '../base/store.ts';
import { use_document, use_page } from '../page/use_page.ts';
import { Board } from './board.ts';
import type { BoardLayout } from './board_layout.ts';
import { lay_out } from './board_layout.ts';
import type { PlantGraph } from './plant_graph.ts';
import { graph_of } from './plant_graph.ts';

export function use_graph(): PlantGraph {
  const { components } = use_page().tables;
  const { tree, implied } = use_document();
  return useMemo(() => graph_of(tree?.value, components, implied), [tree, implied, components]);
}

export function use_layout(graph: PlantGraph): BoardLayout {
  const { folded } = use_store(use_page().tool(Board).state);
  return useMemo(() => lay_out(graph, folded), [graph, folded]);
}
