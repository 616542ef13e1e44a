// SPDX-License-Identifier: Apache-2.0
// The keys of a parameter in its lane: chosen by a click, moved by a drag and by the arrow keys, removed by Delete.
import type { KeyboardEvent, PointerEvent, ReactElement } from 'react';
import { useEffect, useRef } from 'react';

import { without } from '../base/lists.ts';
import { use_store } from '../base/store.ts';
import { Board } from '../board/board.ts';
import { component_of } from '../board/board_edits.ts';
import { standing_on } from '../board/plant_graph.ts';
import { Icon } from '../controls/icon.tsx';
import { shown_number } from '../controls/number_field.tsx';
import { use_held } from '../controls/use_held.ts';
import { use_document, use_page } from '../page/use_page.ts';
import type { Track } from '../time/keys.ts';
import { with_time } from '../time/keys.ts';
import { TimeModel } from '../time/time_model.ts';
import type { Key } from '../time/track.ts';
import { curve_of, has_values_between, value_at_time } from '../time/track.ts';
import { commit_keys, drag_keys, with_dragged } from '../time/use_keyed.ts';
import { write_json } from '../values/json.ts';
import { percent, time_under, to_frame } from './lane.ts';

const kStill = 3; // pixels within which a press is a click

interface HeldKey {
  index: number;
  keys: Key[]; // keys before the drag
  now: Key[];
  x: number;
  moved: boolean;
}

export function TrackRow({ track: written }: { track: Track }): ReactElement {
  const page = use_page();
  const model = page.tool(TimeModel);
  const state = use_store(model.state);
  const dragged = use_store(page.dragged);
  use_document();
  const { length, fps } = model.animation;
  const lane = useRef<HTMLDivElement>(null);
  const row = useRef<HTMLDivElement>(null);
  const held = use_held<HeldKey>();
  const track = with_dragged(written, dragged, model.document, model.tops);
  const { name, path } = track;
  const is_chosen = state.track === name;
  const has_own_clock = use_own_clock(path);
  const label = name.replaceAll('_', ' ');
  useEffect(() => {
    // The editor that opens below needs space.
    if (is_chosen) row.current?.scrollIntoView({ block: 'nearest' });
  }, [is_chosen]);
  const choose = (index: number): void => {
    model.choose(name, index);
    model.stop();
  };
  const go_to = (index: number): void => {
    choose(index);
    model.scrub(Math.min(length, track.keys[index]?.time ?? 0));
  };
  const down = (index: number) => (event: PointerEvent) => {
    if (event.button !== 0) return;
    event.stopPropagation();
    lane.current?.setPointerCapture(event.pointerId);
    model.stop();
    // The editor below opens at the end of the drag, so that nothing moves under the pointer.
    held.set({ index, keys: track.keys, now: track.keys, x: event.clientX, moved: false });
  };
  const move = (event: PointerEvent): void => {
    const hand = held.get();
    if (!hand || (!hand.moved && Math.abs(event.clientX - hand.x) < kStill)) return;
    const now = with_time(
      hand.keys,
      hand.index,
      to_frame(time_under(event, lane.current, length), fps, event.altKey),
      length,
    );
    held.set({ ...hand, now, moved: true });
    drag_keys(page, name, now);
  };
  const let_go = (commits: boolean): void => {
    const hand = held.get();
    held.set(null);
    if (!hand) return;
    if (!hand.moved) go_to(hand.index);
    else if (commits) commit_keys(page, name, hand.now, `Move a key of ${label}`);
    else page.stop_drag();
  };
  const key = (index: number) => (event: KeyboardEvent) => {
    const frames = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
    const at = track.keys[index];
    if (event.key === 'Escape' && held.get()?.moved) let_go(false);
    else if (frames !== undefined && at)
      commit_keys(
        page,
        name,
        with_time(track.keys, index, at.time + (frames * (event.shiftKey ? 10 : 1)) / fps, length),
        `Move a key of ${label}`,
      );
    else if (event.key === 'Delete' || event.key === 'Backspace')
      commit_keys(page, name, without(track.keys, index), `Remove a key of ${label}`);
    else if (event.key === 'Enter' || event.key === ' ') go_to(index);
    else return;
    event.preventDefault();
    event.stopPropagation();
  };
  const open = (): void => {
    model.choose(is_chosen ? null : name);
    page.choose(path.replace(/^((?:components|variables)\.(?:[^.[]+|\["[^"]*"\])|links\[\d+\]|scene).*$/, '$1'));
  };
  return (
    <div ref={row} className={`lane-row${is_chosen ? ' chosen' : ''}`} data-track={name}>
      <button
        type="button"
        className="lane-name"
        aria-pressed={is_chosen}
        data-tip={has_own_clock ? `${path}\nby the seconds of the clock that each instance lives by` : path}
        onClick={open}
      >
        {label}
        {has_own_clock && <Icon name="clock" />}
      </button>
      <div
        ref={lane}
        className="lane"
        role="group"
        aria-label={`Keys of ${label}`}
        onPointerMove={move}
        onPointerUp={() => let_go(true)}
        onPointerCancel={() => let_go(false)}
      >
        <TrackPicture keys={track.keys} length={length} />
        {track.keys.map((one, index) => (
          <button
            key={index}
            type="button"
            className={`key${is_chosen && state.key === index ? ' chosen' : ''}${one.time > length ? ' beyond' : ''}`}
            style={{ left: percent(one.time, length) }}
            aria-label={`Key ${index + 1} of ${label}, at ${shown_number(one.time)} s`}
            data-tip={`${shown_number(one.time)} s: ${write_json(one.value)}${one.way === null ? '' : `, ${one.way}`}`}
            onPointerDown={down(index)}
            onKeyDown={key(index)}
          />
        ))}
      </div>
    </div>
  );
}

/// Returns true if the value at a path follows clocks of its own, which a component above it begins.
function use_own_clock(path: string): boolean {
  const page = use_page();
  const clocks = use_store(page.tool(TimeModel).clocks);
  const component = component_of(path);
  return (
    component !== null &&
    clocks.some((clock) => clock !== component && standing_on(page.tool(Board).actions.graph, clock).has(component))
  );
}

/// The values of the keys over time, drawn behind them: a curve, or a band of colours.
function TrackPicture({ keys, length }: { keys: readonly Key[]; length: number }): ReactElement | null {
  const curve = curve_of(keys, length, 80);
  if (curve) {
    const values = curve.map((one) => one[1]);
    const [low, high] = [Math.min(...values), Math.max(...values)];
    const height = (value: number): number => (high > low ? 18 - (15 * (value - low)) / (high - low) : 10);
    return (
      <svg className="lane-curve" viewBox="0 0 100 20" preserveAspectRatio="none" aria-hidden="true">
        <polyline
          points={curve
            .map(([time, value]) => `${((100 * time) / length).toFixed(2)},${height(value).toFixed(2)}`)
            .join(' ')}
        />
      </svg>
    );
  }
  if (!keys.every((one) => typeof one.value === 'string') || !has_values_between(keys)) return null;
  const stops = Array.from(
    { length: 13 },
    (_, k) => `${String(value_at_time(keys, (length * k) / 12))} ${((100 * k) / 12).toFixed(1)}%`,
  );
  return (
    <span
      className="lane-colours"
      aria-hidden="true"
      style={{ background: `linear-gradient(to right, ${stops.join(', ')})` }}
    />
  );
}
