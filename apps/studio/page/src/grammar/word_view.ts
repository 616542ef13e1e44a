// SPDX-License-Identifier: Apache-2.0
// Shows the word of a derivation: its modules one after another, with the module under the pointer marked.
import { EditorState, StateEffect, StateField } from '@codemirror/state';
import type { DecorationSet } from '@codemirror/view';
import { Decoration, drawSelection, EditorView } from '@codemirror/view';

const kMark = StateEffect.define<{ from: number; to: number } | null>();
const kMarked = StateField.define<DecorationSet>({
  create: () => Decoration.none,
  update: (marks, transaction) => {
    for (const effect of transaction.effects) {
      if (effect.is(kMark))
        return effect.value
          ? Decoration.set([Decoration.mark({ class: 'marked-module' }).range(effect.value.from, effect.value.to)])
          : Decoration.none;
    }
    return transaction.docChanged ? Decoration.none : marks;
  },
  provide: (field) => EditorView.decorations.from(field),
});

/// Returns a module with numbers shortened to four digits.
export function short_module(module: string): string {
  return module.replace(/-?\d*\.?\d+(?:e[+-]?\d+)?/gi, (number) =>
    number.length > 6 ? String(Number(Number(number).toPrecision(4))) : number,
  );
}

/// Returns the text of a word and the beginning of each module, with one more entry for the end of the last one. Names
/// of several characters are separated by spaces.
export function module_starts(modules: readonly string[]): { text: string; starts: number[] } {
  const gap = modules.some((one) => (one.split('(')[0] ?? '').length > 1) ? ' ' : '';
  const starts: number[] = [];
  let at = 0;
  for (const one of modules) {
    starts.push(at);
    at += one.length + gap.length;
  }
  starts.push(at);
  return { text: modules.join(gap), starts };
}

/// Returns the module at an offset.
export function module_at(starts: readonly number[], offset: number): number | null {
  let [low, high] = [0, starts.length - 2];
  if (high < 0 || offset < 0 || offset >= (starts[high + 1] ?? 0)) return null;
  while (low < high) {
    const middle = Math.ceil((low + high) / 2);
    if ((starts[middle] ?? 0) <= offset) low = middle;
    else high = middle - 1;
  }
  return low;
}

export class WordView {
  private readonly view_: EditorView;
  private told_: readonly string[] = [];
  private modules_: readonly string[] = []; // modules as they are shown
  private starts_: number[] = [];

  /// Calls `point` with the module under the pointer or at the cursor, counted from the first shown one.
  constructor(parent: HTMLElement, point: (module: number | null) => void) {
    this.view_ = new EditorView({
      parent,
      state: EditorState.create({
        doc: '',
        extensions: [
          EditorState.readOnly.of(true),
          EditorView.lineWrapping,
          drawSelection(),
          kMarked,
          EditorView.contentAttributes.of({ 'aria-label': 'Word of this step', tabindex: '0' }),
          EditorView.updateListener.of((update) => {
            if (update.selectionSet && update.view.hasFocus)
              point(module_at(this.starts_, update.state.selection.main.head));
          }),
          EditorView.domEventHandlers({
            mousemove: (event, view) => {
              const at = view.posAtCoords({ x: event.clientX, y: event.clientY });
              point(at === null ? null : module_at(this.starts_, at));
            },
            mouseleave: () => point(null),
          }),
        ],
      }),
    });
  }

  destroy(): void {
    this.view_.destroy();
  }

  show(modules: readonly string[]): void {
    if (modules === this.told_) return;
    this.told_ = modules;
    this.modules_ = modules.map(short_module);
    const { text, starts } = module_starts(this.modules_);
    this.starts_ = starts;
    this.view_.dispatch({ changes: { from: 0, to: this.view_.state.doc.length, insert: text }, scrollIntoView: false });
  }

  /// Marks a module, and scrolls to it if `reveals` is true.
  mark(module: number | null, reveals: boolean): void {
    const from = module === null ? undefined : this.starts_[module];
    const size = module === null ? 0 : (this.modules_[module]?.length ?? 0);
    if (from === undefined || size === 0) {
      this.view_.dispatch({ effects: kMark.of(null) });
      return;
    }
    const effects: StateEffect<unknown>[] = [kMark.of({ from, to: from + size })];
    if (reveals) effects.push(EditorView.scrollIntoView(from, { y: 'nearest', yMargin: 24 }));
    this.view_.dispatch({ effects });
  }
}
