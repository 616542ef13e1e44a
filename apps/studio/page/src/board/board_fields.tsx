// SPDX-License-Identifier: Apache-2.0
// Fields over the board: for a component's new name, and for its note, which is a comment in the document.
import type { KeyboardEvent, ReactElement } from 'react';
import { useEffect, useRef, useState } from 'react';

import { Button } from '../controls/button.tsx';
import { use_document, use_page } from '../page/use_page.ts';
import { Board } from './board.ts';

/// Moves the keyboard focus back to the component on the board.
function return_to(id: string): void {
  requestAnimationFrame(() =>
    document
      .querySelector<HTMLElement>(`.board-canvas [data-node="${CSS.escape(id)}"]`)
      ?.focus({ preventScroll: true }),
  );
}

export function RenameField({ id }: { id: string }): ReactElement {
  const page = use_page();
  const [name, set_name] = useState(id);
  const field = useRef<HTMLInputElement>(null);
  useEffect(() => field.current?.select(), []);
  const end = (): void => {
    page.tool(Board).state.merge({ renaming: null });
    return_to(id);
  };
  const take = (): void =>
    void page
      .tool(Board)
      .actions.rename(id, name.trim())
      .then(() => return_to(name.trim()));
  const key = (event: KeyboardEvent): void => {
    event.stopPropagation();
    if (event.key === 'Enter') take();
    if (event.key === 'Escape') end();
  };
  return (
    <div className="board-field">
      <label htmlFor="board-name">Name</label>
      <input
        id="board-name"
        ref={field}
        className="text-field"
        autoFocus
        spellCheck={false}
        value={name}
        onChange={(event) => set_name(event.target.value)}
        onKeyDown={key}
      />
      <Button press={take}>Rename</Button>
      <p className="quiet">
        Links, expressions and grammars follow. Chance is drawn anew, since random numbers follow the name.
      </p>
    </div>
  );
}

export function NoteField({ id }: { id: string }): ReactElement {
  const page = use_page();
  const { notes } = use_document();
  const [text, set_text] = useState(notes[id] ?? '');
  const take = (): void =>
    void page
      .tool(Board)
      .actions.note(id, text)
      .then(() => return_to(id));
  const key = (event: KeyboardEvent): void => {
    event.stopPropagation();
    if (event.key === 'Enter' && (event.ctrlKey || event.metaKey)) take();
    if (event.key !== 'Escape') return;
    page.tool(Board).state.merge({ noting: null });
    return_to(id);
  };
  return (
    <div className="board-field">
      <label htmlFor="board-note">Note</label>
      <textarea
        id="board-note"
        className="text-field"
        autoFocus
        rows={3}
        value={text}
        onChange={(event) => set_text(event.target.value)}
        onKeyDown={key}
      />
      <Button tip="Ctrl+Enter" press={take}>
        Keep
      </Button>
      <p className="quiet">A comment of the document, at {id}.</p>
    </div>
  );
}
