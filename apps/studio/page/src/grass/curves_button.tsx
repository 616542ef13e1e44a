// SPDX-License-Identifier: Apache-2.0
import type { ReactElement } from 'react';

import { use_store } from '../base/store.ts';
import { Button } from '../controls/button.tsx';
import { use_document, use_page } from '../page/use_page.ts';
import { groups_at } from '../tables/resolve.ts';
import { steps_of } from '../values/path.ts';
import { LeafCurvesModel } from './leaf_curves.ts';

const kDrawnBy = ['midrib_points', 'profile']; // rows of components that are drawn by midrib and width

/// Opens the editor of midrib and width for a component that is drawn by them.
export function CurvesButton({ path }: { path: string }): ReactElement | null {
  const page = use_page();
  const { tree } = use_document();
  const open = use_store(page.tool(LeafCurvesModel).component);
  const [head, component] = steps_of(path);
  if (head !== 'components' || typeof component !== 'string') return null;
  const names = groups_at(page.tables, tree, path).flatMap(({ rows }) => rows.map((row) => row.name));
  if (!kDrawnBy.every((name) => names.includes(name))) return null;
  const is_open = open === component;
  return (
    <Button
      is_open={is_open}
      tip="With the measured points, and beside the leaf in the view"
      press={() => page.tool(LeafCurvesModel).component.set(is_open ? null : component)}
    >
      Midrib and width…
    </Button>
  );
}
