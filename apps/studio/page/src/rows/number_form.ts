// SPDX-License-Identifier: Apache-2.0
// The forms in which documents write a number that varies.
import type { Json } from '../values/json.ts';
import { is_object } from '../values/json.ts';

export type NumberForm = 'number' | 'range' | 'expression' | 'both';

export function form_of(value: Json | undefined): NumberForm {
  if (typeof value === 'string') return 'expression';
  if (Array.isArray(value)) return 'range';
  return is_object(value) ? 'both' : 'number';
}

/// Returns a number in another form.
export function in_form(form: NumberForm, value: Json | undefined, number: number): Json {
  const range = Array.isArray(value)
    ? value
    : is_object(value) && Array.isArray(value['range'])
      ? value['range']
      : [number, number];
  const said =
    is_object(value) && typeof value['apply'] === 'string' ? value['apply'] : typeof value === 'string' ? value : null;
  if (form === 'range') return range;
  if (form === 'expression') return said ?? String(typeof range[0] === 'number' ? range[0] : number);
  if (form === 'both') return { range, apply: said ?? 'v' };
  return typeof range[0] === 'number' ? range[0] : number;
}
