// SPDX-License-Identifier: Apache-2.0
// The list of changes of a text, for undo and redo. It is plain data, so that the browser can keep it.
import type { Patch } from '../values/patch.ts';
import { joined_patch } from '../values/patch.ts';

export interface UndoStep {
  label: string;
  patch: Patch;
  inverse: Patch;
  chosen: string; // path that was chosen at the time of the change
}

export interface UndoState {
  done: UndoStep[];
  undone: UndoStep[];
}

export const kTypingPause = 700; // ms of pause after which typing begins a new step
const kMaxSteps = 1000;

export const kNothingDone: UndoState = { done: [], undone: [] };

/// Returns the state with another step. Undone steps are dropped, and so are the oldest steps if there are too many.
export function with_step(state: UndoState, step: UndoStep): UndoState {
  return { done: [...state.done, step].slice(-kMaxSteps), undone: [] };
}

/// Returns the state with the last step replaced.
export function with_last(state: UndoState, step: UndoStep): UndoState {
  return { done: [...state.done.slice(0, -1), step], undone: [] };
}

/// Returns the state with typing that goes on: it joins the last step if that was typing too. `text` is the text before
/// the step.
export function with_typing(state: UndoState, step: UndoStep, text: string): UndoState {
  const last = state.done.at(-1);
  if (last?.label !== step.label) return with_step(state, step);
  return with_last(state, { ...step, ...joined_patch(text, last.inverse, step.patch) });
}

/// Returns the step to undo, and the state after it.
export function step_back(state: UndoState): { step: UndoStep; state: UndoState } | null {
  const step = state.done.at(-1);
  if (!step) return null;
  return { step, state: { done: state.done.slice(0, -1), undone: [...state.undone, step] } };
}

/// Returns the step to redo, and the state after it.
export function step_forward(state: UndoState): { step: UndoStep; state: UndoState } | null {
  const step = state.undone.at(-1);
  if (!step) return null;
  return { step, state: { done: [...state.done, step], undone: state.undone.slice(0, -1) } };
}
