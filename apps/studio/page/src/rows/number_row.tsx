// SPDX-License-Identifier: Apache-2.0
// A row for a number in all its forms: a number, a range over the siblings, an expression, or both.
import type { ReactElement } from 'react';

import { NumberField } from '../controls/number_field.tsx';
import { Slider } from '../controls/slider.tsx';
import { TextField } from '../controls/text_field.tsx';
import { legal_value } from '../tables/legal.ts';
import type { Row } from '../tables/tables.ts';
import { slider_range, within_hard_range } from '../tables/tables.ts';
import { fitting_step } from '../values/arithmetic.ts';
import type { Json } from '../values/json.ts';
import { is_object, write_json } from '../values/json.ts';
import type { RowActions } from './row_actions.ts';

interface NumberRowProps {
  row: Row;
  label: string;
  value: Json | undefined; // undefined: the default applies
  actions: RowActions;
  is_faulty: boolean;
}

export function NumberRow(props: NumberRowProps): ReactElement {
  const { row, label, value, actions } = props;
  if (typeof value === 'string') {
    return (
      <TextField
        label={`${label}, expression`}
        value={value}
        commit={(text) => actions.commit(text)}
        is_code
        is_faulty={props.is_faulty}
        description={row.doc}
      />
    );
  }
  if (Array.isArray(value)) return <RangeFields {...props} range={value} put={(range) => range} />;
  if (is_object(value) && Array.isArray(value['range'])) {
    const apply = typeof value['apply'] === 'string' ? value['apply'] : 'v';
    return (
      <div className="stacked">
        <RangeFields {...props} range={value['range']} put={(range) => ({ range, apply })} />
        <TextField
          label={`${label}, applied to the range`}
          value={apply}
          commit={(text) => actions.commit({ range: value['range'] ?? [0, 0], apply: text })}
          is_code
          is_faulty={props.is_faulty}
        />
      </div>
    );
  }
  const shown = value ?? row.default;
  if (typeof shown === 'number' || shown === undefined || shown === null) {
    return (
      <OneNumber {...props} number={typeof shown === 'number' ? shown : null} put={(number) => number} has_slider />
    );
  }
  return <span className="quiet">{typeof shown === 'string' ? shown : write_json(shown)}</span>;
}

interface OneNumberProps extends NumberRowProps {
  number: number | null;
  put: (number: Json) => Json; // returns the row's value with this number in it
  has_slider?: boolean;
}

export function OneNumber(props: OneNumberProps): ReactElement {
  const { row, label, number, put, actions, value } = props;
  const is_whole = row.kind === 'integer' || row.kind === 'integers';
  const [low, high] = slider_range(row, number);
  const step = is_whole ? Math.max(1, Math.round((high - low) / 400)) : fitting_step(low, high, 200);
  const limit = (one: number): number => within_hard_range(row, is_whole ? Math.round(one) : one);
  const acts = {
    drag: (one: number) => actions.drag(put(limit(one))),
    commit: (one: number) => actions.commit(put(limit(one))),
    cancel: actions.cancel,
  };
  const is_dim = value === undefined;
  const can_slide = props.has_slider === true && Number.isFinite(low) && Number.isFinite(high) && high > low;
  return (
    <div className={can_slide ? 'number-pair' : 'number-alone'}>
      {can_slide && (
        <Slider
          {...acts}
          label={`${label}, slider`}
          value={number ?? low}
          low={low}
          high={high}
          step={step}
          is_dim={is_dim}
        />
      )}
      <NumberField
        {...acts}
        label={label}
        value={number}
        step={step}
        unit={row.unit}
        description={row.doc}
        limit={limit}
        is_faulty={props.is_faulty}
        is_dim={is_dim}
        express={(text) => actions.commit(put(text))}
      />
    </div>
  );
}

interface RangeFieldsProps extends NumberRowProps {
  range: Json[];
  put: (range: Json[]) => Json;
}

/// Two ends side by side, each a number or an expression.
function RangeFields(props: RangeFieldsProps): ReactElement {
  const { range, put, label } = props;
  return (
    <div className="number-ends">
      {range.slice(0, 2).map((end, index) => (
        <NumberOrText
          key={index}
          {...props}
          label={`${label}, ${index === 0 ? 'first' : 'last'}`}
          element={end}
          put={(one) => put(range.map((old, k) => (k === index ? one : old)))}
        />
      ))}
    </div>
  );
}

interface NumberOrTextProps extends NumberRowProps {
  element: Json;
  put: (one: Json) => Json;
}

/// A number in a range or a vector, which may also be an expression.
export function NumberOrText(props: NumberOrTextProps): ReactElement {
  const { element, put, label, actions, row } = props;
  if (typeof element === 'string') {
    return (
      <TextField
        label={label}
        value={element}
        commit={(text) => actions.commit(put(legal_value(row, as_number(text))))}
        is_code
        is_faulty={props.is_faulty}
      />
    );
  }
  return <OneNumber {...props} number={typeof element === 'number' ? element : null} put={put} />;
}

/// Returns the typed text as a number if possible.
function as_number(text: string): Json {
  const number = Number(text);
  return text.trim() !== '' && Number.isFinite(number) ? number : text;
}
