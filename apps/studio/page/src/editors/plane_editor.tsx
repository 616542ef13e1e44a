// SPDX-License-Identifier: Apache-2.0
// A curve, a line, a polygon or a silhouette, with the numbers of its chosen point. A gesture is one step.
import type { ReactElement } from 'react';
import { useRef, useState } from 'react';

import { IconButton, Segments } from '../controls/button.tsx';
import { NumberField } from '../controls/number_field.tsx';
import type { EditorSize } from '../rows/row_kinds.ts';
import { fitting_step } from '../values/arithmetic.ts';
import type { Limits } from './limits.ts';
import { drawn_limits, limits_of, with_legal_point, with_limits, within_range } from './limits.ts';
import { focus_point, PlaneCanvas } from './plane_canvas.tsx';
import type { PlaneLine } from './plane_lines.tsx';
import type { Frame, Point, Shape } from './shape.ts';
import {
  frame_of,
  is_two_sided,
  line_of,
  min_points,
  mirrored,
  with_point,
  with_point_after,
  with_point_at,
  with_room_for,
  without_point,
} from './shape.ts';
import { kPlaneSizes } from './sizes.ts';
import { use_snapping } from './snapping.ts';

interface PlaneEditorProps {
  label: string;
  shape: Shape;
  is_dim: boolean; // true: a default that the document does not contain
  limits?: Limits; // limits of its row; missing: only the limits of its form
  behind?: readonly PlaneLine[]; // drawn behind the shape, for example the points to which it was fitted
  size: EditorSize;
  drag: (shape: Shape) => void; // temporary shape
  commit: (shape: Shape) => void; // final shape, as one step
  cancel: () => void;
}

export function PlaneEditor(props: PlaneEditorProps): ReactElement {
  const { shape, label, size, commit } = props;
  const root = useRef<HTMLDivElement>(null);
  const [chosen, choose] = useState(0);
  const { snaps, set_snaps } = use_snapping();
  const behind = props.behind ?? [];
  const limits = props.limits ?? limits_of({}, shape.form);
  const frame = with_limits(
    with_room_for(
      frame_of(shape),
      behind.flatMap((line) => line.points),
    ),
    drawn_limits(limits, shape),
    shape.form,
  );
  const index = Math.min(chosen, shape.points.length - 1);
  const digits = Math.min(fitting_step(frame.x.low, frame.x.high, 200), fitting_step(frame.y.low, frame.y.high, 200));
  const min = min_points(shape);
  const focus = (which: number): void => {
    choose(which);
    focus_point(root.current, which);
  };
  const put = (made: { shape: Shape; index: number } | null): void => {
    if (!made) return;
    commit(with_legal_point(made.shape, made.index, limits));
    focus(made.index);
  };
  const remove = (which: number): void => {
    if (shape.points.length <= min) return;
    commit(without_point(shape, which));
    focus(Math.max(0, which - 1));
  };
  const moved = (which: number, point: Point, step: number): Shape =>
    with_legal_point(with_point_at(shape, which, point, frame, step), which, limits);
  const kind = { function: 'Curve', line: 'Line', polygon: 'Polygon', silhouette: 'Silhouette', profile: 'Profile' }[
    shape.form
  ];
  return (
    <div ref={root} className={`curve-editor of-${size}${props.is_dim ? ' dim' : ''}`}>
      <PlaneCanvas
        label={`${label}: ${shape.points.length} points`}
        point_label={label}
        names={names_of(shape)}
        points={shape.points}
        lines={[...behind, ...lines_of(shape)]}
        frame={frame}
        limits={drawn_limits(limits, shape)}
        is_even={shape.form !== 'function'}
        size={kPlaneSizes[size]}
        is_numbered={size === 'large'}
        snaps={snaps}
        digits={digits}
        chosen={index}
        choose={choose}
        drag={(which, point) => props.drag(moved(which, point, 1e-9))}
        commit={(which, point, step) => commit(moved(which, point, Math.min(step, digits) / 10))}
        cancel={props.cancel}
        add={(point) => put(with_point(shape, point, digits / 10))}
        add_after={(which) => put(with_point_after(shape, which, digits))}
        remove={remove}
      />
      <PointFields {...props} index={index} frame={frame} digits={digits} limits={limits} />
      <div className="curve-tools">
        <IconButton
          is_small
          icon="left"
          label={`Point before, of ${label}`}
          is_off={index === 0}
          press={() => focus(index - 1)}
        />
        <IconButton
          is_small
          icon="right"
          label={`Point behind, of ${label}`}
          is_off={index + 1 >= shape.points.length}
          press={() => focus(index + 1)}
        />
        <IconButton
          is_small
          icon="plus"
          label={`Add a point to ${label}`}
          press={() => put(with_point_after(shape, index, digits))}
        />
        <IconButton
          is_small
          icon="close"
          label={`Remove the point of ${label}`}
          is_off={shape.points.length <= min}
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
        {shape.form === 'function' ? (
          <Segments
            label={`How the points of ${label} are joined`}
            value={shape.joining}
            choices={[
              ['spline', 'Smooth'],
              ['linear', 'Lines'],
            ]}
            choose={(joining) => commit({ ...shape, joining })}
          />
        ) : (
          <span className="quiet">
            {kind}, {shape.points.length} points
          </span>
        )}
      </div>
    </div>
  );
}

function names_of({ form }: Shape): readonly [string, string] {
  if (form === 'profile') return ['radius', 'height'];
  return form === 'silhouette' ? ['distance', 'along'] : ['x', 'y'];
}

function lines_of(shape: Shape): PlaneLine[] {
  const line = line_of(shape);
  if (!is_two_sided(shape)) return [{ points: line, kind: shape.form === 'polygon' ? 'filled' : 'line' }];
  return [
    { points: [...line, ...mirrored(line).reverse()], kind: 'filled' },
    { points: mirrored(line), kind: 'mirror' },
    { points: line, kind: 'line' },
  ];
}

interface PointFieldsProps extends PlaneEditorProps {
  index: number;
  frame: Frame;
  digits: number;
  limits: Limits;
}

/// Fields for the numbers of the chosen point.
function PointFields({
  label,
  shape,
  index,
  frame,
  digits,
  limits,
  drag,
  commit,
  cancel,
}: PointFieldsProps): ReactElement | null {
  const point = shape.points[index];
  if (!point) return null;
  const names = shape.form === 'profile' ? names_of(shape) : ['x', 'y'];
  const field = (axis: 0 | 1): ReactElement => {
    const at = (value: number): Shape =>
      with_point_at(shape, index, axis === 0 ? [value, point[1]] : [point[0], value], frame, 1e-6);
    const legal = (value: number): number => within_range(value, axis === 0 ? limits.x : limits.y);
    return (
      <label className="curve-field">
        <span className="quiet">{names[axis]}</span>
        <NumberField
          label={`${label}, ${names[axis]} of point ${index + 1}`}
          value={point[axis]}
          step={digits}
          limit={legal}
          drag={(one) => drag(at(one))}
          commit={(one) => commit(at(one))}
          cancel={cancel}
        />
      </label>
    );
  };
  return (
    <div className="curve-fields">
      {field(0)}
      {field(1)}
    </div>
  );
}
