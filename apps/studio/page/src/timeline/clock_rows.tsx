// SPDX-License-Identifier: Apache-2.0
// Sequences as blocks: one block for each clock that a component begins, from its start. A drag moves all blocks of a
// component by its delay, if that is a number or a range of numbers.
import type { PointerEvent, ReactElement } from 'react';
import { useEffect, useRef, useState } from 'react';

import { use_store } from '../base/store.ts';
import { component_path } from '../board/board_edits.ts';
import { shown_number } from '../controls/number_field.tsx';
import { use_held } from '../controls/use_held.ts';
import { use_document, use_page } from '../page/use_page.ts';
import type { BegunClocks } from '../server/protocol.ts';
import { tidy_time } from '../time/keys.ts';
import { TimeModel } from '../time/time_model.ts';
import type { Json } from '../values/json.ts';
import { is_object } from '../values/json.ts';
import { path_below, value_at } from '../values/path.ts';
import { percent, time_under } from './lane.ts';

const kStill = 3; // pixels within which a press is a click
const kMaxRows = 6; // blocks in separate rows; further ones overlap

export function ClockRows(): ReactElement {
  const page = use_page();
  const { grown } = use_store(page.growth);
  use_document();
  const { length } = page.tool(TimeModel).animation;
  const [clocks, set_clocks] = useState<BegunClocks[]>([]);
  const hash = grown?.dragged === false ? grown.hash : null;
  const nothing_has_grown = grown === null; // nothing of this document has grown
  useEffect(() => {
    if (nothing_has_grown) {
      set_clocks([]);
      page.tool(TimeModel).clocks.set([]);
    }
    if (hash === null) return undefined;
    let is_wanted = true;
    page.connection
      .request('clocks', { up_to: length })
      .then((answer) => {
        if (!is_wanted) return;
        set_clocks(answer.clocks);
        page.tool(TimeModel).clocks.set(answer.clocks.map((one) => one.component));
      })
      .catch(() => undefined); // a document that has not grown has no clocks
    return () => {
      is_wanted = false;
    };
  }, [page, hash, nothing_has_grown, length]);
  return (
    <>
      {clocks.map((one) => (
        <ClockRow key={one.component} clocks={one} length={length} />
      ))}
    </>
  );
}

/// Returns the delay with all its numbers increased by `by` seconds, or null if it is an expression.
export function moved_delay(delay: Json | undefined, by: number): Json | null {
  const later = (one: Json): Json | null => (typeof one === 'number' ? Number((one + by).toFixed(3)) : null);
  if (delay === undefined) return later(0);
  if (Array.isArray(delay)) {
    const ends = delay.map(later);
    return ends.every((one) => one !== null) ? ends : null;
  }
  if (is_object(delay)) {
    const range = moved_delay(delay['range'], by);
    return range === null ? null : { ...delay, range };
  }
  return later(delay);
}

function ClockRow({ clocks, length }: { clocks: BegunClocks; length: number }): ReactElement {
  const page = use_page();
  const { tree } = use_document();
  const chosen = use_store(page.chosen);
  const lane = useRef<HTMLDivElement>(null);
  const held = use_held<{ from: number; by: number; x: number; moved: boolean }>();
  const { component, blocks, count } = clocks;
  const path = path_below(component_path(component), 'delay');
  const delay = value_at(tree, path);
  const can_move = moved_delay(delay, 0) !== null;
  const down = (event: PointerEvent): void => {
    if (event.button !== 0) return;
    lane.current?.setPointerCapture(event.pointerId);
    held.set({ from: time_under(event, lane.current, length), by: 0, x: event.clientX, moved: false });
  };
  const move = (event: PointerEvent): void => {
    const hand = held.get();
    if (!hand || !can_move || (!hand.moved && Math.abs(event.clientX - hand.x) < kStill)) return;
    const by = tidy_signed(time_under(event, lane.current, length) - hand.from);
    held.set({ ...hand, by, moved: true });
    page.drag({ [path]: moved_delay(delay, by) ?? 0 });
  };
  const let_go = (commits: boolean): void => {
    const hand = held.get();
    held.set(null);
    if (!hand) return;
    if (!hand.moved) page.choose(component_path(component));
    else if (commits && hand.by !== 0)
      page.set_value(path, moved_delay(delay, hand.by) ?? 0, `Move ${component} in time`);
    else page.stop_drag();
  };
  const shift = held.shown?.by ?? 0;
  const rows = Math.min(kMaxRows, blocks.length);
  const begin = shown_number(tidy_time(blocks[0]?.[0] ?? 0));
  return (
    <div className={`lane-row${chosen === component_path(component) ? ' chosen' : ''}`} data-clock={component}>
      <button
        type="button"
        className="lane-name"
        data-tip={`${count === 1 ? 'The clock' : `The ${count} clocks`} of ${component}`}
        onClick={() => page.choose(component_path(component))}
      >
        {component}
      </button>
      <div
        ref={lane}
        className={`lane clocks${can_move ? ' movable' : ''}`}
        role="img"
        aria-label={`${count === 1 ? '1 clock' : `${count} clocks`} of ${component}, from ${begin} s on`}
        onPointerDown={down}
        onPointerMove={move}
        onPointerUp={() => let_go(true)}
        onPointerCancel={() => let_go(false)}
      >
        {blocks.map(([start], k) => (
          <span
            key={k}
            className="clock-block"
            style={{
              left: percent(start + shift, length),
              right: 0,
              top: `${(100 * (k % kMaxRows)) / rows}%`,
              height: `${100 / rows}%`,
            }}
          />
        ))}
      </div>
    </div>
  );
}

function tidy_signed(time: number): number {
  return Number(time.toFixed(2));
}
