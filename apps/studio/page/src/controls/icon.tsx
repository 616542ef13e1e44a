// SPDX-License-Identifier: Apache-2.0
// The studio's own icons, on a grid of 16 with strokes of 1.5 and round ends.
import type { ReactElement } from 'react';

const kPaths = {
  open: 'M2 12.5v-9h4l1.5 2H14v7z',
  save: 'M3 2.5h8l2.5 2.5v8.5h-11v-11zM5 2.5v3.5h5V2.5M5 13.5v-4h6v4',
  save_as: 'M7 13.5H2.5v-11H11L13.5 5v2M5 2.5V6h5V2.5M9.5 13.5l.5-2 3.5-3.5 1.5 1.5-3.5 3.5z',
  models: 'M2.5 2.5h4.5v4.5H2.5zM9 2.5h4.5v4.5H9zM2.5 9h4.5v4.5H2.5zM9 9h4.5v4.5H9z',
  undo: 'M5.5 3L2.5 6l3 3M2.5 6H10a3.5 3.5 0 010 7H6',
  redo: 'M10.5 3l3 3-3 3M13.5 6H6a3.5 3.5 0 000 7h4',
  export: 'M8 10V2.5M5 5.5l3-3 3 3M2.5 9.5v4h11v-4',
  command: 'M2.5 3h11v10h-11zM5 6l2 2-2 2M8.5 10.5H11',
  dice: 'M3 3h10v10H3zM5.5 5.8h.6M9.9 5.8h.6M7.7 8h.6M5.5 10.2h.6M9.9 10.2h.6',
  sun: 'M8 5.2a2.8 2.8 0 110 5.6 2.8 2.8 0 010-5.6zM8 1.5v1M8 13.5v1M1.5 8h1M13.5 8h1M3.4 3.4l.7.7M11.9 11.9l.7.7M3.4 12.6l.7-.7M11.9 4.1l.7-.7',
  moon: 'M13 9.6A5.6 5.6 0 016.4 3 5.5 5.5 0 1013 9.6z',
  auto: 'M8 2.5a5.5 5.5 0 100 11 5.5 5.5 0 000-11zM8 2.5v11M10 4.5v7M12 6v4',
  lock: 'M4 7.5h8v6H4zM5.5 7.5V5a2.5 2.5 0 015 0v2.5',
  unlock: 'M4 7.5h8v6H4zM5.5 7.5V5a2.5 2.5 0 014.8-1',
  reset: 'M3 3.5v3.2h3.2M3.2 6.5A5.2 5.2 0 112.9 9',
  eye: 'M1.5 8S4 3.8 8 3.8 14.5 8 14.5 8 12 12.2 8 12.2 1.5 8 1.5 8zM8 6.2a1.8 1.8 0 110 3.6 1.8 1.8 0 010-3.6z',
  eye_off:
    'M2.5 2.5l11 11M6 4.1A7 7 0 018 3.8c4 0 6.5 4.2 6.5 4.2a12 12 0 01-2 2.4M10 11.9a7 7 0 01-2 .3C4 12.2 1.5 8 1.5 8a12 12 0 012.3-2.7',
  more: 'M3.5 8h.01M8 8h.01M12.5 8h.01',
  down: 'M4 6l4 4 4-4',
  right: 'M6 4l4 4-4 4',
  left: 'M10 4L6 8l4 4',
  up: 'M4 10l4-4 4 4',
  plus: 'M8 3v10M3 8h10',
  close: 'M4 4l8 8M12 4l-8 8',
  fit: 'M2.5 6V2.5H6M10 2.5h3.5V6M13.5 10v3.5H10M6 13.5H2.5V10',
  growth: 'M8 14V6M8 10L5 7.5M8 8l3-2.5M3 4h.01M6 2.5h.01M10 2.5h.01M13 4h.01M2.5 8h.01M13.5 8.5h.01',
  ground: 'M1.5 11l6.5-3 6.5 3-6.5 3zM8 8V2.5M5.5 5L8 2.5 10.5 5',
  search: 'M7 2.5a4.5 4.5 0 110 9 4.5 4.5 0 010-9zM10.3 10.3l3.2 3.2',
  leaf: 'M13.5 2.5c-7 0-10.5 3-10.5 7 0 2 1.2 3.3 3 3.3 4.5 0 7.5-4.3 7.5-10.3zM2.5 13.5C5 9.5 7 8 9.5 6.5',
  stem: 'M8 14V3M8 9.5l4-4M8 7L4.5 3.5M12 5.5V3.2M4.5 3.5H2.6',
  link: 'M6.5 9.5l3-3M7.5 4.5L9 3a2.8 2.8 0 014 4l-1.5 1.5M8.5 11.5L7 13a2.8 2.8 0 01-4-4l1.5-1.5',
  scene: 'M2 12.5h12M4 12.5a4 4 0 018 0M8 3v2M3.5 5l1.2 1.4M12.5 5l-1.2 1.4',
  document: 'M4 1.8h5.5L12.5 5v9.2H4zM9.2 2v3.2h3.2',
  warning: 'M8 2.2l6.2 11H1.8zM8 6.5v3M8 11.4h.01',
  fault: 'M8 2a6 6 0 110 12A6 6 0 018 2zM8 5v3.5M8 10.8h.01',
  check: 'M3 8.5l3.3 3.2L13 4.8',
  pause: 'M5.5 3.5v9M10.5 3.5v9',
  play: 'M5 3.2l8 4.8-8 4.8z',
  stop: 'M4 4h8v8H4z',
  camera: 'M2 5h3l1-1.5h4L11 5h3v8H2zM8 6.7a2.2 2.2 0 110 4.4 2.2 2.2 0 010-4.4z',
  folder: 'M2 12.5v-9h4l1.5 2H14v7z',
  many: 'M8 8V3M8 8l4.3 2.5M8 8l-4.3 2.5M8 1.7a1.3 1.3 0 110 2.6 1.3 1.3 0 010-2.6zM13 9.6a1.3 1.3 0 110 2.6 1.3 1.3 0 010-2.6zM3 9.6a1.3 1.3 0 110 2.6 1.3 1.3 0 010-2.6z',
  note: 'M3 2.5h10v8L10 13.5H3zM5.5 5.5h5M5.5 8h3',
  solo: 'M8 5.5a2.5 2.5 0 110 5 2.5 2.5 0 010-5zM8 1.5v1.7M8 12.8v1.7M1.5 8h1.7M12.8 8h1.7',
  fold: 'M4 4.5l4 3 4-3M4 11.5l4-3 4 3',
  unfold: 'M4 6l4-3.5L12 6M4 10l4 3.5 4-3.5',
  turn: 'M3 6.5h7.5v7M8 11l2.5 2.5L13 11M3 6.5V3',
  edit: 'M3 13l.7-3L11 2.7 13.3 5 6 12.3zM9.5 4.2l2.3 2.3',
  bin: 'M3 4.5h10M6 4.5v-2h4v2M4.5 4.5l.6 9h5.8l.6-9M6.8 7v4M9.2 7v4',
  board: 'M6 2.5h4v3H6zM2 10.5h4v3H2zM10 10.5h4v3h-4zM8 5.5V8M4 10.5V8h8v2.5',
  help: 'M6 6a2 2 0 113 1.7c-.7.4-1 .8-1 1.6M8 11.8h.01',
  magnet: 'M4 2.5v6a4 4 0 008 0v-6H9.3v6a1.3 1.3 0 01-2.6 0v-6zM4 5.2h2.7M9.3 5.2H12',
  enlarge: 'M9.5 2.5h4v4M13.5 2.5L9 7M6.5 13.5h-4v-4M2.5 13.5L7 9',
  clock: 'M8 2.2a5.8 5.8 0 110 11.6A5.8 5.8 0 018 2.2zM8 4.8V8l2.4 1.6',
  film: 'M2 3.5h12v9H2zM5 3.5v9M11 3.5v9M2 6.5h3M2 9.5h3M11 6.5h3M11 9.5h3',
  strip: 'M1.5 5h3.5v6H1.5zM6.2 5h3.6v6H6.2zM11 5h3.5v6H11z',
  grid: 'M2.5 2.5h3v3h-3zM6.5 2.5h3v3h-3zM10.5 2.5h3v3h-3zM2.5 6.5h3v3h-3zM6.5 6.5h3v3h-3zM10.5 6.5h3v3h-3zM2.5 10.5h3v3h-3zM6.5 10.5h3v3h-3zM10.5 10.5h3v3h-3z',
  pin: 'M6 2.5h4M7 2.5v4L4.8 9h6.4L9 6.5v-4M8 9v4.5',
  swap: 'M2.5 5.5h11M10.5 2.5l3 3-3 3M13.5 11h-11M5.5 8l-3 3 3 3',
  grips: 'M8 8V1.8M6 3.8l2-2 2 2M8 8l-5.2 3.6M2.6 9.2l.2 2.4 2.4.1M8 8l5.2 3.6M13.4 9.2l-.2 2.4-2.4.1',
  first: 'M4 3.5v9M12 3.5L6.5 8l5.5 4.5z',
  last: 'M12 3.5v9M4 3.5L9.5 8 4 12.5z',
  sparkle: 'M8 2l1.4 4.6L14 8l-4.6 1.4L8 14l-1.4-4.6L2 8l4.6-1.4z',
} as const;

export type IconName = keyof typeof kPaths;

export function Icon({ name }: { name: IconName }): ReactElement {
  return (
    <svg className="icon" viewBox="0 0 16 16" aria-hidden="true" focusable="false">
      <path d={kPaths[name]} />
    </svg>
  );
}
