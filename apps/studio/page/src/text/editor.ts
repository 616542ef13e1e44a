// SPDX-License-Identifier: Apache-2.0
// The editor of the whole text. It has no undo list of its own, because the document has one.
import { autocompletion, completionKeymap } from '@codemirror/autocomplete';
import { indentUnit } from '@codemirror/language';
import type { Diagnostic } from '@codemirror/lint';
import { setDiagnostics } from '@codemirror/lint';
import { Annotation, EditorState } from '@codemirror/state';
import { EditorView, keymap } from '@codemirror/view';
import { fault_text } from '../controls/faults.tsx';
import type { Page } from '../page/page.ts';
import { chosen_with } from '../tables/resolve.ts';
import { patch_between } from '../values/patch.ts';
import { node_at, path_at } from '../values/path.ts';
import { code_extensions } from './code_extensions.ts';
import { completion_source } from './completion.ts';
import { kDocumentLanguage } from './json_language.ts';
import { with_line_ends } from './line_ends.ts';

const kContext = 200; // pixels of context beside a line that is scrolled into view
const kFromDocument = Annotation.define<boolean>();

export class TextEditor {
  private readonly view_: EditorView;
  private readonly stop_: (() => void)[];
  private is_choosing_ = false; // true: chosen by the cursor, which must not move

  constructor(
    parent: HTMLElement,
    private readonly page_: Page,
  ) {
    const { state } = page_.document;
    this.view_ = new EditorView({
      parent,
      state: EditorState.create({ doc: state.get().text, extensions: this.extensions() }),
    });
    this.stop_ = [state.subscribe(() => this.follow()), page_.chosen.subscribe(() => this.show_chosen())];
    this.show_faults();
  }

  destroy(): void {
    for (const stop of this.stop_) stop();
    this.view_.destroy();
  }

  /// Shows an offset and moves the cursor there.
  reveal(offset: number): void {
    const at = Math.min(offset, this.view_.state.doc.length);
    this.view_.dispatch({
      selection: { anchor: at },
      effects: EditorView.scrollIntoView(at, { y: 'center', xMargin: kContext }),
    });
  }

  private extensions() {
    return [
      indentUnit.of('  '),
      autocompletion({ override: [completion_source(this.page_.tables, () => this.page_.document.state.get().tree)] }),
      keymap.of(completionKeymap),
      code_extensions('Text of the document'),
      kDocumentLanguage,
      EditorView.updateListener.of((update) => {
        const is_own = update.transactions.some((one) => one.annotation(kFromDocument));
        if (update.docChanged && !is_own) this.take();
        if (update.selectionSet && !is_own) this.choose_at_cursor();
      }),
    ];
  }

  private take(): void {
    const typed = this.view_.state.doc.toString();
    this.page_.document.type(with_line_ends(typed, this.page_.document.state.get().text));
  }

  private choose_at_cursor(): void {
    const { tree, text } = this.page_.document.state.get();
    if (!tree || text !== this.view_.state.doc.toString()) return;
    const found = chosen_with(this.page_.tables, path_at(tree, this.view_.state.selection.main.head));
    if (found === null || found === this.page_.chosen.get()) return;
    this.is_choosing_ = true;
    this.page_.choose(found);
    this.is_choosing_ = false;
  }

  /// Scrolls to a part that was chosen elsewhere. If it was chosen here, the cursor is already in it.
  private show_chosen(): void {
    const { tree, text } = this.page_.document.state.get();
    const node = node_at(tree, this.page_.chosen.get());
    if (
      this.is_choosing_ ||
      !node ||
      this.view_.hasFocus ||
      this.page_.chosen.get() === '' ||
      text !== this.view_.state.doc.toString()
    )
      return;
    const anchor = node.start;
    this.view_.dispatch({
      selection: { anchor },
      effects: EditorView.scrollIntoView(anchor, { y: 'center', xMargin: kContext }),
      annotations: kFromDocument.of(true),
    });
  }

  /// Called when the document has changed, here or elsewhere.
  private follow(): void {
    // Typed text that is not in the document yet stays in the editor.
    if (this.page_.document.awaits_typed) return;
    const patch = patch_between(this.view_.state.doc.toString(), this.page_.document.state.get().text);
    const changes = patch.map(({ offset, length, replacement }) => ({
      from: offset,
      to: offset + length,
      insert: replacement,
    }));
    if (changes.length > 0) this.view_.dispatch({ changes, annotations: kFromDocument.of(true) });
    this.show_faults();
  }

  private show_faults(): void {
    const { faults } = this.page_.document.state.get();
    const size = this.view_.state.doc.length;
    const marks: Diagnostic[] = faults.map((fault) => {
      const from = Math.min(fault.offset ?? 0, size);
      const word = /^(?:"(?:[^"\\\n]|\\.)*"?|[^\s,{}[\]]+)/.exec(this.view_.state.sliceDoc(from, from + 200));
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
