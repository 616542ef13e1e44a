// SPDX-License-Identifier: Apache-2.0
// A window over the page. Escape, or a click beside it, closes it.
import type { ReactElement, ReactNode } from 'react';
import { useEffect, useId, useRef } from 'react';

import { IconButton } from './button.tsx';

interface DialogProps {
  title: string;
  width?: 'narrow' | 'wide';
  close: () => void;
  children: ReactNode;
  footer?: ReactNode;
}

export function Dialog({ title, width = 'narrow', close, children, footer }: DialogProps): ReactElement {
  const element = useRef<HTMLDialogElement>(null);
  const name = useId();
  useEffect(() => {
    const dialog = element.current;
    const before = document.activeElement;
    if (dialog && !dialog.open) dialog.showModal();
    dialog?.querySelector<HTMLElement>('.dialog-body input:not([type=checkbox])')?.focus();
    // A dialog that is removed from the page does not return the keyboard focus, so this is done here.
    return () => {
      if (before instanceof HTMLElement) before.focus();
    };
  }, []);
  return (
    <dialog
      ref={element}
      className={`dialog ${width}`}
      aria-labelledby={name}
      onCancel={(event) => {
        event.preventDefault();
        close();
      }}
      onClick={(event) => {
        if (event.target === element.current) close();
      }}
    >
      <div className="dialog-frame">
        <header>
          <h2 id={name}>{title}</h2>
          <IconButton icon="close" label="Close" press={close} />
        </header>
        <div className="dialog-body">{children}</div>
        {footer && <footer>{footer}</footer>}
      </div>
    </dialog>
  );
}
