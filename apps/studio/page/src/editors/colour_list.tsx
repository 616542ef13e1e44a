// SPDX-License-Identifier: Apache-2.0
// A large editor for a list of colours. A band shows the colours in their order; the user moves, adds and removes them,
// and picks the chosen one. A gesture is one step.
import type { KeyboardEvent, PointerEvent, ReactElement, RefObject } from 'react';
import { useRef, useState } from 'react';

import { moved, with_behind, without } from '../base/lists.ts';
import { IconButton } from '../controls/button.tsx';
import { TextField } from '../controls/text_field.tsx';
import { use_held } from '../controls/use_held.ts';
import { full_colour } from '../values/colour.ts';
import type { Json } from '../values/json.ts';
import { ColourPicker } from './colour_picker.tsx';

interface ColourListProps {
  label: string;
  colours: string[];
  is_faulty: boolean;
  drag: (colours: Json) => void; // temporary value
  commit: (colours: Json) => void; // final value, as one step
  cancel: () => void;
}

const kFirst = '#6b8e23';
const kStill = 4; // pixels within which a press is a click

interface HeldColour {
  from: number;
  to: number;
  x: number; // position where the drag began
  moved: boolean;
}

export function ColourList(props: ColourListProps): ReactElement {
  const { label, colours, drag, commit, cancel } = props;
  const [wanted, choose] = useState(0);
  const band = useRef<HTMLDivElement>(null);
  const index = Math.min(wanted, Math.max(0, colours.length - 1));
  const chosen = colours[index];
  const focus = (which: number): void => {
    choose(which);
    requestAnimationFrame(() => band.current?.querySelectorAll<HTMLElement>('.band-colour')[which]?.focus());
  };
  const put = (made: string[], which: number): void => {
    commit(made);
    focus(which);
  };
  const add = (): void => put(with_behind(colours, index, chosen ?? kFirst), colours.length === 0 ? 0 : index + 1);
  const remove = (): void => {
    if (colours.length > 1) put(without(colours, index), Math.max(0, index - 1));
  };
  const shift = (by: number): void => {
    const to = index + by;
    if (to >= 0 && to < colours.length) put(moved(colours, index, to), to);
  };
  const with_one = (colour: string): Json => colours.map((old, k) => (k === index ? colour : old));
  const key = (event: KeyboardEvent): void => {
    const by = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
    const to = { Home: 0, End: colours.length - 1 }[event.key];
    if (by !== undefined && event.altKey) shift(by);
    else if (by !== undefined) focus(Math.min(colours.length - 1, Math.max(0, index + by)));
    else if (to !== undefined) focus(to);
    else if (event.key === '+') add();
    else if (event.key === 'Delete' || event.key === 'Backspace') remove();
    else return;
    event.preventDefault();
    event.stopPropagation();
  };
  return (
    <div className="colour-list">
      <Band
        label={label}
        colours={colours}
        index={index}
        band={band}
        choose={focus}
        drag={drag}
        put={put}
        cancel={cancel}
        press={key}
      />
      <div className="curve-tools">
        <IconButton
          is_small
          icon="left"
          label={`Move colour ${index + 1} of ${label} before`}
          is_off={index === 0}
          press={() => shift(-1)}
        />
        <IconButton
          is_small
          icon="right"
          label={`Move colour ${index + 1} of ${label} behind`}
          is_off={index + 1 >= colours.length}
          press={() => shift(1)}
        />
        <IconButton is_small icon="plus" label={`Add a colour to ${label}`} press={add} />
        <IconButton
          is_small
          icon="close"
          label={`Remove colour ${index + 1} of ${label}`}
          is_off={colours.length < 2}
          press={remove}
        />
        <div className="band-text">
          <TextField
            key={index}
            label={`${label} ${index + 1}`}
            value={chosen ?? ''}
            commit={(text) => commit(with_one(text))}
            is_code
            is_faulty={props.is_faulty}
          />
        </div>
        <span className="quiet">
          {colours.length === 0 ? 'no colours' : `colour ${index + 1} of ${colours.length}`}
        </span>
      </div>
      {chosen !== undefined && (
        <ColourPicker
          key={index}
          label={`${label} ${index + 1}`}
          value={full_colour(chosen) ?? '#808080'}
          drag={(one) => drag(with_one(one))}
          commit={(one) => commit(with_one(one))}
          cancel={cancel}
        />
      )}
    </div>
  );
}

interface BandProps {
  label: string;
  colours: string[];
  index: number;
  band: RefObject<HTMLDivElement | null>;
  choose: (which: number) => void;
  drag: (colours: Json) => void;
  put: (colours: string[], which: number) => void;
  cancel: () => void;
  press: (event: KeyboardEvent) => void;
}

/// The colours side by side, in the order during a drag.
function Band({ label, colours, index, band, choose, drag, put, cancel, press }: BandProps): ReactElement {
  const held = use_held<HeldColour>();
  const hand = held.shown;
  // During a drag, the row already shows the new order.
  const chosen = hand?.moved ? hand.to : index;
  const start = useRef<string[]>([]);
  const place_of = (event: PointerEvent): number => {
    const box = band.current?.getBoundingClientRect();
    const share = box ? (event.clientX - box.left) / box.width : 0;
    return Math.min(colours.length - 1, Math.max(0, Math.floor(share * colours.length)));
  };
  const down = (event: PointerEvent): void => {
    if (event.button !== 0 || colours.length === 0) return;
    event.preventDefault();
    band.current?.setPointerCapture(event.pointerId);
    const from = place_of(event);
    start.current = colours;
    held.set({ from, to: from, x: event.clientX, moved: false });
    choose(from);
  };
  const move = (event: PointerEvent): void => {
    const now = held.get();
    if (!now || (!now.moved && Math.abs(event.clientX - now.x) < kStill)) return;
    const to = place_of(event);
    if (now.moved && to === now.to) return;
    held.set({ ...now, to, moved: true });
    drag(moved(start.current, now.from, to));
  };
  const let_go = (commits: boolean): void => {
    const now = held.get();
    held.set(null);
    if (!now?.moved) return;
    if (commits && now.to !== now.from) put(moved(start.current, now.from, now.to), now.to);
    else cancel();
  };
  const key = (event: KeyboardEvent): void => {
    if (event.key === 'Escape' && held.get()?.moved) {
      event.stopPropagation();
      let_go(false);
    } else press(event);
  };
  return (
    <div
      ref={band}
      className="colour-band"
      role="listbox"
      aria-label={`Colours of ${label}`}
      aria-orientation="horizontal"
      onPointerDown={down}
      onPointerMove={move}
      onPointerUp={() => let_go(true)}
      onPointerCancel={() => let_go(false)}
      onKeyDown={key}
    >
      {colours.map((colour, k) => (
        <div
          key={k}
          role="option"
          className={`band-colour${k === chosen ? ' chosen' : ''}`}
          aria-selected={k === chosen}
          aria-label={`${label} ${k + 1}: ${colour}`}
          tabIndex={k === chosen ? 0 : -1}
          data-tip={colour}
          style={{ background: full_colour(colour) ?? undefined }}
        />
      ))}
    </div>
  );
}
