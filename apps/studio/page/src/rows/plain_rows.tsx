// SPDX-License-Identifier: Apache-2.0
// Editors of values other than numbers and tables.
import type { ReactElement } from 'react';
import { useState } from 'react';
import { TextField } from '../controls/text_field.tsx';
import type { Json } from '../values/json.ts';
import { write_json } from '../values/json.ts';
import { NumberOrText } from './number_row.tsx';
import type { RowEditorProps } from './row_kinds.ts';

export function BooleanRow({ label, value, row, actions }: RowEditorProps): ReactElement {
  const is_on = (value ?? row.default) === true;
  return (
    <button
      type="button"
      role="switch"
      className={`switch${value === undefined ? ' dim' : ''}`}
      aria-checked={is_on}
      aria-label={label}
      aria-description={row.doc}
      onClick={() => actions.commit(!is_on)}
    >
      <span />
    </button>
  );
}

export function ChoiceRow({ label, value, row, actions }: RowEditorProps): ReactElement {
  const shown = value ?? row.default;
  return (
    <select
      className={`select${value === undefined ? ' dim' : ''}`}
      aria-label={label}
      aria-description={row.doc}
      value={typeof shown === 'string' ? shown : ''}
      onChange={(event) => actions.commit(event.target.value)}
    >
      {typeof shown !== 'string' && <option value="">not set</option>}
      {row.choices?.map((choice) => (
        <option key={choice} value={choice}>
          {choice.replaceAll('_', ' ')}
        </option>
      ))}
    </select>
  );
}

export function TextRow({ label, value, row, actions, is_faulty }: RowEditorProps): ReactElement {
  const shown = value ?? row.default;
  const text = typeof shown === 'string' ? shown : shown === undefined || shown === null ? '' : write_json(shown);
  const is_code = row.kind !== 'text';
  const take = (typed: string): void => {
    const number = Number(typed);
    // A condition or a formula may be a plain number.
    actions.commit(row.kind === 'formula' && typed.trim() !== '' && Number.isFinite(number) ? number : typed);
  };
  return (
    <TextField
      label={label}
      value={text}
      commit={take}
      is_code={is_code}
      is_faulty={is_faulty}
      is_dim={value === undefined}
      description={row.doc}
      placeholder="not set"
    />
  );
}

export function LinesRow({ label, value, row, actions, is_faulty }: RowEditorProps): ReactElement {
  const text = Array.isArray(value) ? value.join('\n') : typeof value === 'string' ? value : '';
  const lines = Math.min(18, Math.max(3, text.split('\n').length + 1));
  return (
    <TextField
      label={label}
      value={text}
      commit={(typed) => actions.commit(Array.isArray(value) || value === undefined ? typed.split('\n') : typed)}
      is_code
      is_faulty={is_faulty}
      lines={lines}
      description={row.doc}
    />
  );
}

const kAxes = ['x', 'y', 'z'];

export function VectorRow(props: RowEditorProps): ReactElement {
  const { label, value, row } = props;
  const count = row.kind === 'integers' ? (row.count ?? 1) : 3;
  const shown = value ?? row.default;
  const numbers = Array.isArray(shown) ? shown : Array.from({ length: count }, () => 0);
  return (
    <div className="vector">
      {numbers.slice(0, count).map((one, index) => (
        <NumberOrText
          key={index}
          {...props}
          label={`${label} ${row.kind === 'integers' ? index + 1 : (kAxes[index] ?? index)}`}
          element={one}
          put={(number) => numbers.map((old, k) => (k === index ? number : old))}
        />
      ))}
    </div>
  );
}

/// Three numbers that give a direction, or the name of a direction.
export function FacingRow(props: RowEditorProps): ReactElement {
  const { label, value, row, actions } = props;
  const shown = value ?? row.default;
  const is_vector = Array.isArray(shown);
  const choose = (way: string): void => actions.commit(way === 'direction' ? [0, 1, 0] : way);
  return (
    <div className="stacked">
      <select
        className={`select${value === undefined ? ' dim' : ''}`}
        aria-label={`${label}, how it is given`}
        aria-description={row.doc}
        value={is_vector ? 'direction' : typeof shown === 'string' ? shown : ''}
        onChange={(event) => choose(event.target.value)}
      >
        {!is_vector && typeof shown !== 'string' && <option value="">not set</option>}
        <option value="surface">by the surface</option>
        <option value="direction">a direction</option>
      </select>
      {is_vector && <VectorRow {...props} />}
    </div>
  );
}

export function BoxRow(props: RowEditorProps): ReactElement {
  const shown = props.value ?? props.row.default;
  const corners = Array.isArray(shown)
    ? shown
    : [
        [0, 0, 0],
        [1, 1, 1],
      ];
  return (
    <div className="stacked">
      {corners.slice(0, 2).map((corner, index) => (
        <div className="vector" key={index}>
          {(Array.isArray(corner) ? corner : [0, 0, 0]).map((one, axis) => (
            <NumberOrText
              key={axis}
              {...props}
              label={`${props.label}, ${index === 0 ? 'lower' : 'upper'} ${kAxes[axis] ?? ''}`}
              element={one}
              put={(number) =>
                corners.map((old, k) =>
                  k === index && Array.isArray(old) ? old.map((o, a) => (a === axis ? number : o)) : old,
                )
              }
            />
          ))}
        </div>
      ))}
    </div>
  );
}

/// A curve or an outline with expressions, as text.
export function WrittenRow({ label, value, row, actions, is_faulty }: RowEditorProps): ReactElement {
  const [fault, set_fault] = useState('');
  const shown = value ?? row.default;
  const text = shown === undefined || shown === null ? '' : write_json(shown);
  const take = (typed: string): void => {
    try {
      actions.commit(JSON.parse(typed) as Json);
      set_fault('');
    } catch {
      set_fault('This is not a list as documents write it, such as [[0, 1], [1, 0]]');
    }
  };
  return (
    <div className="stacked">
      <TextField
        label={label}
        value={text}
        commit={take}
        is_code
        is_faulty={is_faulty || fault !== ''}
        is_dim={value === undefined}
        lines={Math.min(6, 1 + Math.ceil(text.length / 34))}
        description={row.doc}
        placeholder="not set"
      />
      {fault && <p className="fault-line">{fault}</p>}
    </div>
  );
}
