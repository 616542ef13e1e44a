// SPDX-License-Identifier: Apache-2.0
// Syntax colours of JSON with comments.
import { HighlightStyle, StreamLanguage, syntaxHighlighting } from '@codemirror/language';
import type { Extension } from '@codemirror/state';
import { tags } from '@lezer/highlight';

interface State {
  in_comment: boolean;
}

const kLanguage = StreamLanguage.define<State>({
  startState: () => ({ in_comment: false }),
  token: (stream, state) => {
    if (state.in_comment) {
      if (stream.skipTo('*/')) {
        stream.match('*/');
        state.in_comment = false;
      } else stream.skipToEnd();
      return 'comment';
    }
    if (stream.eatSpace()) return null;
    if (stream.match('//')) {
      stream.skipToEnd();
      return 'comment';
    }
    if (stream.match('/*')) {
      state.in_comment = true;
      return 'comment';
    }
    if (stream.match(/^"(?:[^"\\]|\\.)*"?/)) return stream.match(/^\s*:/, false) ? 'propertyName' : 'string';
    if (stream.match(/^-?\d[\d.eE+-]*/)) return 'number';
    if (stream.match(/^(?:true|false|null)\b/)) return 'atom';
    stream.next();
    return null;
  },
  languageData: {
    commentTokens: { line: '//', block: { open: '/*', close: '*/' } },
    closeBrackets: { brackets: ['[', '{', '"'] },
  },
  tokenTable: { propertyName: tags.propertyName },
});

const kColours = HighlightStyle.define([
  { tag: tags.propertyName, color: 'var(--code-name)' },
  { tag: tags.string, color: 'var(--code-text)' },
  { tag: tags.number, color: 'var(--code-number)' },
  { tag: tags.atom, color: 'var(--code-number)' },
  { tag: tags.comment, color: 'var(--code-comment)' },
]);

export const kDocumentLanguage: Extension = [kLanguage, syntaxHighlighting(kColours)];
