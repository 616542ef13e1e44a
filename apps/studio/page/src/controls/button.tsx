// SPDX-License-Identifier: Apache-2.0
import type { ReactElement, ReactNode } from 'react';

import type { IconName } from './icon.tsx';
import { Icon } from './icon.tsx';

interface IconButtonProps {
  icon: IconName;
  label: string; // name of the action; also its tooltip
  keys?: string; // shortcut, shown in the tooltip
  is_on?: boolean; // state of a switch
  is_off?: boolean; // true: cannot be used now
  is_small?: boolean;
  press: () => void;
}

export function IconButton({ icon, label, keys, is_on, is_off, is_small, press }: IconButtonProps): ReactElement {
  return (
    <button
      type="button"
      className={`icon-button${is_small ? ' small' : ''}${is_on ? ' on' : ''}`}
      aria-label={label}
      aria-pressed={is_on}
      aria-keyshortcuts={keys?.replace('Ctrl', 'Control')}
      data-tip={keys ? `${label}  ${keys}` : label}
      disabled={is_off}
      onClick={press}
    >
      <Icon name={icon} />
    </button>
  );
}

interface ButtonProps {
  kind?: 'plain' | 'main' | 'quiet';
  icon?: IconName;
  tip?: string;
  is_off?: boolean;
  is_open?: boolean; // whether the part that it controls is open
  press: () => void;
  children: ReactNode;
}

export function Button({ kind = 'plain', icon, tip, is_off, is_open, press, children }: ButtonProps): ReactElement {
  return (
    <button
      type="button"
      className={`button ${kind}`}
      data-tip={tip}
      disabled={is_off}
      aria-expanded={is_open}
      onClick={press}
    >
      {icon && <Icon name={icon} />}
      {children}
    </button>
  );
}

interface SegmentsProps<T extends string> {
  label: string;
  value: T;
  choices: readonly (readonly [T, string])[];
  choose: (value: T) => void;
}

/// A choice of one of a few values, all of them visible.
export function Segments<T extends string>({ label, value, choices, choose }: SegmentsProps<T>): ReactElement {
  return (
    <div className="segments" role="group" aria-label={label}>
      {choices.map(([name, text]) => (
        <button key={name} type="button" aria-pressed={name === value} onClick={() => choose(name)}>
          {text}
        </button>
      ))}
    </div>
  );
}
