// SPDX-License-Identifier: Apache-2.0
// Acts on one chosen shoot as operations of the document.

import type { FoundShoot } from '../page/instance_choice.ts';
import type { Json } from '../values/json.ts';

export type ShootAction = 'cut' | 'bend' | 'tie' | 'mark';

/// The settings of the tool. Settings of one act are kept while another one is tried.
export interface ActionChoice {
  action: ShootAction;
  cut_at: 'here' | 'base' | 'count';
  count: number; // number of metamers that stay
  inclination: number; // degrees
  bent: number; // number of metamers over which the bend extends
  string: number; // metres
  state: string;
  season: 'winter' | 'summer';
}

export const kFirstChoice: ActionChoice = {
  action: 'cut',
  cut_at: 'here',
  count: 3,
  inclination: 0,
  bent: 3,
  string: 0.5,
  state: 'marked',
  season: 'winter',
};

/// Returns the number of metamers of the shoot that a cut leaves.
export function kept_metamers(shoot: FoundShoot, choice: ActionChoice): number {
  if (choice.cut_at === 'base') return 0;
  return choice.cut_at === 'here' ? shoot.metamer : Math.max(0, Math.round(choice.count));
}

/// Returns the reason why the act is impossible, or an empty text.
export function why_not(shoot: FoundShoot, choice: ActionChoice): string {
  const is_stem = shoot.shoot === 'main';
  if (choice.action === 'tie' && is_stem) return 'A stem cannot be tied down; choose a branch';
  const is_all = choice.action === 'cut' && kept_metamers(shoot, choice) === 0 && is_stem;
  return is_all ? 'Nothing would be left of the tree' : '';
}

/// Returns the operation, after the shown iteration. `trees` is the number of trees that it could mean.
export function operation_of(shoot: FoundShoot, choice: ActionChoice, trees: number): { [name: string]: Json } {
  const head: { [name: string]: Json } = {
    do: choice.action,
    at: shoot.iteration,
    ...(choice.season === 'summer' ? { season: 'summer' } : {}),
    shoots: shoot.shoot,
    ...(trees > 1 ? { tree: shoot.tree } : {}),
  };
  if (choice.action === 'cut') return { ...head, above: kept_metamers(shoot, choice) };
  if (choice.action === 'bend')
    return {
      ...head,
      below: shoot.metamer,
      metamers: Math.max(1, Math.round(choice.bent)),
      inclination: choice.inclination,
    };
  if (choice.action === 'tie')
    return { ...head, ...(shoot.metamer > 0 ? { below: shoot.metamer } : {}), anchor: 'ground', length: choice.string };
  return { ...head, state: choice.state };
}

/// Returns the label of the step in the undo list.
export function label_of(shoot: FoundShoot, choice: ActionChoice): string {
  return `${choice.action[0]?.toUpperCase() ?? ''}${choice.action.slice(1)} ${shoot.shoot}`;
}

/// Returns the shoot's course in two parts: the part that stays and the part beyond.
export function parts_of(shoot: FoundShoot, kept: number): { stays: number[]; goes: number[] } {
  const first_gone = shoot.metamers.findIndex((number) => number > kept);
  const end = 3 * Math.max(1, first_gone < 0 ? shoot.metamers.length : first_gone);
  return { stays: shoot.course.slice(0, end), goes: shoot.course.slice(end - 3) };
}
