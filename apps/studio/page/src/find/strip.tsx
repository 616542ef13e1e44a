// SPDX-License-Identifier: Apache-2.0
// Small plants side by side, one for each of a few values of a row, which show the effect of the row.
import type { ReactElement } from 'react';
import { use_page } from '../page/use_page.ts';
import { dragged_values } from '../time/values_now.ts';
import type { Json } from '../values/json.ts';
import { StillPicture } from './still_picture.tsx';
import type { StripState } from './strip_states.ts';
import { use_stills } from './use_stills.ts';

interface StripProps {
  label: string;
  path: string;
  value: Json | undefined; // the present value
  states: StripState[];
  take: (value: Json) => void;
}

const kPixels = 80;

export function Strip({ label, path, value, states, take }: StripProps): ReactElement {
  const page = use_page();
  const pixels = kPixels * Math.min(2, Math.ceil(window.devicePixelRatio));
  const { stills, is_working, fault } = use_stills(
    states.map((one) => dragged_values(page, { [path]: one.value })),
    { width: pixels, height: pixels },
  );
  return (
    <div className="strip" role="group" aria-label={`Plants over ${label}`} aria-busy={is_working}>
      {states.map((state, k) => (
        <button
          key={k}
          type="button"
          aria-pressed={JSON.stringify(state.value) === JSON.stringify(value)}
          aria-label={`${label} ${state.text}`}
          data-tip={state.tip}
          onClick={() => take(state.value)}
        >
          <StillPicture still={stills[k]} is_working={is_working} />
          <span>{state.text}</span>
        </button>
      ))}
      {fault !== '' && <p className="fault-line">{fault}</p>}
    </div>
  );
}
