// SPDX-License-Identifier: Apache-2.0
// A row that holds a curve, a line, a polygon or a silhouette: drawn where all of its points are plain numbers, and as
// it is written.
import type { ReactElement } from 'react';
import { useState } from 'react';

import { Button } from '../controls/button.tsx';
import { WrittenRow } from '../rows/plain_rows.tsx';
import type { RowEditorProps } from '../rows/row_editor.tsx';
import { PlaneEditor } from './plane_editor.tsx';
import type { Form } from './shape.ts';
import { shape_of, with_points } from './shape.ts';

export function ShapeRow(props: RowEditorProps): ReactElement {
  const [is_written, set_written] = useState(false);
  const { row, size = 'row' } = props;
  const shown = props.value ?? row.default;
  const shape = shape_of(shown, form_of_points(row.together));
  if (!shape) return <WrittenRow {...props} />;
  const { drag, commit, cancel } = props.actions;
  return (
    <div className="stacked">
      <PlaneEditor label={props.label} shape={shape} size={size} is_dim={props.value === undefined} drag={(one) => drag(with_points(shown, one))} commit={(one) => commit(with_points(shown, one))} cancel={cancel} />
      {size === 'row' && (
        <Button kind="quiet" is_open={is_written} press={() => set_written(!is_written)}>
          {is_written ? 'Hide the text' : 'As text'}
        </Button>
      )}
      {is_written && <WrittenRow {...props} />}
    </div>
  );
}

function form_of_points(together: string | undefined): Form {
  return together === 'polygon' || together === 'silhouette' ? together : 'line';
}
