// SPDX-License-Identifier: Apache-2.0
// The variables in the text, used while the server has not read it: because of a fault, or without a server.
import type { Variable } from '../server/protocol.ts';
import type { Json, JsonNode } from '../values/json.ts';
import { is_object } from '../values/json.ts';
import { member_of } from '../values/path.ts';

/// Returns the variables of the text. `known` are the variables that were read last. They supply missing members and
/// the values of expressions.
export function variables_of_text(known: Variable[], tree: JsonNode | null): Variable[] {
  const said = member_of(tree?.value, 'variables');
  if (!is_object(said)) return tree && said === undefined ? [] : known;
  const by_name = new Map(known.map((one) => [one.name, one]));
  return Object.entries(said).map(([name, value]) => variable_of_text(name, value, by_name.get(name)));
}

function variable_of_text(name: string, said: Json, known: Variable | undefined): Variable {
  const part = (key: string): Json | undefined => (is_object(said) ? said[key] : key === 'value' ? said : undefined);
  const number = (key: string): number | undefined => number_or_nothing(part(key));
  const text = (key: string): string | undefined => text_or_nothing(part(key));
  const value = number('value') ?? known?.value ?? 0;
  return {
    name,
    value,
    // Missing bounds are widened to include the value, as in the library.
    min: number('min') ?? Math.min(known?.min ?? 0, value),
    max: number('max') ?? Math.max(known?.max ?? 1, value),
    unit: text('unit') ?? known?.unit ?? '',
    doc: text('doc') ?? known?.doc ?? '',
    expression: text('value') ?? null,
    private: part('private') === true,
  };
}

function number_or_nothing(value: Json | undefined): number | undefined {
  return typeof value === 'number' ? value : undefined;
}

function text_or_nothing(value: Json | undefined): string | undefined {
  return typeof value === 'string' ? value : undefined;
}
