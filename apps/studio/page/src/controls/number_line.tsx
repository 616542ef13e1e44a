// SPDX-License-Identifier: Apache-2.0
// A number within limits, with its name before it. Each typed number takes effect at once and cannot be cancelled.
import type { ReactElement } from 'react';

import { NumberField } from './number_field.tsx';

interface NumberLineProps {
  label: string;
  unit?: string;
  value: number;
  step: number;
  low: number;
  high: number;
  look?: string; // CSS class of the line
  set: (value: number) => void;
}

export function NumberLine({
  label,
  unit,
  value,
  step,
  low,
  high,
  look = 'field-line',
  set,
}: NumberLineProps): ReactElement {
  return (
    <label className={look}>
      <span>{label}</span>
      <NumberField
        label={label}
        unit={unit}
        value={value}
        step={step}
        limit={(one) => Math.min(high, Math.max(low, one))}
        drag={set}
        commit={set}
        cancel={() => undefined}
      />
    </label>
  );
}
