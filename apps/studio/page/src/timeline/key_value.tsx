// SPDX-License-Identifier: Apache-2.0
// A field for the value of a key: a number, a colour, a switch, or text.
import type { ReactElement } from 'react';

import { NumberField } from '../controls/number_field.tsx';
import { TextField } from '../controls/text_field.tsx';
import { ColourField } from '../editors/colour_rows.tsx';
import { fitting_step } from '../values/arithmetic.ts';
import { full_colour } from '../values/colour.ts';
import type { Json } from '../values/json.ts';
import { write_json } from '../values/json.ts';

interface KeyValueProps {
  label: string;
  value: Json;
  legal: (value: Json) => Json;
  drag: (value: Json) => void;
  commit: (value: Json) => void;
  cancel: () => void;
}

export function KeyValue({ label, value, legal, drag, commit, cancel }: KeyValueProps): ReactElement {
  if (typeof value === 'number')
    return (
      <NumberField
        label={label}
        value={value}
        step={Math.max(1e-4, fitting_step(0, Math.abs(value) || 1, 100))}
        limit={(one) => legal(one) as number}
        drag={drag}
        commit={commit}
        cancel={cancel}
      />
    );
  if (typeof value === 'string' && full_colour(value) !== null)
    return (
      <ColourField
        label={label}
        value={value}
        is_faulty={false}
        is_dim={false}
        drag={drag}
        commit={commit}
        cancel={cancel}
      />
    );
  if (typeof value === 'boolean') {
    return (
      <button
        type="button"
        role="switch"
        className="switch"
        aria-checked={value}
        aria-label={label}
        onClick={() => commit(!value)}
      >
        <span />
      </button>
    );
  }
  const take = (text: string): void => {
    try {
      commit(typeof value === 'string' ? text : (JSON.parse(text) as Json));
    } catch {
      commit(text); // the server reports what is wrong
    }
  };
  return (
    <TextField label={label} value={typeof value === 'string' ? value : write_json(value)} commit={take} is_code />
  );
}
