// SPDX-License-Identifier: Apache-2.0
// Actions with the view's camera: copy it into the document, bookmark it, or draw a still.
import type { ReactElement } from 'react';
import { useState } from 'react';
import { Board } from '../board/board.ts';
import type { MenuItem } from '../controls/menu.tsx';
import { Menu } from '../controls/menu.tsx';
import type { Page } from '../page/page.ts';
import { use_document, use_page } from '../page/use_page.ts';
import { component_groups } from '../tables/tables.ts';
import { kFieldOfView } from '../view/orbit.ts';
import { bookmarks_of, keep_bookmarks, next_name } from './bookmarks.ts';
import { camera_edits, camera_of_document } from './camera_document.ts';

export function CameraMenu(): ReactElement {
  const page = use_page();
  const document = use_document();
  const [, redraw] = useState(0);
  const { graph } = page.tool(Board).actions;
  const bookmarks = bookmarks_of(document);
  const written = camera_of_document(document.tree?.value, graph, usual_field_of_view(page));
  const keep = (all: typeof bookmarks): void => {
    keep_bookmarks(document, all);
    redraw((count) => count + 1);
  };
  const add = (): void => {
    const { view } = page;
    if (!view) return;
    const name = next_name(bookmarks);
    keep([...bookmarks, { name, camera: view.orbit.state }]);
    page.notify(`${name} is kept in this browser`);
  };
  const items: MenuItem[] = [
    { text: 'Set the document’s camera', act: () => set_camera(page) },
    ...(written ? [{ text: 'Look as the document’s camera', act: () => look_as_document(page) }] : []),
    { text: 'Still…', act: () => page.shell.merge({ dialog: 'still' }) },
    { text: 'Keep this view', act: add },
    ...bookmarks.map((one) => ({ text: one.name, act: () => page.view?.look(one.camera) })),
    ...bookmarks.slice(-1).map((one) => ({ text: `Forget ${one.name}`, act: () => keep(bookmarks.slice(0, -1)) })),
  ];
  return <Menu icon="camera" label="Camera" items={items} />;
}

/// Writes the view's camera into the document, as one step.
function set_camera(page: Page): void {
  const { view } = page;
  const { graph, document } = page.tool(Board).actions;
  if (!view) return;
  const edits = camera_edits(document, graph, view.orbit.as_document);
  if (edits.length === 0) return page.notify('A document without components has no camera', true);
  void page
    .edit(edits, 'Set the camera')
    .then((faults) => faults === null && page.notify('The document’s camera looks as the view does'));
}

function look_as_document(page: Page): void {
  const { graph, document } = page.tool(Board).actions;
  const written = camera_of_document(document, graph, usual_field_of_view(page));
  if (!written || !page.view) return;
  if ('state' in written) return page.view.look(written.state);
  page.view.look_from(written.azimuth, written.altitude);
  page.view.open_to(written.field_of_view);
  page.view.fit();
}

/// Returns the default field of view of the document's camera, from the tables.
function usual_field_of_view({ tables }: Page): number {
  const type = Object.keys(tables.components).find((one) => tables.components[one]?.is_camera) ?? '';
  const rows = component_groups(tables, type).flatMap((one) => one.rows);
  return Number(rows.find((row) => row.name === 'field_of_view')?.default ?? kFieldOfView);
}
