// SPDX-License-Identifier: Apache-2.0
// A field for a number. It accepts arithmetic, drags sideways (Shift fine, Ctrl coarse) and the arrow keys.
import type { KeyboardEvent, PointerEvent, ReactElement } from 'react';
import { useRef, useState } from 'react';

import { calculate, rounded, tidy } from '../values/arithmetic.ts';

export interface NumberActions {
  drag: (value: number) => void; // temporary value
  commit: (value: number) => void; // final value, as one step
  cancel: () => void; // restores the previous value
}

interface NumberFieldProps extends NumberActions {
  label: string;
  value: number | null;
  step: number;
  unit?: string | undefined;
  description?: string;
  is_faulty?: boolean;
  is_dim?: boolean; // true: a default that the document does not contain
  limit: (value: number) => number; // returns the nearest allowed number
  /// Receives texts that are no arithmetic. Without it, such texts are discarded.
  express?: ((text: string) => void) | undefined;
}

const kPixelsToBegin = 3;
const kPixelsPerStep = 2;

/// Returns a number with a readable number of digits.
export function shown_number(value: number | null): string {
  return value === null
    ? ''
    : String(
        Math.abs(value) >= 1e-4 || value === 0 ? tidy(Number(value.toPrecision(6))) : Number(value.toPrecision(4)),
      );
}

function pace(event: { shiftKey: boolean; ctrlKey: boolean; metaKey: boolean }): number {
  return event.shiftKey ? 0.1 : event.ctrlKey || event.metaKey ? 10 : 1;
}

export function NumberField(props: NumberFieldProps): ReactElement {
  const { label, value, step, unit, limit } = props;
  const [typed, set_typed] = useState<string | null>(null);
  const hand = useRef<{ x: number; value: number; now: number; moves: boolean } | null>(null);
  const input = useRef<HTMLInputElement>(null);

  const finish = (text: string | null): void => {
    set_typed(null);
    if (text === null || text === shown_number(value)) return;
    const number = calculate(text);
    if (number !== null) props.commit(limit(number));
    else if (text.trim() !== '') props.express?.(text.trim());
  };
  const let_go = (commits: boolean): void => {
    const held = hand.current;
    hand.current = null;
    if (!held) return;
    if (!held.moves) {
      if (commits) input.current?.focus();
      if (commits) input.current?.select();
      return;
    }
    input.current?.blur();
    if (commits) props.commit(held.now);
    else props.cancel();
  };
  const down = (event: PointerEvent<HTMLInputElement>): void => {
    if (event.button !== 0 || typed !== null || document.activeElement === event.currentTarget) return;
    event.currentTarget.setPointerCapture(event.pointerId);
    hand.current = { x: event.clientX, value: value ?? 0, now: value ?? 0, moves: false };
  };
  const move = (event: PointerEvent): void => {
    const held = hand.current;
    if (!held) return;
    const way = event.clientX - held.x;
    if (!held.moves && Math.abs(way) < kPixelsToBegin) return;
    if (!held.moves) input.current?.focus({ preventScroll: true });
    held.moves = true;
    const fine = step * pace(event);
    // Each move is added separately, so that the speed may change on the way.
    held.value += (way / kPixelsPerStep) * fine;
    held.x = event.clientX;
    held.now = limit(rounded(held.value, fine));
    props.drag(held.now);
  };
  const key = (event: KeyboardEvent<HTMLInputElement>): void => {
    if (event.key === 'Escape') {
      if (hand.current) let_go(false);
      set_typed(null);
      event.stopPropagation();
    } else if (event.key === 'Enter') {
      finish(typed);
      event.currentTarget.select();
    } else if (event.key === 'ArrowUp' || event.key === 'ArrowDown') {
      event.preventDefault();
      const from = typed === null ? value : calculate(typed);
      set_typed(null);
      const fine = step * pace(event) * (event.key === 'ArrowUp' ? 1 : -1);
      if (from !== null) props.commit(limit(rounded(from + fine, Math.abs(fine))));
    }
  };
  return (
    <span className={`number-field${props.is_faulty ? ' faulty' : ''}${props.is_dim ? ' dim' : ''}`}>
      <input
        ref={input}
        type="text"
        inputMode="decimal"
        spellCheck={false}
        autoComplete="off"
        aria-label={label}
        aria-invalid={props.is_faulty || undefined}
        aria-description={props.description}
        data-typed={typed !== null || undefined}
        value={typed ?? shown_number(value)}
        onChange={(event) => set_typed(event.target.value)}
        onBlur={() => finish(typed)}
        onKeyDown={key}
        onPointerDown={down}
        onMouseDown={(event) => {
          // Prevents text from being selected during a drag.
          if (hand.current) event.preventDefault();
        }}
        onPointerMove={move}
        onPointerUp={() => let_go(true)}
        onPointerCancel={() => let_go(false)}
      />
      {unit ? <span className="unit">{unit}</span> : null}
    </span>
  );
}
