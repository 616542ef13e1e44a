// SPDX-License-Identifier: Apache-2.0
// Buttons that add boxes, meshes, lamps and poles to a scene. They are placed beside the plants, in a suitable size,
// and their grips are shown.
import type { ReactElement } from 'react';

import { free_name } from '../board/board_edits.ts';
import { Button } from '../controls/button.tsx';
import { Gizmo } from '../gizmo/gizmo.ts';
import type { Page } from '../page/page.ts';
import { use_page } from '../page/use_page.ts';
import type { Edit } from '../server/protocol.ts';
import { rounded } from '../values/arithmetic.ts';
import type { Json } from '../values/json.ts';
import { is_object } from '../values/json.ts';
import { path_below, value_at } from '../values/path.ts';
import { MeshButton } from './mesh_button.tsx';

/// The box around the plants, metres: lower corner, upper corner, and a suitable step.
interface Room {
  low: [number, number, number];
  high: [number, number, number];
  step: number;
}

export function room_of(page: Page): Room {
  const box = page.view?.bounds;
  const known = box && !box.isEmpty();
  const [low, high] = known
    ? [box.min.toArray(), box.max.toArray()]
    : [[-1, 0, -1] as [number, number, number], [1, 2, 1] as [number, number, number]];
  const size = Math.max(high[0] - low[0], high[1] - low[1], high[2] - low[2], 1e-3);
  return { low, high, step: 10 ** Math.floor(Math.log10(size / 20)) };
}

export function SceneTools(): ReactElement {
  const page = use_page();
  const round = (one: number): number => rounded(one, room_of(page).step);
  const box = (): void => {
    const { low, high } = room_of(page);
    const [wide, tall] = [Math.max(high[0] - low[0], 0.3 * (high[1] - low[1])), high[1] - low[1]];
    // Each new one is placed beside the others, so that all are visible.
    const from = high[0] + (0.2 + 0.6 * count_in(page, 'obstacles')) * wide;
    const middle = (low[2] + high[2]) / 2;
    put(
      page,
      'obstacles',
      {
        box: [
          [round(from), 0, round(middle - wide / 2)],
          [round(from + 0.4 * wide), round(0.8 * tall), round(middle + wide / 2)],
        ],
      },
      'Add a box',
    );
  };
  const lamp = (): void => {
    const { low, high } = room_of(page);
    const away = (0.2 + 0.3 * count_in(page, 'lamps')) * (high[0] - low[0]);
    put(
      page,
      'lamps',
      { position: [round(high[0] + away), round(high[1]), round((low[2] + high[2]) / 2)], strength: 1 },
      'Add a lamp',
    );
  };
  const line = (name: string, points: [number, number, number][], label: string): void =>
    put_support(
      page,
      name,
      points.map((one) => one.map(round)),
      label,
    );
  const pole = (): void =>
    line(
      'pole',
      [
        [0, 0, 0],
        [0, room_of(page).high[1], 0],
      ],
      'Add a pole',
    );
  const wire = (): void => {
    const { low, high } = room_of(page);
    line(
      'wire',
      [
        [low[0], high[1] / 2, 0],
        [high[0], high[1] / 2, 0],
      ],
      'Add a wire',
    );
  };
  return (
    <div className="scene-tools" role="toolbar" aria-label="Add to the scene">
      <Button icon="plus" tip="An obstacle beside the plants" press={box}>
        Box
      </Button>
      <MeshButton take={(mesh) => put(page, 'obstacles', { mesh }, 'Add a mesh')} />
      <Button icon="plus" tip="A light at a place" press={lamp}>
        Lamp
      </Button>
      <Button icon="plus" tip="An upright line that operations tie shoots to" press={pole}>
        Pole
      </Button>
      <Button icon="plus" tip="A level line that operations tie shoots to" press={wire}>
        Wire
      </Button>
    </div>
  );
}

/// Returns the number of elements in a list of the scene.
function count_in(page: Page, list: string): number {
  const said = value_at(page.document.state.get().tree, path_below('scene', list));
  return Array.isArray(said) ? said.length : 0;
}

/// Adds an element at the end of a list of the scene.
function put(page: Page, list: string, value: Json, label: string): void {
  const path = path_below('scene', list);
  const said = value_at(page.document.state.get().tree, path);
  const count = count_in(page, list);
  const edit: Edit = Array.isArray(said) ? { insert: path_below(path, -1), value } : { set: path, value: [value] };
  void page.edit([edit], label).then((faults) => {
    if (faults === null) page.tool(Gizmo).show(path_below(path, count));
  });
}

/// Adds a support under a free name.
function put_support(page: Page, name: string, points: number[][], label: string): void {
  const said = value_at(page.document.state.get().tree, 'scene.supports');
  const free = free_name(name, new Set(is_object(said) ? Object.keys(said) : []));
  const path = path_below('scene.supports', free);
  const edit: Edit = is_object(said)
    ? { set: path, value: points }
    : { set: 'scene.supports', value: { [free]: points } };
  void page.edit([edit], label).then((faults) => {
    if (faults === null) page.tool(Gizmo).show(`${path}[${points.length - 1}]`);
  });
}
