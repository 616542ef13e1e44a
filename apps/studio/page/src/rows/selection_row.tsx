// SPDX-License-Identifier: Apache-2.0
// A selection of instances: a field for each number, range or condition, and one for the next.
import type { ReactElement } from 'react';

import { IconButton } from '../controls/button.tsx';
import type { RowEditorProps } from './row_editor.tsx';
import { entry_of, entry_text } from './selection_text.ts';
import { TextField } from './text_field.tsx';

export function SelectionRow({ label, value, row, actions, is_faulty }: RowEditorProps): ReactElement {
  const entries = Array.isArray(value) ? value : [];
  const remove = (index: number): void => (entries.length > 1 ? actions.commit(entries.filter((_, k) => k !== index)) : actions.unset());
  const put = (index: number) => (typed: string): void => {
    const entry = entry_of(typed);
    if (entry === null) remove(index);
    else actions.commit(entries.map((old, k) => (k === index ? entry : old)));
  };
  const add = (typed: string): void => {
    const entry = entry_of(typed);
    if (entry !== null) actions.commit([...entries, entry]);
  };
  return (
    <div className="stacked">
      {entries.map((entry, index) => (
        <div className="listed" key={index}>
          <TextField label={`${label} ${index + 1}`} value={entry_text(entry)} commit={put(index)} is_code is_faulty={is_faulty} description={row.doc} />
          <IconButton is_small icon="close" label={`Remove entry ${index + 1} of ${label}`} press={() => remove(index)} />
        </div>
      ))}
      <TextField label={`Add to ${label}`} value="" commit={add} is_code description={row.doc} placeholder="7, 3 to 5, or i % 10 == 9" />
    </div>
  );
}
