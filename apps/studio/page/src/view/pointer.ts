// SPDX-License-Identifier: Apache-2.0
// Pointer and keys in the view: the left button turns, the right or middle button or Shift moves, the wheel and
// pinching zoom.
import type { Orbit } from './orbit.ts';

export interface ViewActions {
  moved(): void;
  fit(): void;
  /// Enter was pressed while the view has the focus.
  entered(): void;
  /// A button was pressed and released at one place, in pixels of the canvas.
  clicked(x: number, y: number): void;
  /// The pointer has not moved for a while, with no button pressed; it then moves again.
  rested(x: number, y: number): void;
  went_on(): void;
}

const kStill = 4; // largest movement of a click, pixels
const kRest = 160; // ms

const kKeys: Record<string, (orbit: Orbit) => void> = {
  ArrowLeft: (orbit) => orbit.turn(-10, 0),
  ArrowRight: (orbit) => orbit.turn(10, 0),
  ArrowUp: (orbit) => orbit.turn(0, 5),
  ArrowDown: (orbit) => orbit.turn(0, -5),
  '+': (orbit) => orbit.zoom(0.85),
  '=': (orbit) => orbit.zoom(0.85),
  '-': (orbit) => orbit.zoom(1 / 0.85),
};

const kShiftKeys: Record<string, (orbit: Orbit) => void> = {
  ArrowLeft: (orbit) => orbit.pan(-0.05, 0),
  ArrowRight: (orbit) => orbit.pan(0.05, 0),
  ArrowUp: (orbit) => orbit.pan(0, 0.05),
  ArrowDown: (orbit) => orbit.pan(0, -0.05),
};

export function listen(canvas: HTMLCanvasElement, orbit: Orbit, actions: ViewActions): void {
  const pointers = new Map<number, { x: number; y: number }>();
  let spread = 0;
  let pressed: { x: number; y: number } | null = null; // position where a click may begin
  let rest = 0;

  const go_on = (): void => {
    clearTimeout(rest);
    rest = 0;
    actions.went_on();
  };
  const wait_for_rest = (event: PointerEvent): void => {
    go_on();
    const { offsetX, offsetY } = event;
    if (event.buttons === 0 && event.pointerType === 'mouse')
      rest = window.setTimeout(() => actions.rested(offsetX, offsetY), kRest);
  };

  canvas.addEventListener('contextmenu', (event) => event.preventDefault());
  canvas.addEventListener('dblclick', () => actions.fit());
  canvas.addEventListener('pointerdown', (event) => {
    canvas.setPointerCapture(event.pointerId);
    pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    pressed = event.button === 0 && pointers.size === 1 ? { x: event.clientX, y: event.clientY } : null;
    spread = 0;
    go_on();
  });
  for (const end of ['pointerup', 'pointercancel'] as const) {
    canvas.addEventListener(end, (event) => pointers.delete(event.pointerId));
  }
  canvas.addEventListener('pointerup', (event) => {
    if (pressed) actions.clicked(event.offsetX, event.offsetY);
    pressed = null;
  });
  canvas.addEventListener('pointerleave', () => go_on());
  canvas.addEventListener('pointermove', (event) => {
    const before = pointers.get(event.pointerId);
    wait_for_rest(event);
    if (pressed && Math.hypot(event.clientX - pressed.x, event.clientY - pressed.y) > kStill) pressed = null;
    if (!before || pressed) return;
    const [dx, dy] = [event.clientX - before.x, event.clientY - before.y];
    pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    const height = canvas.clientHeight;
    if (pointers.size === 2) {
      const [a, b] = [...pointers.values()] as [{ x: number; y: number }, { x: number; y: number }];
      const now = Math.hypot(a.x - b.x, a.y - b.y);
      if (spread > 0) orbit.zoom(spread / now);
      spread = now;
      orbit.pan(-dx / 2 / height, dy / 2 / height);
    } else if (event.shiftKey || (event.buttons & 6) !== 0) {
      orbit.pan(-dx / height, dy / height);
    } else {
      orbit.turn(0.35 * dx, 0.3 * dy);
    }
    actions.moved();
  });
  canvas.addEventListener(
    'wheel',
    (event) => {
      event.preventDefault();
      orbit.zoom(Math.exp(Math.sign(event.deltaY) * Math.min(0.25, Math.abs(event.deltaY) / 800)));
      actions.moved();
    },
    { passive: false },
  );
  canvas.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (event.key === 'Enter') actions.entered();
    const act = (event.shiftKey ? kShiftKeys : kKeys)[event.key] ?? kKeys[event.key];
    if (!act) return;
    event.preventDefault();
    act(orbit);
    actions.moved();
  });
}
