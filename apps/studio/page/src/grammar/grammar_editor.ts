// SPDX-License-Identifier: Apache-2.0
// The editor of a grammar in the document. Typed text goes into the document's text at once. The editor has no undo
// list of its own, because the document has one.
import type { Diagnostic } from '@codemirror/lint';
import { setDiagnostics } from '@codemirror/lint';
import { Annotation, EditorState } from '@codemirror/state';
import { EditorView } from '@codemirror/view';
import { fault_text } from '../controls/faults.tsx';
import type { Page } from '../page/page.ts';
import type { Fault } from '../server/protocol.ts';
import { code_extensions } from '../text/code_extensions.ts';
import { patch_between } from '../values/patch.ts';
import { node_at } from '../values/path.ts';
import { kGrammarLanguage } from './grammar_language.ts';
import { offset_in_text, text_in, with_text } from './grammar_source.ts';

const kFromDocument = Annotation.define<boolean>();

/// A fault with its position in the grammar: line and column from 1, and the offset.
export interface GrammarFault {
  fault: Fault;
  offset: number;
  line: number;
  column: number;
}

/// Returns the faults of the document within the text at a path.
export function grammar_faults(page: Page, path: string): GrammarFault[] {
  const { tree, text, faults } = page.document.state.get();
  const node = node_at(tree, path);
  const grammar = text_in(node);
  if (!node || grammar === null) return [];
  return faults.flatMap((fault) => {
    if (fault.path !== path && !fault.path.startsWith(`${path}[`)) return [];
    const offset = (fault.offset === null ? null : offset_in_text(text, node, fault.offset)) ?? 0;
    const before = grammar.slice(0, offset).split('\n');
    return [{ fault, offset, line: before.length, column: (before.at(-1)?.length ?? 0) + 1 }];
  });
}

export class GrammarEditor {
  private readonly view_: EditorView;
  private readonly stop_: () => void;

  /// `path` leads to a text or a list of lines.
  constructor(
    parent: HTMLElement,
    private readonly page_: Page,
    private readonly path_: string,
    label: string,
  ) {
    this.view_ = new EditorView({
      parent,
      state: EditorState.create({ doc: this.said() ?? '', extensions: this.extensions(label) }),
    });
    this.stop_ = page_.document.state.subscribe(() => this.follow());
    this.show_faults();
  }

  destroy(): void {
    this.stop_();
    this.view_.destroy();
  }

  /// Moves the cursor to an offset and shows it.
  reveal(offset: number): void {
    const anchor = Math.min(offset, this.view_.state.doc.length);
    this.view_.dispatch({ selection: { anchor }, effects: EditorView.scrollIntoView(anchor, { y: 'center' }) });
    this.view_.focus();
  }

  private extensions(label: string) {
    return [
      code_extensions(label),
      kGrammarLanguage,
      EditorView.lineWrapping, // rules are long
      EditorView.updateListener.of((update) => {
        if (update.docChanged && !update.transactions.some((one) => one.annotation(kFromDocument))) this.take();
      }),
    ];
  }

  private said(): string | null {
    return text_in(node_at(this.page_.document.state.get().tree, this.path_));
  }

  private take(): void {
    const { tree, text } = this.page_.document.state.get();
    const node = node_at(tree, this.path_);
    if (node) this.page_.document.type(with_text(text, node, this.view_.state.doc.toString()));
  }

  /// Called when the document has changed, here or elsewhere.
  private follow(): void {
    // Typed text that is not in the document yet stays in the editor.
    if (this.page_.document.awaits_typed) return;
    const said = this.said();
    if (said === null) return;
    const patch = patch_between(this.view_.state.doc.toString(), said);
    const changes = patch.map(({ offset, length, replacement }) => ({
      from: offset,
      to: offset + length,
      insert: replacement,
    }));
    if (changes.length > 0) this.view_.dispatch({ changes, annotations: kFromDocument.of(true) });
    this.show_faults();
  }

  private show_faults(): void {
    const size = this.view_.state.doc.length;
    const marks: Diagnostic[] = grammar_faults(this.page_, this.path_).map(({ fault, offset }) => {
      const from = Math.min(offset, size);
      const word = /^(?:\w+|[^\s])/.exec(this.view_.state.sliceDoc(from, from + 100));
      return {
        from,
        to: Math.min(size, from + (word?.[0].length ?? 1)),
        severity: fault.severity,
        message: fault_text(fault),
      };
    });
    this.view_.dispatch(setDiagnostics(this.view_.state, marks), { annotations: kFromDocument.of(true) });
  }
}
