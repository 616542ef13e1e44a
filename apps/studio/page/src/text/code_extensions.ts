// SPDX-License-Identifier: Apache-2.0
// What all editors of code have, whatever its language: lines, faults, search, brackets, and the keys of all of these.
import { closeBrackets, closeBracketsKeymap } from '@codemirror/autocomplete';
import { defaultKeymap, indentWithTab } from '@codemirror/commands';
import { bracketMatching } from '@codemirror/language';
import { lintGutter, lintKeymap } from '@codemirror/lint';
import { highlightSelectionMatches, search, searchKeymap } from '@codemirror/search';
import { EditorState, type Extension } from '@codemirror/state';
import { drawSelection, EditorView, highlightActiveLine, keymap, lineNumbers } from '@codemirror/view';

/// `label` is what the editor is called where it is read aloud.
export function code_extensions(label: string): Extension {
  return [
    // Only \n ends a line here, so that \r\n comes back as it was; see with_line_ends.
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
