// SPDX-License-Identifier: Apache-2.0
// A curve or an outline, drawn: points are dragged, added by a double click and removed by Delete; the arrow keys move
// the chosen one, and fields hold its numbers. A gesture is one step.
import type { KeyboardEvent, PointerEvent, ReactElement } from 'react';
import { useRef, useState } from 'react';

import { IconButton, Segments } from '../controls/button.tsx';
import { NumberField } from '../controls/number_field.tsx';
import { fitting_step } from '../document/arithmetic.ts';
import type { Point, Range, Shape } from './curve_shape.ts';
import { frame_of, line_of, with_point, with_point_after, with_point_at, without_point } from './curve_shape.ts';

interface CurveEditorProps {
  label: string;
  shape: Shape;
  is_dim: boolean; // a default that nobody gave
  drag: (shape: Shape) => void; // for a while
  commit: (shape: Shape) => void; // as one step
  cancel: () => void;
}

const kWide = 256;
const kHigh = 120;
const kReach = 9; // pixels about a point that take hold of it

interface Frame {
  x: Range;
  y: Range;
}

/// Where things of the frame stand in the picture, and back. Outlines keep their shape.
class Scale {
  private readonly across_: number;
  private readonly up_: number;
  constructor(
    private readonly frame_: Frame,
    is_function: boolean,
  ) {
    const { x, y } = frame_;
    const [across, up] = [(kWide - 16) / (x.high - x.low), (kHigh - 16) / (y.high - y.low)];
    this.across_ = is_function ? across : Math.min(across, up);
    this.up_ = is_function ? up : this.across_;
  }
  place([x, y]: Point): Point {
    const { x: a, y: b } = this.frame_;
    return [kWide / 2 + (x - (a.low + a.high) / 2) * this.across_, kHigh / 2 - (y - (b.low + b.high) / 2) * this.up_];
  }
  value([left, top]: Point): Point {
    const { x: a, y: b } = this.frame_;
    return [(left - kWide / 2) / this.across_ + (a.low + a.high) / 2, (kHigh / 2 - top) / this.up_ + (b.low + b.high) / 2];
  }
}

export function CurveEditor(props: CurveEditorProps): ReactElement {
  const { shape, label } = props;
  const picture = useRef<SVGSVGElement>(null);
  const [chosen, choose] = useState(0);
  const [held, hold] = useState<{ frame: Frame; index: number; shape: Shape } | null>(null);
  // The frame stands still while a hand holds a point.
  const frame = held?.frame ?? frame_of(shape);
  const scale = new Scale(frame, shape.is_function);
  const index = Math.min(chosen, shape.points.length - 1);
  const digits = Math.min(fitting_step(frame.x.low, frame.x.high, 200), fitting_step(frame.y.low, frame.y.high, 200));
  const least = shape.is_function ? 1 : 2;

  const focus = (which: number): void => {
    choose(which);
    requestAnimationFrame(() => picture.current?.querySelectorAll<SVGElement>('.curve-point')[which]?.focus());
  };
  const put = (made: { shape: Shape; index: number } | null): void => {
    if (!made) return;
    props.commit(made.shape);
    focus(made.index);
  };
  const remove = (which: number): void => {
    if (shape.points.length <= least) return;
    props.commit(without_point(shape, which));
    focus(Math.max(0, which - 1));
  };
  const place_of = (event: { clientX: number; clientY: number }): Point => {
    const box = picture.current?.getBoundingClientRect() ?? new DOMRect(0, 0, kWide, kHigh);
    return [((event.clientX - box.left) * kWide) / box.width, ((event.clientY - box.top) * kHigh) / box.height];
  };
  const near = (event: { clientX: number; clientY: number }): number => {
    const [left, top] = place_of(event);
    const away = shape.points.map((point) => Math.hypot(scale.place(point)[0] - left, scale.place(point)[1] - top));
    const nearest = away.indexOf(Math.min(...away));
    return (away[nearest] ?? Infinity) <= kReach ? nearest : -1;
  };
  const down = (event: PointerEvent<SVGSVGElement>): void => {
    const which = event.button === 0 ? near(event) : -1;
    if (which < 0) return;
    event.preventDefault();
    event.currentTarget.setPointerCapture(event.pointerId);
    focus(which);
    hold({ frame, index: which, shape });
  };
  const move = (event: PointerEvent): void => {
    if (!held) return;
    const moved = with_point_at(held.shape, held.index, scale.value(place_of(event)), held.frame, digits);
    hold({ ...held, shape: moved });
    props.drag(moved);
  };
  const let_go = (commits: boolean): void => {
    if (!held) return;
    hold(null);
    if (commits && held.shape !== shape) props.commit(held.shape);
    else props.cancel();
  };
  const key = (event: KeyboardEvent): void => {
    const way = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key];
    const fine = digits * (event.shiftKey ? 0.1 : event.ctrlKey || event.metaKey ? 10 : 1);
    const point = shape.points[index];
    if (event.key === 'Escape' && held) let_go(false);
    else if (event.key === 'Delete' || event.key === 'Backspace') remove(index);
    else if (event.key === '+' || event.key === 'Insert') put(with_point_after(shape, index, digits));
    else if (way && point) props.commit(with_point_at(shape, index, [point[0] + (way[0] ?? 0) * fine, point[1] + (way[1] ?? 0) * fine], frame, fine));
    else return;
    event.preventDefault();
    event.stopPropagation();
  };
  const line = line_of(shape).map((point) => scale.place(point).map((one) => one.toFixed(1)).join(','));
  return (
    <div className={`curve-editor${props.is_dim ? ' dim' : ''}`}>
      <svg
        ref={picture}
        viewBox={`0 0 ${kWide} ${kHigh}`}
        role="group"
        aria-label={`${label}: ${shape.points.length} points`}
        onPointerDown={down}
        onPointerMove={move}
        onPointerUp={() => let_go(true)}
        onPointerCancel={() => let_go(false)}
        onDoubleClick={(event) => {
          if (near(event) < 0) put(with_point(shape, scale.value(place_of(event)), digits));
        }}
        onKeyDown={key}
      >
        <Grid frame={frame} scale={scale} />
        <polyline className="curve-line" points={line.join(' ')} />
        {shape.points.map((point, k) => {
          const [left, top] = scale.place(point);
          return (
            <circle
              key={k}
              className={`curve-point${k === index ? ' chosen' : ''}`}
              cx={left.toFixed(1)}
              cy={top.toFixed(1)}
              r={4}
              tabIndex={k === index ? 0 : -1}
              role="slider"
              aria-label={`${label}, point ${k + 1} of ${shape.points.length}`}
              aria-valuenow={point[1]}
              aria-valuetext={`x ${point[0]}, y ${point[1]}`}
              onFocus={() => choose(k)}
            />
          );
        })}
      </svg>
      <PointFields {...props} index={index} frame={frame} digits={digits} />
      <div className="curve-tools">
        <IconButton is_small icon="left" label={`Point before, of ${label}`} is_off={index === 0} press={() => focus(index - 1)} />
        <IconButton is_small icon="right" label={`Point behind, of ${label}`} is_off={index + 1 >= shape.points.length} press={() => focus(index + 1)} />
        <IconButton is_small icon="plus" label={`Add a point to ${label}`} press={() => put(with_point_after(shape, index, digits))} />
        <IconButton is_small icon="close" label={`Remove the point of ${label}`} is_off={shape.points.length <= least} press={() => remove(index)} />
        <span className="stretch" />
        {shape.is_function && <Segments label={`How the points of ${label} are joined`} value={shape.joining} choices={[['spline', 'Smooth'], ['linear', 'Lines']]} choose={(joining) => props.commit({ ...shape, joining })} />}
      </div>
    </div>
  );
}

/// Where the values are 0 and 1, and the frame's ends.
function Grid({ frame, scale }: { frame: Frame; scale: Scale }): ReactElement {
  const [left, bottom] = scale.place([frame.x.low, frame.y.low]);
  const [right, top] = scale.place([frame.x.high, frame.y.high]);
  const inside = (range: Range) => (one: number): boolean => one >= range.low && one <= range.high;
  return (
    <g className="curve-grid" aria-hidden="true">
      {[0, 0.5, 1].filter(inside(frame.x)).map((x) => {
        const at = scale.place([x, 0])[0];
        return <line key={x} x1={at} x2={at} y1={top} y2={bottom} className={x === 0.5 ? 'minor' : ''} />;
      })}
      {[0, 1].filter(inside(frame.y)).map((y) => {
        const at = scale.place([0, y])[1];
        return <line key={y} x1={left} x2={right} y1={at} y2={at} />;
      })}
    </g>
  );
}

interface PointFieldsProps extends CurveEditorProps {
  index: number;
  frame: Frame;
  digits: number;
}

/// The numbers of the chosen point.
function PointFields({ label, shape, index, frame, digits, drag, commit, cancel }: PointFieldsProps): ReactElement | null {
  const point = shape.points[index];
  if (!point) return null;
  const field = (axis: 0 | 1): ReactElement => {
    const at = (value: number): Shape => with_point_at(shape, index, axis === 0 ? [value, point[1]] : [point[0], value], frame, 1e-6);
    return (
      <label className="curve-field">
        <span className="quiet">{axis === 0 ? 'x' : 'y'}</span>
        <NumberField label={`${label}, ${axis === 0 ? 'x' : 'y'} of point ${index + 1}`} value={point[axis]} step={digits} limit={(one) => one} drag={(one) => drag(at(one))} commit={(one) => commit(at(one))} cancel={cancel} />
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
