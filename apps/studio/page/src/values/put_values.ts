// SPDX-License-Identifier: Apache-2.0
// Copies of a document's values with some values replaced.
import type { Json } from './json.ts';
import { is_object } from './json.ts';
import type { PathStep } from './path.ts';
import { member_of, steps_of } from './path.ts';

/// Returns a value of the document in which other values are replaced by their paths.
export function with_values(
  value: Json | undefined,
  at: readonly PathStep[],
  values: Readonly<Record<string, Json>>,
): Json | undefined {
  let made = value;
  for (const [path, one] of Object.entries(values)) {
    const steps = steps_of(path);
    if (steps.length >= at.length && at.every((step, k) => steps[k] === step))
      made = with_value(made, steps.slice(at.length), one);
  }
  return made;
}

export function with_value(value: Json | undefined, [step, ...rest]: PathStep[], put: Json): Json {
  if (step === undefined) return put;
  if (typeof step === 'number') {
    const list = Array.isArray(value) ? [...value] : [];
    list[step < 0 ? list.length : step] = with_value(list[step], rest, put);
    return list;
  }
  const object = is_object(value) ? value : {};
  return { ...object, [step]: with_value(object[step], rest, put) };
}

/// Returns the value within another one, or undefined if it does not exist.
export function value_within(value: Json | undefined, steps: readonly PathStep[]): Json | undefined {
  return steps.reduce<Json | undefined>(
    (held, step) => (typeof step === 'number' ? (Array.isArray(held) ? held[step] : undefined) : member_of(held, step)),
    value,
  );
}
