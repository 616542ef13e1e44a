// SPDX-License-Identifier: Apache-2.0
// A slider. Moves are temporary, releasing it is one step, and Escape restores the previous value.
import type { CSSProperties, KeyboardEvent, ReactElement } from 'react';
import { useEffect, useRef } from 'react';

import type { NumberActions } from './number_field.tsx';

interface SliderProps extends NumberActions {
  label: string;
  value: number;
  low: number;
  high: number;
  step: number;
  is_dim?: boolean;
}

export function Slider(props: SliderProps): ReactElement {
  const { label, value, low, high, step } = props;
  const input = useRef<HTMLInputElement>(null);
  const is_held = useRef(false);
  const is_cancelled = useRef(false);
  const commit = useRef(props.commit);
  commit.current = props.commit;
  // React's onChange is the browser's input event. The browser's change event reports the release of the slider.
  useEffect(() => {
    const element = input.current;
    const take = (): void => {
      is_held.current = false;
      if (!is_cancelled.current) commit.current(Number(element?.value));
      is_cancelled.current = false;
    };
    element?.addEventListener('change', take);
    return () => element?.removeEventListener('change', take);
  }, []);
  const move = (number: number): void => {
    if (!is_cancelled.current) props.drag(number);
  };
  const key = (event: KeyboardEvent): void => {
    if (event.key !== 'Escape' || !is_held.current) return;
    is_cancelled.current = true;
    event.stopPropagation();
    props.cancel();
  };
  const share = high > low ? (100 * (value - low)) / (high - low) : 0;
  return (
    <input
      ref={input}
      type="range"
      className={`slider${props.is_dim ? ' dim' : ''}`}
      aria-label={label}
      min={low}
      max={high}
      step={step}
      value={value}
      style={{ '--share': `${Math.min(100, Math.max(0, share))}%` } as CSSProperties}
      onPointerDown={() => {
        is_held.current = true;
        is_cancelled.current = false;
      }}
      onChange={(event) => move(Number(event.target.value))}
      onKeyDown={key}
    />
  );
}
