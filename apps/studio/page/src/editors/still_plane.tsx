// SPDX-License-Identifier: Apache-2.0
// Lines and points of a plane that the user cannot move, for example from files.
import type { ReactElement } from 'react';
import { PlaneCanvas } from './plane_canvas.tsx';
import type { PlaneLine } from './plane_lines.tsx';
import { frame_of, with_room_for } from './shape.ts';
import { kPlaneSizes } from './sizes.ts';

interface StillPlaneProps {
  label: string;
  names: readonly [string, string];
  lines: readonly PlaneLine[];
  is_even: boolean; // true: both directions have one scale
}

const nothing = (): void => undefined;

export function StillPlane({ label, names, lines, is_even }: StillPlaneProps): ReactElement {
  const all = lines.flatMap((line) => line.points);
  const frame = with_room_for(frame_of({ points: all, joining: 'linear', form: 'line' }), all);
  return (
    <div className="curve-editor of-large">
      <PlaneCanvas
        label={label}
        point_label={label}
        names={names}
        points={[]}
        lines={lines}
        frame={frame}
        is_even={is_even}
        size={kPlaneSizes.large}
        is_numbered
        snaps={false}
        digits={1}
        chosen={0}
        choose={nothing}
        drag={nothing}
        commit={nothing}
        cancel={nothing}
        add_after={nothing}
        remove={nothing}
      />
    </div>
  );
}
