// SPDX-License-Identifier: Apache-2.0
// What has been done to a text, and how it is taken back. Plain data, so that it can be kept in the browser.
import type { Patch } from './patch.ts';

export interface UndoStep {
  label: string;
  patch: Patch;
  inverse: Patch;
  chosen: string; // path of what was chosen when it was done
}

export interface UndoState {
  done: UndoStep[];
  undone: UndoStep[];
}

export const kTypingPause = 700; // ms after which typing begins a new step
const kMostSteps = 1000;

export const kNothingDone: UndoState = { done: [], undone: [] };

/// With a step more. What had been taken back is gone then, and of too many steps the oldest.
export function with_step(state: UndoState, step: UndoStep): UndoState {
  return { done: [...state.done, step].slice(-kMostSteps), undone: [] };
}

/// With another step in place of the last.
export function with_last(state: UndoState, step: UndoStep): UndoState {
  return { done: [...state.done.slice(0, -1), step], undone: [] };
}

/// The step to take back, and the state after.
export function step_back(state: UndoState): { step: UndoStep; state: UndoState } | null {
  const step = state.done.at(-1);
  if (!step) return null;
  return { step, state: { done: state.done.slice(0, -1), undone: [...state.undone, step] } };
}

/// The step to make again, and the state after.
export function step_forward(state: UndoState): { step: UndoStep; state: UndoState } | null {
  const step = state.undone.at(-1);
  if (!step) return null;
  return { step, state: { done: [...state.done, step], undone: state.undone.slice(0, -1) } };
}
