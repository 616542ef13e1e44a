// SPDX-License-Identifier: Apache-2.0
// The list of all keys.

export interface Shortcut {
  keys: string;
  text: string;
}

export const kShortcuts: { title: string; keys: Shortcut[] }[] = [
  {
    title: 'Document',
    keys: [
      { keys: 'Ctrl+O', text: 'Open a file' },
      { keys: 'Ctrl+M', text: 'Shipped plants' },
      { keys: 'Ctrl+S', text: 'Save' },
      { keys: 'Ctrl+Shift+S', text: 'Save as' },
      { keys: 'Ctrl+E', text: 'Export' },
      { keys: 'Ctrl+Z', text: 'Undo' },
      { keys: 'Ctrl+Shift+Z', text: 'Redo' },
      { keys: 'R', text: 'Roll the seed' },
      { keys: 'T', text: 'Text or inspector' },
      { keys: 'G', text: 'Grammar or inspector' },
      { keys: 'O', text: 'Plan of operations or inspector' },
      { keys: 'M', text: 'Measures or inspector' },
      { keys: 'N', text: 'Nine plants by chance' },
      { keys: 'P', text: 'Pin the state beside the view' },
    ],
  },
  {
    title: 'Board',
    keys: [
      { keys: 'B', text: 'Board or outline' },
      { keys: 'A', text: 'Add a component below the chosen one' },
      { keys: 'Arrow keys', text: 'Go from component to component' },
      { keys: 'Alt+arrow keys', text: 'Move the component among its siblings; with Shift, in the document' },
      { keys: 'L', text: 'Link from the component: choose the other end, Enter' },
      { keys: 'F2, N', text: 'Rename; note' },
      { keys: 'Ctrl+D, Ctrl+C, Ctrl+V', text: 'Duplicate, copy, paste below' },
      { keys: 'Del', text: 'Delete, with what stands on it alone' },
      { keys: 'Space, H, S', text: 'Fold, hide, show alone' },
    ],
  },
  {
    title: 'View',
    keys: [
      { keys: 'Click', text: 'Choose the component that is seen there' },
      { keys: 'Drag', text: 'Turn' },
      { keys: 'Shift+Drag, right button', text: 'Move' },
      { keys: 'Wheel', text: 'Zoom' },
      { keys: 'F', text: 'Fit the plant' },
      { keys: '1, 3, 7', text: 'From the front, the side, above' },
      { keys: 'W', text: 'Shaded, wireframe, skeleton' },
      { keys: 'E', text: 'Grips of what is chosen' },
      { keys: 'S', text: 'Steps of growth, and what the plant grew by' },
      { keys: 'Arrow keys, +, −', text: 'Turn and zoom, when the view has the keyboard' },
    ],
  },
  {
    title: 'Shoots of a tree',
    keys: [
      { keys: 'Enter', text: 'Take hold of a shoot, when the view has the keyboard' },
      { keys: 'Left, Right', text: 'To the shoot that bears it, to one that it bears' },
      { keys: 'PageUp, PageDown', text: 'To its neighbours' },
      { keys: 'Up, Down, Home, End', text: 'Along the shoot: the place of the cut' },
      { keys: 'C, B, T, M', text: 'Cut, bend, tie, mark; Enter does it' },
      { keys: 'Esc', text: 'Let it go' },
    ],
  },
  {
    title: 'Grips in the view',
    keys: [
      { keys: 'Drag', text: 'Move, size or turn in whole steps; Alt or Shift finely' },
      { keys: 'Arrow keys', text: 'A step along the grip; Shift finely, Ctrl coarsely' },
      { keys: 'PageUp, PageDown', text: 'Choose another grip' },
      { keys: 'Esc', text: 'Back to what it was; then hide the grips' },
    ],
  },
  {
    title: 'Time',
    keys: [
      { keys: 'K', text: 'Timeline' },
      { keys: 'Shift+K', text: 'Play, stop' },
      { keys: 'Left, Right', text: 'A frame back, on; the time or the chosen key. Ten with Shift' },
      { keys: 'Delete', text: 'Remove the chosen key' },
    ],
  },
  {
    title: 'Numbers',
    keys: [
      { keys: 'Drag across', text: 'Change; Shift finely, Ctrl coarsely' },
      { keys: 'Up, Down', text: 'A step; Shift finely, Ctrl coarsely' },
      { keys: 'Enter', text: 'Take over: 1/3, 2*(4+0.5), or an expression' },
      { keys: 'Esc', text: 'Back to what it was' },
    ],
  },
  {
    title: 'Points of curves, outlines and axes',
    keys: [
      { keys: 'Drag', text: 'Move; Alt is drawn to nothing' },
      { keys: 'Double click, +', text: 'Add a point' },
      { keys: 'Delete', text: 'Remove the chosen point' },
      { keys: 'Arrow keys', text: 'Move it; Shift finely, Ctrl coarsely' },
      { keys: 'PageUp, PageDown, Home, End', text: 'Choose another point' },
    ],
  },
];
