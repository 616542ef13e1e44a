// SPDX-License-Identifier: Apache-2.0
// Rows for a colour and for a list of colours, as text, with a picker that opens below.
import type { ReactElement } from 'react';
import { useState } from 'react';

import { IconButton } from '../controls/button.tsx';
import { TextField } from '../controls/text_field.tsx';
import type { RowEditorProps } from '../rows/row_kinds.ts';
import { full_colour } from '../values/colour.ts';
import type { Json } from '../values/json.ts';
import { ColourList } from './colour_list.tsx';
import { ColourPicker } from './colour_picker.tsx';

interface ColourFieldProps {
  label: string;
  value: string;
  is_faulty: boolean;
  is_dim: boolean;
  is_open?: boolean; // open from the start
  drag: (colour: string) => void;
  commit: (colour: string) => void;
  cancel: () => void;
}

export function ColourField(props: ColourFieldProps): ReactElement {
  const { label, value, drag, commit, cancel, is_faulty, is_dim } = props;
  const [is_open, set_open] = useState(props.is_open ?? false);
  const shown = full_colour(value);
  return (
    <div className="stacked">
      <div className="colour">
        <button
          type="button"
          className={`swatch current${shown === null ? ' none' : ''}`}
          aria-label={`${label}, picker`}
          aria-expanded={is_open}
          style={{ background: shown ?? undefined }}
          onClick={() => set_open(!is_open)}
        />
        <TextField
          label={label}
          value={value}
          commit={commit}
          is_code
          is_faulty={is_faulty}
          is_dim={is_dim}
          placeholder="not set"
        />
      </div>
      {is_open && <ColourPicker label={label} value={shown ?? '#808080'} drag={drag} commit={commit} cancel={cancel} />}
    </div>
  );
}

export function ColourRow({ label, value, row, actions, is_faulty, size }: RowEditorProps): ReactElement {
  const shown = value ?? row.default;
  return (
    <ColourField
      label={label}
      value={typeof shown === 'string' ? shown : ''}
      is_faulty={is_faulty}
      is_dim={value === undefined}
      is_open={size === 'large'}
      {...actions}
    />
  );
}

export function ColoursRow({ label, value, actions, is_faulty, size = 'row' }: RowEditorProps): ReactElement {
  const colours = Array.isArray(value) ? value.map(String) : [];
  if (size === 'large') return <ColourList label={label} colours={colours} is_faulty={is_faulty} {...actions} />;
  const with_one = (index: number, colour: string): Json => colours.map((old, k) => (k === index ? colour : old));
  return (
    <div className="stacked">
      {colours.map((colour, index) => (
        <div className="listed" key={index}>
          <ColourField
            label={`${label} ${index + 1}`}
            value={colour}
            is_faulty={is_faulty}
            is_dim={false}
            drag={(one) => actions.drag(with_one(index, one))}
            commit={(one) => actions.commit(with_one(index, one))}
            cancel={actions.cancel}
          />
          <IconButton
            is_small
            icon="close"
            label={`Remove colour ${index + 1}`}
            is_off={colours.length < 2}
            press={() => actions.commit(colours.filter((_, k) => k !== index))}
          />
        </div>
      ))}
      <IconButton
        is_small
        icon="plus"
        label={`Add a colour to ${label}`}
        press={() => actions.commit([...colours, colours.at(-1) ?? '#6b8e23'])}
      />
    </div>
  );
}
