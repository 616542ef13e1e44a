// SPDX-License-Identifier: Apache-2.0
// A row for a curve, a line, a polygon or a silhouette. The shape is drawn if all its points are plain numbers, and
// shown as text.
import type { ReactElement } from 'react';
import { useState } from 'react';

import { Button } from '../controls/button.tsx';
import { WrittenRow } from '../rows/plain_rows.tsx';
import type { RowEditorProps } from '../rows/row_kinds.ts';
import type { Row } from '../tables/tables.ts';
import { limits_of } from './limits.ts';
import { PlaneEditor } from './plane_editor.tsx';
import type { PlaneLine } from './plane_lines.tsx';
import type { Form } from './shape.ts';
import { shape_of, with_points } from './shape.ts';
import { use_crown_cloud } from './use_crown_cloud.ts';

export function ShapeRow(props: RowEditorProps): ReactElement {
  const [is_written, set_written] = useState(false);
  const { row, size = 'row' } = props;
  const shown = props.value ?? row.default;
  const cloud = use_crown_cloud(row.in_space === 'profile' ? props.path : null);
  const shape = shape_of(shown, form_of_row(row));
  if (!shape) return <WrittenRow {...props} />;
  const { drag, commit, cancel } = props.actions;
  const behind: PlaneLine[] = cloud.length > 0 ? [{ points: cloud, kind: 'cloud' }] : [];
  return (
    <div className="stacked">
      <PlaneEditor
        label={props.label}
        shape={shape}
        size={size}
        limits={limits_of(row, shape.form)}
        behind={behind}
        is_dim={props.value === undefined}
        drag={(one) => drag(with_points(shown, one))}
        commit={(one) => commit(with_points(shown, one))}
        cancel={cancel}
      />
      {size === 'row' && (
        <Button kind="quiet" is_open={is_written} press={() => set_written(!is_written)}>
          {is_written ? 'Hide the text' : 'As text'}
        </Button>
      )}
      {is_written && <WrittenRow {...props} />}
    </div>
  );
}

function form_of_row({ together, in_space }: Row): Form {
  if (in_space === 'profile') return 'profile';
  return together === 'polygon' || together === 'silhouette' ? together : 'line';
}
