// SPDX-License-Identifier: Apache-2.0
// Faults of the document as lines of text.
import type { ReactElement } from 'react';

import type { Fault } from '../server/protocol.ts';
import { Icon } from './icon.tsx';

export function Faults({ faults }: { faults: Fault[] }): ReactElement | null {
  if (faults.length === 0) return null;
  return (
    <div className="faults" role="status">
      {faults.map((fault, index) => (
        <p key={index} className={`fault-line ${fault.severity}`}>
          <Icon name={fault.severity === 'error' ? 'fault' : 'warning'} />
          <span>{fault_text(fault)}</span>
        </p>
      ))}
    </div>
  );
}

export function fault_text(fault: Fault): string {
  const expected = fault.expected ? `; expected ${fault.expected}` : '';
  const nearest = fault.nearest ? `; did you mean '${fault.nearest}'?` : '';
  return `${fault.message}${expected}${nearest}`;
}
