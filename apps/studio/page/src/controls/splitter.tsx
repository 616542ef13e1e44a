// SPDX-License-Identifier: Apache-2.0
// The edge of a panel. A drag or the arrow keys change the panel's width; a double click restores it.
import type { KeyboardEvent, PointerEvent, ReactElement } from 'react';
import { useRef } from 'react';

interface SplitterProps {
  label: string;
  edge: 'left' | 'right'; // edge of the panel with the splitter
  width: number | null; // pixels; null: width of the style
  low: number;
  high: number;
  change: (width: number | null) => void;
}

const kStep = 16; // pixels per arrow key

export function Splitter({ label, edge, width, low, high, change }: SplitterProps): ReactElement {
  const element = useRef<HTMLDivElement>(null);
  const held = useRef<{ x: number; width: number } | null>(null);
  const way = edge === 'right' ? 1 : -1;
  const shown = (): number => width ?? element.current?.parentElement?.offsetWidth ?? low;
  const put = (wanted: number): void => change(Math.round(Math.min(high, Math.max(low, wanted))));
  const down = (event: PointerEvent<HTMLDivElement>): void => {
    event.currentTarget.setPointerCapture(event.pointerId);
    held.current = { x: event.clientX, width: shown() };
  };
  const move = (event: PointerEvent): void => {
    if (held.current) put(held.current.width + way * (event.clientX - held.current.x));
  };
  const key = (event: KeyboardEvent): void => {
    const step = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
    if (step === undefined) return;
    event.preventDefault();
    put(shown() + way * step * kStep);
  };
  return (
    <div
      ref={element}
      className={`splitter at-${edge}`}
      role="separator"
      aria-orientation="vertical"
      aria-label={label}
      aria-valuemin={low}
      aria-valuemax={high}
      aria-valuenow={width ?? low}
      tabIndex={0}
      onPointerDown={down}
      onPointerMove={move}
      onPointerUp={() => (held.current = null)}
      onPointerCancel={() => (held.current = null)}
      onDoubleClick={() => change(null)}
      onKeyDown={key}
    />
  );
}
