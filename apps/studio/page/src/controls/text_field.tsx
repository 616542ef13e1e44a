// SPDX-License-Identifier: Apache-2.0
// A field for a text. Enter or leaving it applies the text, Escape restores it.
import type { KeyboardEvent, ReactElement } from 'react';
import { useState } from 'react';

import { class_names } from '../base/class_names.ts';

interface TextFieldProps {
  label: string;
  value: string;
  commit: (text: string) => void;
  is_code?: boolean;
  is_faulty?: boolean;
  is_dim?: boolean;
  lines?: number; // more than one: a field of several lines, applied by Ctrl-Enter
  description?: string;
  placeholder?: string;
}

export function TextField(props: TextFieldProps): ReactElement {
  const { label, value, lines = 1 } = props;
  const [typed, set_typed] = useState<string | null>(null);
  const finish = (): void => {
    set_typed(null);
    if (typed !== null && typed !== value) props.commit(typed);
  };
  const key = (event: KeyboardEvent): void => {
    if (event.key === 'Escape' && typed !== null) {
      set_typed(null);
      event.stopPropagation();
    } else if (event.key === 'Enter' && (lines === 1 || event.ctrlKey || event.metaKey)) {
      event.preventDefault();
      finish();
    }
  };
  const common = {
    className: class_names('text-field', props.is_code && 'code', props.is_faulty && 'faulty', props.is_dim && 'dim'),
    'aria-label': label,
    'aria-invalid': props.is_faulty || undefined,
    'aria-description': props.description,
    placeholder: props.placeholder,
    spellCheck: false,
    autoComplete: 'off',
    'data-typed': typed !== null || undefined,
    value: typed ?? value,
    onBlur: finish,
    onKeyDown: key,
  };
  if (lines > 1) return <textarea {...common} rows={lines} onChange={(event) => set_typed(event.target.value)} />;
  return <input type="text" {...common} onChange={(event) => set_typed(event.target.value)} />;
}
