// SPDX-License-Identifier: Apache-2.0
import type { ReactElement } from 'react';
import { fault_text } from '../controls/faults.tsx';
import { Icon } from '../controls/icon.tsx';
import type { Still } from '../server/protocol.ts';

/// A small picture of a plant, or the fault that prevents its growth.
export function StillPicture({ still, is_working }: { still: Still | undefined; is_working: boolean }): ReactElement {
  const fault = still?.faults?.[0];
  if (still?.picture !== undefined)
    return <img className={`still${is_working ? ' old' : ''}`} src={`data:image/png;base64,${still.picture}`} alt="" />;
  return (
    <span className={`still none${is_working ? ' waits' : ''}`} data-tip={fault ? fault_text(fault) : undefined}>
      {fault && <Icon name="fault" />}
    </span>
  );
}
