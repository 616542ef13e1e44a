// SPDX-License-Identifier: Apache-2.0
// Editable points of a plane. Points are dragged with snapping, added by a double click, moved by the arrow keys and
// removed by Delete. This component knows no documents; its parent decides what a moved point means.
import type { KeyboardEvent, PointerEvent, ReactElement, RefObject } from 'react';
import { useEffect, useRef, useState } from 'react';
import { use_held } from '../controls/use_held.ts';
import { LimitLines } from './limit_lines.tsx';
import type { Limits } from './limits.ts';
import type { PictureSize, Snapped } from './plane.ts';
import { grid_lines, levels_of, Scale, snapped } from './plane.ts';
import type { PlaneLine } from './plane_lines.tsx';
import { DrawnLine } from './plane_lines.tsx';
import type { Frame, Point } from './shape.ts';

export interface PlaneCanvasProps {
  label: string;
  point_label: string; // label of each point, before its number
  names: readonly [string, string]; // names of the two directions
  points: readonly Point[];
  lines: readonly PlaneLine[];
  frame: Frame; // does not change during a drag
  limits?: Limits; // drawn if visible; the parent keeps points within
  is_even: boolean; // true: both directions have one scale
  size: PictureSize;
  is_numbered: boolean; // true: the lines of the grid have numbers
  snaps: boolean;
  digits: number; // step of the arrow keys, and of coordinates that do not snap
  chosen: number;
  choose: (index: number) => void;
  drag: (index: number, point: Point) => void; // temporary position
  commit: (index: number, point: Point, digits: number) => void; // final position, as one step
  cancel: () => void;
  add?: (point: Point) => void;
  add_after: (index: number) => void;
  remove: (index: number) => void;
}

const kReach = 9; // distance in pixels within which a point is grabbed
const kBelowName = 24; // pixels at the top for the name of the upward direction
const kGridPixels = { plain: 40, numbered: 56 };

/// Focuses a point of the editor that contains `root`.
export function focus_point(root: Element | null, index: number): void {
  requestAnimationFrame(() => root?.querySelectorAll<SVGElement>('.curve-point')[index]?.focus());
}

interface HeldPoint {
  frame: Frame;
  index: number;
  now: Point | null; // null before the first move
  guides: Snapped['guides'];
}

export function PlaneCanvas(props: PlaneCanvasProps): ReactElement {
  const { points, chosen } = props;
  const picture = useRef<SVGSVGElement>(null);
  const size = use_size(picture, props);
  const held = use_held<HeldPoint>();
  const scale = new Scale(held.shown?.frame ?? props.frame, size, props.is_even);
  const grid_pixels = props.is_numbered ? kGridPixels.numbered : kGridPixels.plain;

  const place_of = (event: { clientX: number; clientY: number }): Point => {
    const place = new DOMPoint(event.clientX, event.clientY).matrixTransform(
      picture.current?.getScreenCTM()?.inverse(),
    );
    return [place.x, place.y];
  };
  const near = (event: { clientX: number; clientY: number }): number => {
    const [left, top] = place_of(event);
    const away = points.map((point) => Math.hypot(scale.place(point)[0] - left, scale.place(point)[1] - top));
    const nearest = away.indexOf(Math.min(...away));
    return (away[nearest] ?? Infinity) <= kReach ? nearest : -1;
  };
  const drawn_to = (event: { clientX: number; clientY: number; altKey: boolean }, index: number): Snapped => {
    const point = scale.value(place_of(event));
    const others = points.filter((_, k) => k !== index);
    const levels = props.snaps && !event.altKey ? levels_of(others, scale, grid_pixels / 2) : { x: [], y: [] };
    return snapped(point, levels, scale, props.digits);
  };
  const down = (event: PointerEvent<SVGSVGElement>): void => {
    const index = event.button === 0 ? near(event) : -1;
    if (index < 0) return;
    event.preventDefault();
    event.currentTarget.setPointerCapture(event.pointerId);
    props.choose(index);
    focus_point(picture.current, index);
    held.set({ frame: props.frame, index, now: null, guides: { x: null, y: null } });
  };
  const move = (event: PointerEvent): void => {
    const hand = held.get();
    if (!hand) return;
    const { point, guides } = drawn_to(event, hand.index);
    held.set({ ...hand, now: point, guides });
    props.drag(hand.index, point);
  };
  const let_go = (commits: boolean): void => {
    const hand = held.get();
    if (!hand) return;
    held.set(null);
    if (commits && hand.now) props.commit(hand.index, hand.now, props.digits);
    else props.cancel();
  };
  const key = (event: KeyboardEvent): void => {
    // Alt alone would open the browser's menu.
    if (event.key === 'Alt') return event.preventDefault();
    const way = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key];
    const go_to = { Home: 0, End: points.length - 1, PageUp: chosen - 1, PageDown: chosen + 1 }[event.key];
    const fine = props.digits * (event.shiftKey ? 0.1 : event.ctrlKey || event.metaKey ? 10 : 1);
    const point = points[chosen];
    if (event.key === 'Escape' && held.get()) let_go(false);
    else if (event.key === 'Delete' || event.key === 'Backspace') props.remove(chosen);
    else if (event.key === '+' || event.key === 'Insert') props.add_after(chosen);
    else if (way && point)
      props.commit(chosen, [point[0] + (way[0] ?? 0) * fine, point[1] + (way[1] ?? 0) * fine], fine);
    else if (go_to !== undefined) focus_point(picture.current, Math.min(points.length - 1, Math.max(0, go_to)));
    else return;
    event.preventDefault();
    event.stopPropagation();
  };
  return (
    <svg
      ref={picture}
      className="plane"
      viewBox={`0 0 ${size.wide} ${size.high}`}
      role="group"
      aria-label={props.label}
      onPointerDown={down}
      onPointerMove={move}
      onPointerUp={() => let_go(true)}
      onPointerCancel={() => let_go(false)}
      onDoubleClick={(event) => {
        if (near(event) < 0) props.add?.(drawn_to(event, -1).point);
      }}
      onKeyDown={key}
      onKeyUp={(event) => {
        if (event.key === 'Alt') event.preventDefault();
      }}
    >
      <Grid scale={scale} size={size} pixels={grid_pixels} is_numbered={props.is_numbered} names={props.names} />
      {props.limits && <LimitLines scale={scale} size={size} limits={props.limits} />}
      {held.shown && <Guides scale={scale} size={size} guides={held.shown.guides} />}
      {props.lines.map((line, k) => (
        <DrawnLine key={k} scale={scale} line={line} />
      ))}
      {points.map((point, k) => {
        const [left, top] = scale.place(point);
        return (
          <circle
            key={k}
            className={`curve-point${k === chosen ? ' chosen' : ''}`}
            cx={left.toFixed(1)}
            cy={top.toFixed(1)}
            r={props.is_numbered ? 5 : 4}
            tabIndex={k === chosen ? 0 : -1}
            role="slider"
            aria-label={`${props.point_label}, point ${k + 1} of ${points.length}`}
            aria-valuenow={point[1]}
            aria-valuetext={`${props.names[0]} ${point[0]}, ${props.names[1]} ${point[1]}`}
            onFocus={() => props.choose(k)}
          />
        );
      })}
    </svg>
  );
}

/// Large pictures fill the available space pixel by pixel; small ones are scaled.
function use_size(picture: RefObject<SVGSVGElement | null>, { size, is_numbered }: PlaneCanvasProps): PictureSize {
  const [room, measure] = useState<{ wide: number; high: number } | null>(null);
  useEffect(() => {
    const element = picture.current;
    if (!is_numbered || !element) return undefined;
    const observer = new ResizeObserver(() => measure({ wide: element.clientWidth, high: element.clientHeight }));
    observer.observe(element);
    return () => observer.disconnect();
  }, [picture, is_numbered]);
  return room && room.wide > 0 && room.high > 0 ? { ...size, ...room } : size;
}

interface GridProps {
  scale: Scale;
  size: PictureSize;
  pixels: number;
  is_numbered: boolean;
  names: readonly [string, string];
}

/// Lines at round numbers. Lines at 0 are drawn stronger.
function Grid({ scale, size, pixels, is_numbered, names }: GridProps): ReactElement {
  const { x, y } = scale.seen;
  const [across, up] = [grid_lines(x, scale.pixel[0], pixels).lines, grid_lines(y, scale.pixel[1], pixels).lines];
  return (
    <g className="curve-grid" aria-hidden="true">
      {across.map((one) => {
        const at = scale.place([one, 0])[0];
        return <line key={`x${one}`} x1={at} x2={at} y1={0} y2={size.high} className={one === 0 ? 'zero' : ''} />;
      })}
      {up.map((one) => {
        const at = scale.place([0, one])[1];
        return <line key={`y${one}`} x1={0} x2={size.wide} y1={at} y2={at} className={one === 0 ? 'zero' : ''} />;
      })}
      {is_numbered && (
        <>
          {across.map((one) => (
            <text key={`x${one}`} x={scale.place([one, 0])[0] + 3} y={size.high - 4}>
              {one}
            </text>
          ))}
          {up
            .map((one) => [one, scale.place([0, one])[1] - 3] as const)
            .filter(([, at]) => at > kBelowName)
            .map(([one, at]) => (
              <text key={`y${one}`} x={3} y={at}>
                {one}
              </text>
            ))}
          <text className="way" x={size.wide - 6} y={size.high - 18} textAnchor="end">
            {names[0]}
          </text>
          <text className="way" x={6} y={12}>
            {names[1]}
          </text>
        </>
      )}
    </g>
  );
}

/// The lines to which the dragged point has snapped.
function Guides({ scale, size, guides }: { scale: Scale; size: PictureSize; guides: Snapped['guides'] }): ReactElement {
  const [left, top] = scale.place([guides.x ?? 0, guides.y ?? 0]);
  return (
    <g className="curve-guides" aria-hidden="true">
      {guides.x !== null && <line x1={left} x2={left} y1={0} y2={size.high} />}
      {guides.y !== null && <line x1={0} x2={size.wide} y1={top} y2={top} />}
    </g>
  );
}
