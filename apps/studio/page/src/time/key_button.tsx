// SPDX-License-Identifier: Apache-2.0
// The diamond before a row: filled if there is a key at the view's time, half filled if the row has other keys.
import type { ReactElement } from 'react';

import { use_part } from '../base/store.ts';
import { shown_number } from '../controls/number_field.tsx';
import { use_page } from '../page/use_page.ts';
import type { Row } from '../tables/tables.ts';
import { first_value } from '../tables/tables.ts';
import type { Json } from '../values/json.ts';
import { is_object } from '../values/json.ts';
import { steps_of } from '../values/path.ts';
import { TimeModel } from './time_model.ts';
import type { Keyed } from './use_keyed.ts';
import { toggle_key, use_keyed } from './use_keyed.ts';

const kHeads = new Set(['components', 'links', 'scene']);

/// Returns true if the value at a path can have keys.
export function can_have_keys(row: Row, path: string): boolean {
  return row.keyed === true && kHeads.has(String(steps_of(path)[0]));
}

export function RowKeyButton({ row, path, value }: { row: Row; path: string; value: Json | undefined }): ReactElement {
  const page = use_page();
  const keyed = use_keyed(path);
  const label = row.name.replaceAll('_', ' ');
  const model = page.tool(TimeModel);
  const element = use_part(page.document.state, () =>
    keyed === null ? model.tracks.find((one) => one.path.startsWith(`${path}[`)) : undefined,
  );
  // A vector with keys as a whole cannot have keys of single elements.
  if (element) {
    const show = (): void => {
      if (!model.state.get().is_open) model.toggle();
      model.choose(element.name);
    };
    return (
      <Diamond label={label} state="others" tip={`${element.name} has keys of its own; shows them`} press={show} />
    );
  }
  return (
    <KeyButton
      label={label}
      path={path}
      keyed={keyed}
      value={() => keyed?.value ?? first_key_value(value, row, first_value(page.tables, row))}
    />
  );
}

interface KeyButtonProps {
  label: string;
  path: string;
  keyed: Keyed | null;
  value: () => Json; // returns the value of a new key
}

export function KeyButton({ label, path, keyed, value }: KeyButtonProps): ReactElement {
  const page = use_page();
  const state = keyed === null ? 'none' : keyed.index >= 0 ? 'here' : 'others';
  const at = `${shown_number(use_part(page.tool(TimeModel).state, ({ time }) => time))} s`;
  const text = state === 'here' ? `Remove the key of ${label} at ${at}` : `Key ${label} at ${at}`;
  return <Diamond label={label} state={state} tip={text} press={() => toggle_key(page, path, keyed, value())} />;
}

function Diamond({
  label,
  state,
  tip,
  press,
}: {
  label: string;
  state: 'none' | 'others' | 'here';
  tip: string;
  press: () => void;
}): ReactElement {
  return (
    <button
      type="button"
      className={`key-button ${state}`}
      aria-label={`Key of ${label}`}
      aria-pressed={state === 'here'}
      data-tip={tip}
      onClick={press}
    >
      <svg viewBox="0 0 10 10" aria-hidden="true">
        <path d="M5 1L9 5 5 9 1 5z" />
      </svg>
    </button>
  );
}

/// Returns the value of the first key: the first number of the row for an expression, and the range for a range with an
/// expression.
function first_key_value(value: Json | undefined, row: Row, first: Json): Json {
  const plain = value ?? row.default;
  if (plain === undefined || plain === null) return first;
  if (is_object(plain)) return plain['range'] ?? first;
  const is_number = row.kind === 'number' || row.kind === 'integer';
  const has_expression = (one: Json): boolean =>
    Array.isArray(one) ? one.some(has_expression) : typeof one === 'string';
  return (is_number || Array.isArray(plain)) && has_expression(plain) ? first : plain;
}
