// SPDX-License-Identifier: Apache-2.0
// Picks a colour: a square of saturation and value, a slider of hues, and the colours of the document. A gesture is one
// step.
import type { KeyboardEvent, PointerEvent, ReactElement } from 'react';
import { useRef, useState } from 'react';

import { Slider } from '../controls/slider.tsx';
import { use_document } from '../page/use_page.ts';
import type { Hsv } from '../values/colour.ts';
import { colour_of, colours_in, hsv_of } from '../values/colour.ts';

interface ColourPickerProps {
  label: string;
  value: string;
  drag: (colour: string) => void;
  commit: (colour: string) => void;
  cancel: () => void;
}

const kStep = 0.02;
const clamped = (one: number): number => Math.min(1, Math.max(0, one));

export function ColourPicker({ label, value, drag, commit, cancel }: ColourPickerProps): ReactElement {
  const { tree } = use_document();
  // A grey has no hue, and black no saturation: the user's last choice of these stays.
  const [picked, set_picked] = useState<Hsv>(() => hsv_of(value));
  const hsv = colour_of(picked) === value.toLowerCase() ? picked : hsv_of(value);
  const pick = (part: Partial<Hsv>): string => {
    const made = { ...hsv, ...part };
    set_picked(made);
    return colour_of(made);
  };
  return (
    <div className="colour-picker">
      <Square
        label={label}
        hsv={hsv}
        drag={(part) => drag(pick(part))}
        commit={(part) => commit(pick(part))}
        cancel={cancel}
      />
      <div className="hues">
        <Slider
          label={`${label}, hue`}
          value={Math.round(hsv.hue)}
          low={0}
          high={359}
          step={1}
          drag={(hue) => drag(pick({ hue }))}
          commit={(hue) => commit(pick({ hue }))}
          cancel={cancel}
        />
      </div>
      <div className="swatches" role="group" aria-label={`Colours of the document, for ${label}`}>
        {colours_in(tree?.value).map((colour) => (
          <button
            key={colour}
            type="button"
            className="swatch"
            aria-label={`Take ${colour} for ${label}`}
            aria-pressed={colour === value.toLowerCase()}
            data-tip={colour}
            style={{ background: colour }}
            onClick={() => commit(colour)}
          />
        ))}
      </div>
    </div>
  );
}

interface SquareProps {
  label: string;
  hsv: Hsv;
  drag: (part: Partial<Hsv>) => void;
  commit: (part: Partial<Hsv>) => void;
  cancel: () => void;
}

function Square({ label, hsv, drag, commit, cancel }: SquareProps): ReactElement {
  const held = useRef<Partial<Hsv> | null>(null);
  const at = (event: PointerEvent<HTMLDivElement>): Partial<Hsv> => {
    const box = event.currentTarget.getBoundingClientRect();
    return {
      saturation: clamped((event.clientX - box.left) / box.width),
      value: clamped(1 - (event.clientY - box.top) / box.height),
    };
  };
  const down = (event: PointerEvent<HTMLDivElement>): void => {
    if (event.button !== 0) return;
    event.currentTarget.setPointerCapture(event.pointerId);
    held.current = at(event);
    drag(held.current);
  };
  const move = (event: PointerEvent<HTMLDivElement>): void => {
    if (!held.current) return;
    held.current = at(event);
    drag(held.current);
  };
  const let_go = (commits: boolean): void => {
    const part = held.current;
    held.current = null;
    if (!part) return;
    if (commits) commit(part);
    else cancel();
  };
  const key = (event: KeyboardEvent): void => {
    const way = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key];
    const step = kStep * (event.shiftKey ? 0.25 : event.ctrlKey || event.metaKey ? 5 : 1);
    if (event.key === 'Escape' && held.current) let_go(false);
    else if (way)
      commit({
        saturation: clamped(hsv.saturation + (way[0] ?? 0) * step),
        value: clamped(hsv.value + (way[1] ?? 0) * step),
      });
    else return;
    event.preventDefault();
    event.stopPropagation();
  };
  const percent = (one: number): string => `${Math.round(100 * one)} %`;
  return (
    <div
      className="colour-square"
      tabIndex={0}
      role="slider"
      aria-label={`${label}, saturation and lightness`}
      aria-valuenow={Math.round(100 * hsv.value)}
      aria-valuetext={`saturation ${percent(hsv.saturation)}, lightness ${percent(hsv.value)}`}
      style={{ backgroundColor: `hsl(${hsv.hue} 100% 50%)` }}
      onPointerDown={down}
      onPointerMove={move}
      onPointerUp={() => let_go(true)}
      onPointerCancel={() => let_go(false)}
      onKeyDown={key}
    >
      <span
        style={{ left: `${100 * hsv.saturation}%`, top: `${100 * (1 - hsv.value)}%`, background: colour_of(hsv) }}
      />
    </div>
  );
}
