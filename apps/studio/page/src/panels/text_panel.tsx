// SPDX-License-Identifier: Apache-2.0
import type { ReactElement } from 'react';
import { useEffect, useRef } from 'react';
import { fault_text } from '../controls/faults.tsx';
import { Icon } from '../controls/icon.tsx';
import { use_document, use_page } from '../page/use_page.ts';
import type { Fault } from '../server/protocol.ts';
import { TextEditor } from '../text/editor.ts';
import { node_at } from '../values/path.ts';

/// The panel of the whole document as text, with its faults below.
export function TextPanel(): ReactElement {
  const page = use_page();
  const parent = useRef<HTMLDivElement>(null);
  const editor = useRef<TextEditor | null>(null);
  const { faults } = use_document();
  useEffect(() => {
    if (!parent.current) return undefined;
    const made = new TextEditor(parent.current, page);
    editor.current = made;
    const node = node_at(page.document.state.get().tree, page.chosen.get());
    if (node && page.chosen.get() !== '') made.reveal(node.start);
    return () => made.destroy();
  }, [page]);
  const go = (fault: Fault) => () => editor.current?.reveal(fault.offset ?? 0);
  return (
    <section className="panel text-panel" aria-label="Text">
      <div className="editor" ref={parent} />
      {faults.length > 0 && (
        <ul className="fault-list" aria-label="Faults">
          {faults.map((fault, index) => (
            <li key={index}>
              <button type="button" className={fault.severity} onClick={go(fault)}>
                <Icon name={fault.severity === 'error' ? 'fault' : 'warning'} />
                <span>
                  {fault.line !== null && <b>Line {fault.line}: </b>}
                  {fault_text(fault)}
                </span>
              </button>
            </li>
          ))}
        </ul>
      )}
    </section>
  );
}
