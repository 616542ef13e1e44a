// SPDX-License-Identifier: Apache-2.0
// Syntax colours of grammars: directives, arrows, brackets, parameters, comments.
import { HighlightStyle, StreamLanguage, syntaxHighlighting } from '@codemirror/language';
import type { Extension } from '@codemirror/state';
import { tags } from '@lezer/highlight';

interface State {
  in_comment: boolean;
  depth: number; // depth of parentheses, within which expressions are written
}

const kLanguage = StreamLanguage.define<State>({
  startState: () => ({ in_comment: false, depth: 0 }),
  token: (stream, state) => {
    if (state.in_comment) {
      if (stream.skipTo('*/')) {
        stream.match('*/');
        state.in_comment = false;
      } else stream.skipToEnd();
      return 'comment';
    }
    if (stream.sol()) {
      state.depth = 0;
      if (stream.match(/^\s*(?:\/\/|;).*/)) return 'comment';
      if (stream.match(/^\s*#[a-z]+:?/)) return 'keyword';
    }
    if (stream.eatSpace()) return null;
    if (stream.match('/*')) {
      state.in_comment = true;
      return 'comment';
    }
    if (stream.match(/^\/\/(?=\s|$).*/)) return 'comment';
    if (stream.match(/^-{1,2}>|^→/)) return 'operator';
    if (stream.match('(')) {
      state.depth += 1;
      return null;
    }
    if (stream.match(')')) {
      state.depth = Math.max(0, state.depth - 1);
      return null;
    }
    if (stream.match(/^(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?/)) return 'number';
    if (state.depth > 0 && stream.match(/^[A-Za-z_]\w*/)) return 'variableName';
    if (stream.match(/^[[\]{}%]/)) return 'bracket';
    if (stream.match(/^[<>:]/)) return 'operator';
    if (stream.match(/^~\s*[A-Za-z_]\w*/)) return 'string';
    stream.next();
    return state.depth > 0 ? null : 'atom';
  },
  languageData: { commentTokens: { line: '//' }, closeBrackets: { brackets: ['(', '[', '{'] } },
});

const kColours = HighlightStyle.define([
  { tag: tags.keyword, color: 'var(--code-name)', fontWeight: '600' },
  { tag: tags.operator, color: 'var(--accent)', fontWeight: '600' },
  { tag: tags.bracket, color: 'var(--code-number)', fontWeight: '600' },
  { tag: tags.number, color: 'var(--code-number)' },
  { tag: tags.variableName, color: 'var(--code-name)' },
  { tag: tags.string, color: 'var(--code-text)' },
  { tag: tags.atom, color: 'var(--text)' },
  { tag: tags.comment, color: 'var(--code-comment)' },
]);

export const kGrammarLanguage: Extension = [kLanguage, syntaxHighlighting(kColours)];
