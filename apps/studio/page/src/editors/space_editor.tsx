// SPDX-License-Identifier: Apache-2.0
// An axis or positions in space, drawn from two sides. Both pictures share the chosen point.
import type { ReactElement } from 'react';
import { useRef, useState } from 'react';

import type { Vec } from '../base/vec.ts';
import { IconButton, Segments } from '../controls/button.tsx';
import type { EditorSize } from '../rows/row_kinds.ts';
import type { Json } from '../values/json.ts';
import { with_limits, within_range } from './limits.ts';
import { next_position } from './next_position.ts';
import { focus_point, PlaneCanvas } from './plane_canvas.tsx';
import type { Range } from './shape.ts';
import { use_snapping } from './snapping.ts';
import type { Side } from './space.ts';
import { frame_from, kSides, limits_from, moved_in, names_of, seen_from, step_of } from './space.ts';

interface SpaceEditorProps {
  label: string;
  places: readonly Vec[];
  is_joined: boolean;
  is_dim: boolean;
  range: Range; // range of each coordinate
  size: EditorSize;
  drag: (places: Json) => void;
  commit: (places: Json) => void;
  cancel: () => void;
}

const kSizes = { row: { wide: 256, high: 150, margin: 8 }, large: { wide: 400, high: 300, margin: 20 } };

export function SpaceEditor(props: SpaceEditorProps): ReactElement {
  const { label, places, size, commit } = props;
  const root = useRef<HTMLDivElement>(null);
  const [chosen, choose] = useState(0);
  // Positions on the ground are first shown from above.
  const [side, show_side] = useState(props.is_joined ? 0 : 2);
  const { snaps, set_snaps } = use_snapping();
  const index = Math.min(chosen, places.length - 1);
  const digits = step_of(places);
  const plain = (made: readonly Vec[]): Json => made.map((one) => [...one]);
  const legal = (place: Vec): Vec => place.map((one) => within_range(one, props.range)) as unknown as Vec;
  const moved = (view: Side, which: number, point: readonly [number, number], step: number): Json =>
    plain(places.map((one, k) => (k === which ? legal(moved_in(view, one, point, step)) : one)));
  const put = (made: readonly Vec[], which: number): void => {
    commit(plain(made));
    choose(which);
    focus_point(root.current, which);
  };
  const remove = (which: number): void => {
    if (places.length > 1)
      put(
        places.filter((_, k) => k !== which),
        Math.max(0, which - 1),
      );
  };
  const add_after = (which: number): void => {
    const [here, next] = [places[which], places[which + 1]];
    const made =
      here && next
        ? (here.map((one, axis) => (one + (next[axis] ?? 0)) / 2) as unknown as Vec)
        : (next_position(plain(places) as Json[]) as unknown as Vec);
    put([...places.slice(0, which + 1), legal(made), ...places.slice(which + 1)], which + 1);
  };
  const canvas = (view: Side): ReactElement => (
    <PlaneCanvas
      key={view.name}
      label={`${label}, ${view.name}: ${places.length} points`}
      point_label={`${label}, ${view.name}`}
      names={names_of(view)}
      points={places.map((one) => seen_from(view, one))}
      lines={props.is_joined ? [{ points: places.map((one) => seen_from(view, one)), kind: 'line' }] : []}
      frame={with_limits(frame_from(view, places), limits_from(view, props.range), 'line')}
      limits={limits_from(view, props.range)}
      is_even
      size={kSizes[size]}
      is_numbered={size === 'large'}
      snaps={snaps}
      digits={digits}
      chosen={index}
      choose={choose}
      drag={(which, point) => props.drag(moved(view, which, point, 1e-9))}
      commit={(which, point, step) => commit(moved(view, which, point, Math.min(step, digits) / 10))}
      cancel={props.cancel}
      add_after={add_after}
      remove={remove}
    />
  );
  const shown = size === 'large' ? [kSides[props.is_joined ? 0 : 2], kSides[1]] : [kSides[side] ?? kSides[0]];
  return (
    <div ref={root} className={`curve-editor space of-${size}${props.is_dim ? ' dim' : ''}`}>
      <div className="space-sides">{shown.map(canvas)}</div>
      <div className="curve-tools">
        <IconButton
          is_small
          icon="left"
          label={`Point before, of ${label}`}
          is_off={index === 0}
          press={() => focus_point(root.current, index - 1)}
        />
        <IconButton
          is_small
          icon="right"
          label={`Point behind, of ${label}`}
          is_off={index + 1 >= places.length}
          press={() => focus_point(root.current, index + 1)}
        />
        <IconButton is_small icon="plus" label={`Add a point to ${label}`} press={() => add_after(index)} />
        <IconButton
          is_small
          icon="close"
          label={`Remove the point of ${label}`}
          is_off={places.length < 2}
          press={() => remove(index)}
        />
        <IconButton
          is_small
          icon="magnet"
          label={`Draw points of ${label} to the grid and to each other; Alt holds it off`}
          is_on={snaps}
          press={() => set_snaps(!snaps)}
        />
        <span className="stretch" />
        {size === 'row' && (
          <Segments
            label={`Side from which ${label} is seen`}
            value={String(side)}
            choices={[
              ['0', 'Front'],
              ['1', 'Side'],
              ['2', 'Top'],
            ]}
            choose={(one) => show_side(Number(one))}
          />
        )}
      </div>
    </div>
  );
}
