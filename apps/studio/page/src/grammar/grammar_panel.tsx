// SPDX-License-Identifier: Apache-2.0
// The panel of a component's grammar with its faults, and below it the derivation, step by step.
import type { ReactElement } from 'react';
import { useEffect, useRef, useState } from 'react';

import { use_store } from '../base/store.ts';
import { Button } from '../controls/button.tsx';
import { fault_text } from '../controls/faults.tsx';
import { Icon } from '../controls/icon.tsx';
import { use_document, use_page } from '../page/use_page.ts';
import { path_below } from '../values/path.ts';
import type { GrammarPlace } from './derivation.ts';
import { DerivationModel, grammars_of } from './derivation.ts';
import { DerivationPart } from './derivation_part.tsx';
import { GrammarEditor, grammar_faults } from './grammar_editor.ts';

export function GrammarPanel(): ReactElement {
  const page = use_page();
  const { tree } = use_document();
  const chosen = use_store(page.chosen);
  const [picked, pick] = useState('');
  const places = grammars_of(tree?.value, page.tables);
  const wanted = (one: GrammarPlace): boolean => path_below('components', one.component) === chosen;
  const place = places.find(wanted) ?? places.find((one) => one.component === picked) ?? places[0];
  if (!place) {
    return (
      <section className="panel grammar-panel" aria-label="Grammar">
        <p className="empty">
          This document has no grammar. A component of the type lsystem grows by one: its text stands in the document or
          in a file.
        </p>
      </section>
    );
  }
  const choose = (component: string): void => {
    pick(component);
    page.choose(path_below('components', component));
  };
  return (
    <section className="panel grammar-panel" aria-label="Grammar">
      {places.length > 1 && (
        <select
          className="select"
          aria-label="Component whose grammar is shown"
          value={place.component}
          onChange={(event) => choose(event.target.value)}
        >
          {places.map((one) => (
            <option key={one.component}>{one.component}</option>
          ))}
        </select>
      )}
      {place.is_file ? <FileGrammar key={place.path} place={place} /> : <OwnGrammar key={place.path} place={place} />}
      <DerivationPart key={place.component} component={place.component} />
    </section>
  );
}

/// A grammar whose text is in the document.
function OwnGrammar({ place }: { place: GrammarPlace }): ReactElement {
  const page = use_page();
  use_document();
  const parent = useRef<HTMLDivElement>(null);
  const editor = useRef<GrammarEditor | null>(null);
  useEffect(() => {
    if (!parent.current) return undefined;
    const made = new GrammarEditor(parent.current, page, place.path, `Grammar of ${place.component}`);
    editor.current = made;
    return () => made.destroy();
  }, [page, place.path, place.component]);
  const faults = grammar_faults(page, place.path);
  return (
    <>
      <div className="editor" ref={parent} />
      {faults.length > 0 && (
        <ul className="fault-list" aria-label="Faults of the grammar">
          {faults.map(({ fault, offset, line, column }, index) => (
            <li key={index}>
              <button type="button" className={fault.severity} onClick={() => editor.current?.reveal(offset)}>
                <Icon name={fault.severity === 'error' ? 'fault' : 'warning'} />
                <span>
                  <b>
                    Line {line}, column {column}:{' '}
                  </b>
                  {fault_text(fault)}
                </span>
              </button>
            </li>
          ))}
        </ul>
      )}
    </>
  );
}

/// A grammar whose text is in a file is shown for reading. It can be changed once it is copied into the document.
function FileGrammar({ place }: { place: GrammarPlace }): ReactElement {
  const page = use_page();
  const { told } = use_store(page.tool(DerivationModel).state);
  const text = told?.text ?? null;
  const take = (): void => {
    const owner = path_below('components', place.component);
    void page.edit(
      [{ unset: path_below(owner, 'file') }, { set: place.path, value: (text ?? '').replace(/\n$/, '').split('\n') }],
      'Take the grammar into the document',
    );
  };
  return (
    <>
      <div className="grammar-file">
        <p className="quiet">The text of this grammar stands in a file of its own.</p>
        <Button is_off={text === null} press={take}>
          Take it into the document
        </Button>
      </div>
      <pre className="grammar-text" role="region" tabIndex={0} aria-label={`Grammar of ${place.component}, in a file`}>
        {text ?? ''}
      </pre>
    </>
  );
}
