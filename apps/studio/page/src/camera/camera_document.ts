// SPDX-License-Identifier: Apache-2.0
// The camera of a document: its view, and edits that copy the page's view into it.
import { component_path, link_path, written_link } from '../board/board_edits.ts';
import type { PlantGraph } from '../board/plant_graph.ts';
import type { Edit, ExportCamera } from '../server/protocol.ts';
import type { Json } from '../values/json.ts';
import { member_of, path_below } from '../values/path.ts';
import type { CameraState } from '../view/orbit.ts';

const kDigits = 3; // digits after the point, for metres

function rounded(numbers: readonly number[]): number[] {
  return numbers.map((one) => Number(one.toFixed(kDigits)));
}

/// Returns the edits that give the document's camera the pose of the view. Adds a camera with links to all roots if the
/// document has none.
export function camera_edits(document: Json | undefined, graph: PlantGraph, camera: ExportCamera): Edit[] {
  const said = {
    position: rounded(camera.position),
    target: rounded(camera.target),
    field_of_view: camera.field_of_view,
  };
  const found = [...graph.components.values()].find((one) => one.is_camera);
  if (!found) return [];
  const path = component_path(found.id);
  if (!found.is_written) {
    const roots = graph.links.filter((link) => link.from === found.id).map((link) => link.to);
    const links = roots.map((to, k): Edit => ({ insert: link_path(k), value: written_link(found.id, to, 'child') }));
    const first: Edit[] = member_of(document, 'links') === undefined ? [{ set: 'links', value: [] }] : [];
    return [{ insert: path, value: { type: 'camera', ...said }, index: 0 }, ...first, ...links];
  }
  const own = member_of(member_of(document, 'components'), found.id);
  const gone = ['azimuth', 'altitude'].filter((name) => member_of(own, name) !== undefined);
  return [
    ...gone.map((name): Edit => ({ unset: path_below(path, name) })),
    ...Object.entries(said).map(([name, value]): Edit => ({ set: path_below(path, name), value })),
  ];
}

export type DocumentCamera = { state: CameraState } | { azimuth: number; altitude: number; field_of_view: number };

/// Returns the view of the document's camera, or only its side if it has no position. Returns null if it has neither,
/// or if expressions are used. `usual` is the default field of view.
export function camera_of_document(
  document: Json | undefined,
  graph: PlantGraph,
  usual: number,
): DocumentCamera | null {
  const found = [...graph.components.values()].find((one) => one.is_camera && one.is_written);
  const said = found ? member_of(member_of(document, 'components'), found.id) : undefined;
  const [position, target] = [point_of(member_of(said, 'position')), point_of(member_of(said, 'target'))];
  const opening = member_of(said, 'field_of_view');
  const field_of_view = typeof opening === 'number' ? opening : usual;
  if (position && target) return { state: { ...state_between(position, target), field_of_view } };
  const [azimuth, altitude] = [member_of(said, 'azimuth'), member_of(said, 'altitude')];
  if (typeof azimuth !== 'number' && typeof altitude !== 'number') return null;
  return {
    azimuth: typeof azimuth === 'number' ? azimuth : 150,
    altitude: typeof altitude === 'number' ? altitude : 6,
    field_of_view,
  };
}

function point_of(value: Json | undefined): [number, number, number] | null {
  const numbers = Array.isArray(value) ? value.filter((one) => typeof one === 'number') : [];
  return numbers.length === 3 ? (numbers as [number, number, number]) : null;
}

/// The azimuth is measured from north over east: north is -z, east +x.
export function state_between(
  position: readonly [number, number, number],
  target: [number, number, number],
): CameraState {
  const [x, y, z] = [position[0] - target[0], position[1] - target[1], position[2] - target[2]];
  const distance = Math.hypot(x, y, z);
  const degrees = 180 / Math.PI;
  return {
    azimuth: (degrees * Math.atan2(x, -z) + 360) % 360,
    altitude: degrees * Math.atan2(y, Math.hypot(x, z)),
    distance,
    target,
  };
}
