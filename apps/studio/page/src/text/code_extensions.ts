// SPDX-License-Identifier: Apache-2.0
// Parts that all code editors share: lines, faults, search, brackets, and their keys.
import { closeBrackets, closeBracketsKeymap } from '@codemirror/autocomplete';
import { defaultKeymap, indentWithTab } from '@codemirror/commands';
import { bracketMatching } from '@codemirror/language';
import { lintGutter, lintKeymap } from '@codemirror/lint';
import { highlightSelectionMatches, search, searchKeymap } from '@codemirror/search';
import { EditorState, type Extension } from '@codemirror/state';
import { drawSelection, EditorView, highlightActiveLine, keymap, lineNumbers } from '@codemirror/view';

/// `label` is the editor's name for screen readers.
export function code_extensions(label: string): Extension {
  return [
    // Only \n ends a line, so that \r\n is preserved; see with_line_ends.
    EditorState.lineSeparator.of('\n'),
    lineNumbers(),
    lintGutter(),
    drawSelection(),
    highlightActiveLine(),
    highlightSelectionMatches(),
    bracketMatching(),
    closeBrackets(),
    search({ top: true }),
    keymap.of([...closeBracketsKeymap, ...lintKeymap, ...searchKeymap, ...defaultKeymap, indentWithTab]),
    EditorView.contentAttributes.of({ 'aria-label': label, tabindex: '0' }),
  ];
}
