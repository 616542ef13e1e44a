// SPDX-License-Identifier: Apache-2.0
// A row for a list of positions, such as an axis. Positions are drawn if all are plain numbers. Each has three fields,
// which also accept expressions.
import type { ReactElement } from 'react';

import { IconButton } from '../controls/button.tsx';
import { NumberOrText } from '../rows/number_row.tsx';
import type { RowEditorProps } from '../rows/row_kinds.ts';
import { legal_value } from '../tables/legal.ts';
import { hard_range } from '../tables/tables.ts';
import type { Json } from '../values/json.ts';
import { next_position } from './next_position.ts';
import { places_of } from './space.ts';
import { SpaceEditor } from './space_editor.tsx';

const kAxes = ['x', 'y', 'z'];

export function PositionsRow(props: RowEditorProps): ReactElement {
  const { label, row, actions, size = 'row' } = props;
  const shown = props.value ?? row.default;
  const positions = Array.isArray(shown) ? shown : [];
  const places = places_of(positions);
  return (
    <div className={`stacked positions of-${size}`}>
      {places && places.length > 0 && (
        <SpaceEditor
          label={label}
          places={places}
          is_joined={row.together === 'line'}
          is_dim={props.value === undefined}
          range={hard_range(row)}
          size={size}
          drag={actions.drag}
          commit={actions.commit}
          cancel={actions.cancel}
        />
      )}
      <div className="stacked position-fields">
        <PositionFields {...props} positions={positions} />
        <div className="add-line">
          <span>{positions.length === 0 ? 'No positions yet' : 'x, y, z in metres'}</span>
          <span className="stretch" />
          <IconButton
            is_small
            icon="plus"
            label={`Add a position to ${label}`}
            press={() => actions.commit([...positions, legal_value(row, next_position(positions))])}
          />
        </div>
      </div>
    </div>
  );
}

function PositionFields(props: RowEditorProps & { positions: Json[] }): ReactElement {
  const { label, actions, positions } = props;
  const with_one = (index: number, axis: number, one: Json): Json =>
    positions.map((old, k) =>
      k === index && Array.isArray(old) ? old.map((before, a) => (a === axis ? one : before)) : old,
    );
  const remove = (index: number): void => actions.commit(positions.filter((_, k) => k !== index));
  return (
    <>
      {positions.map((position, index) => (
        <div className="listed" key={index}>
          <div className="vector">
            {(Array.isArray(position) ? position : [0, 0, 0]).slice(0, 3).map((one, axis) => (
              <NumberOrText
                key={axis}
                {...props}
                label={`${label} ${index + 1}, ${kAxes[axis] ?? ''}`}
                element={one}
                put={(number) => with_one(index, axis, number)}
              />
            ))}
          </div>
          <IconButton
            is_small
            icon="close"
            label={`Remove position ${index + 1} of ${label}`}
            press={() => remove(index)}
          />
        </div>
      ))}
    </>
  );
}
