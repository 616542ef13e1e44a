// SPDX-License-Identifier: Apache-2.0
// Grips of numbers that are written as expressions. A drag changes the document where this is possible. Grips that an
// expression blocks show this before a drag.
import type { Json } from '../values/json.ts';
import type { Vec } from '../values/space_math.ts';
import { dot, minus, times } from '../values/space_math.ts';
import type { Expressed, MeantValues } from './expressions.ts';
import { meant_values } from './expressions.ts';
import type { Amount, Grip, GripField, GripGroup, Values } from './grip.ts';

/// The effect of expressions on a grip or a field.
export interface Binding {
  held: readonly Expressed[]; // expressions that would have to give another number
  moves: readonly string[]; // variables that move instead
}

export interface BoundGroup extends Omit<GripGroup, 'grips' | 'fields'> {
  grips: (Grip & Binding)[];
  fields: (GripField & Binding)[];
}

const kProbe = 0.1; // metres, or an equal share of a field's step, or a few degrees

/// `legal` returns values as their rows allow them.
export function bound_group(
  group: GripGroup,
  all: readonly Expressed[],
  written_at: (path: string) => Json | undefined,
  legal: (values: Values) => Values = (values) => values,
): BoundGroup {
  const meant = (values: Values): MeantValues => meant_values(legal(values), all, written_at);
  const binding = (tried: Values[]): Binding => {
    const found = all.length > 0 ? tried.map(meant) : [];
    const held = new Map(found.flatMap((one) => one.held).map((one) => [one.path, one]));
    const moves = new Set(
      all.flatMap(({ variable }) =>
        variable && found.some(({ values }) => variable.name in values) ? [variable.name] : [],
      ),
    );
    return { held: [...held.values()], moves: [...moves] };
  };
  return {
    ...group,
    grips: group.grips.map((grip) => ({
      ...grip,
      ...binding(probes_of(grip).map(grip.values)),
      values: (amount) => meant(grip.values(amount)).values,
    })),
    fields: group.fields.map((field) => ({
      ...field,
      ...binding([-kProbe, kProbe].map((by) => field.values(field.limit(field.value + by)))),
      values: (value) => meant(field.values(value)).values,
    })),
  };
}

/// Small moves in both directions, so that a limit hides no expression.
function probes_of({ motion, way }: Grip): Amount[] {
  const across: Vec = [kProbe, kProbe, kProbe];
  const by =
    motion === 'line' ? times(way, kProbe) : motion === 'plane' ? minus(across, times(way, dot(across, way))) : across;
  return [1, -1].map(
    (sign): Amount =>
      motion === 'ring'
        ? { by: [0, 0, 0], degrees: 70 * kProbe * sign, step: 1e-6 }
        : { by: times(by, sign), degrees: 0, step: 1e-6 },
  );
}

/// Returns the label of a step in the undo list: the moved part, or the variables if only they are changed.
export function step_label(group: { label: string }, values: Values, { moves }: Binding): string {
  const names = Object.keys(values);
  const are_variables = names.length > 0 && names.every((name) => moves.includes(name));
  return `Set ${are_variables ? names.join(', ').replaceAll('_', ' ') : group.label}`;
}
