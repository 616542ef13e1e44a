// SPDX-License-Identifier: Apache-2.0
// The seconds above the timeline, for scrubbing with the pointer and with keys.
import type { KeyboardEvent, PointerEvent, ReactElement } from 'react';
import { useRef } from 'react';

import { use_store } from '../base/store.ts';
import { shown_number } from '../controls/number_field.tsx';
import { use_document, use_page } from '../page/use_page.ts';
import { TimeModel } from '../time/time_model.ts';
import { fitting_step, rounded } from '../values/arithmetic.ts';
import { percent, time_under, to_frame } from './lane.ts';

const kMarks = 10; // approximate count of numbers over the whole length

export function Ruler(): ReactElement {
  const page = use_page();
  const model = page.tool(TimeModel);
  const { time } = use_store(model.state);
  use_document();
  const { length, fps } = model.animation;
  const lane = useRef<HTMLDivElement>(null);
  const is_held = useRef(false);
  const step = fitting_step(0, length, kMarks);
  const marks = Array.from({ length: Math.floor(length / step + 1e-6) + 1 }, (_, k) => rounded(k * step, step));
  const go = (event: PointerEvent): void =>
    model.scrub(to_frame(time_under(event, lane.current, length), fps, event.altKey));
  const down = (event: PointerEvent): void => {
    if (event.button !== 0) return;
    model.stop();
    is_held.current = true;
    lane.current?.setPointerCapture(event.pointerId);
    go(event);
  };
  const key = (event: KeyboardEvent): void => {
    const frames = { ArrowLeft: -1, ArrowRight: 1, PageUp: 10, PageDown: -10 }[event.key];
    const to =
      { Home: 0, End: length }[event.key] ??
      (frames === undefined ? undefined : time + (frames * (event.shiftKey ? 10 : 1)) / fps);
    if (to === undefined) return;
    event.preventDefault();
    model.stop();
    model.scrub(Math.max(0, to));
  };
  return (
    <div className="lane-row ruler-row">
      <span className="lane-name quiet">seconds</span>
      <div
        ref={lane}
        className="lane ruler"
        role="slider"
        tabIndex={0}
        aria-label="Time that is shown"
        aria-valuemin={0}
        aria-valuemax={length}
        aria-valuenow={time}
        aria-valuetext={`${shown_number(time)} seconds`}
        onPointerDown={down}
        onPointerMove={(event) => is_held.current && go(event)}
        onPointerUp={() => (is_held.current = false)}
        onPointerCancel={() => (is_held.current = false)}
        onKeyDown={key}
      >
        {marks.map((mark) => (
          <span key={mark} style={{ left: percent(mark, length) }}>
            {mark}
          </span>
        ))}
      </div>
    </div>
  );
}
