// SPDX-License-Identifier: Apache-2.0
// A heading that shows and hides rows.
import type { ReactElement, ReactNode } from 'react';
import { useState } from 'react';

import { Faults } from '../controls/faults.tsx';
import { Icon } from '../controls/icon.tsx';
import { use_faults } from './row_actions.ts';

interface FoldProps {
  title: string;
  tip: string;
  path: string;
  is_set: boolean;
  menu?: ReactNode;
  children: ReactNode;
}

/// A heading that shows and hides its content. `children` is called when it is opened.
export function Fold({ title, tip, path, is_set, menu, children }: FoldProps): ReactElement {
  const [is_open, set_open] = useState(false);
  const faults = use_faults(path);
  const deep = use_faults(path, true);
  return (
    <div className={`fold${is_set ? '' : ' unset'}`} data-path={path}>
      <div className="fold-head">
        <button
          type="button"
          className="fold-title"
          aria-expanded={is_open}
          data-tip={tip}
          onClick={() => set_open(!is_open)}
        >
          <Icon name={is_open ? 'down' : 'right'} />
          <span>{title}</span>
          {deep.length > 0 && <Icon name="warning" />}
          {is_set && <span className="set-dot" />}
        </button>
        {menu}
      </div>
      <Faults faults={faults} />
      {is_open && <div className="fold-body">{children}</div>}
    </div>
  );
}
