// SPDX-License-Identifier: Apache-2.0
// Nine random plants to choose from, with random values of the unlocked handles and random seeds.
import type { ReactElement } from 'react';
import { useState } from 'react';

import { use_store } from '../base/store.ts';
import { Button } from '../controls/button.tsx';
import { Dialog } from '../controls/dialog.tsx';
import { use_document, use_page } from '../page/use_page.ts';
import type { Variable } from '../server/protocol.ts';
import type { Json } from '../values/json.ts';
import { step_of } from './handle_step.ts';
import { StillPicture } from './still_picture.tsx';
import { values_by_chance } from './strip_states.ts';
import type { StateValues } from './use_stills.ts';
import { use_stills } from './use_stills.ts';

const kSize = { width: 224, height: 168 };
const kMaxSeed = 9999;

export function ChanceDialog({ close }: { close: () => void }): ReactElement {
  const page = use_page();
  const { variables } = use_document();
  const locks = use_store(page.locks);
  const free = variables.filter((one) => !one.private && one.expression === null && !locks.has(one.name));
  const [sows, set_sows] = useState(free.length === 0);
  const [throws, set_throws] = useState(0);
  const states = use_states(free, sows, throws);
  const { stills, is_working, fault } = use_stills(states, kSize);
  const take = (state: StateValues): void => {
    void page.edit(
      Object.entries(state).map(([path, value]) => ({ set: path, value })),
      'Take one of nine',
    );
    close();
  };
  const footer = (
    <>
      <label className="check-line">
        <input type="checkbox" checked={sows} onChange={(event) => set_sows(event.target.checked)} />
        Another seed for each
      </label>
      <span className="stretch" />
      <Button icon="dice" press={() => set_throws(throws + 1)}>
        Nine others
      </Button>
    </>
  );
  const names = free.map((one) => one.name.replaceAll('_', ' ')).join(', ');
  return (
    <Dialog title="Nine by chance" width="wide" close={close} footer={footer}>
      <p className="quiet">
        {free.length === 0
          ? 'All handles are locked, so the seed alone differs.'
          : `${names} within their ranges. Locked handles stay.`}{' '}
        A click takes one, as one step.
      </p>
      <div className="nine" aria-busy={is_working}>
        {states.map((state, k) => (
          <button
            key={`${throws} ${k}`}
            type="button"
            aria-label={`Plant ${k + 1}: ${words_of(state)}`}
            data-tip={words_of(state)}
            onClick={() => take(state)}
          >
            <StillPicture still={stills[k]} is_working={is_working} />
          </button>
        ))}
      </div>
      {fault !== '' && <p className="fault-line">{fault}</p>}
    </Dialog>
  );
}

/// Returns random states, which stay equal until the user asks for new ones.
function use_states(free: Variable[], sows: boolean, throws: number): StateValues[] {
  const [kept, keep] = useState<{ key: string; states: StateValues[] }>({ key: '', states: [] });
  const key = JSON.stringify([free.map((one) => [one.name, one.min, one.max]), sows, throws]);
  if (kept.key === key) return kept.states;
  const seed = (): Record<string, Json> => (sows ? { seed: 1 + Math.floor(Math.random() * kMaxSeed) } : {});
  const states = Array.from({ length: 9 }, () => ({ ...values_by_chance(free, step_of, Math.random), ...seed() }));
  keep({ key, states });
  return states;
}

function words_of(state: StateValues): string {
  return Object.entries(state)
    .map(([name, value]) => `${name.replaceAll('_', ' ')} ${String(value)}`)
    .join('\n');
}
