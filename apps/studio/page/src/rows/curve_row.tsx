// SPDX-License-Identifier: Apache-2.0
// A row that holds a curve or an outline: drawn where all of its points are plain numbers, and as it is written.
import type { ReactElement } from 'react';
import { useState } from 'react';

import { Button } from '../controls/button.tsx';
import { CurveEditor } from './curve_editor.tsx';
import { shape_of, with_points } from './curve_shape.ts';
import { WrittenRow } from './plain_rows.tsx';
import type { RowEditorProps } from './row_editor.tsx';

export function CurveRow(props: RowEditorProps): ReactElement {
  const [is_written, set_written] = useState(false);
  const shown = props.value ?? props.row.default;
  const shape = shape_of(shown);
  if (!shape) return <WrittenRow {...props} />;
  const { drag, commit, cancel } = props.actions;
  return (
    <div className="stacked">
      <CurveEditor label={props.label} shape={shape} is_dim={props.value === undefined} drag={(one) => drag(with_points(shown, one))} commit={(one) => commit(with_points(shown, one))} cancel={cancel} />
      <Button kind="quiet" is_open={is_written} press={() => set_written(!is_written)}>
        {is_written ? 'Hide the text' : 'As text'}
      </Button>
      {is_written && <WrittenRow {...props} />}
    </div>
  );
}
