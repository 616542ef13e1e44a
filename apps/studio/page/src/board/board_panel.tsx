// SPDX-License-Identifier: Apache-2.0
// The panel of the p-graph: its canvas, actions on the chosen part, and a legend of the lines.
import type { ReactElement } from 'react';

import { use_store } from '../base/store.ts';
import { use_page } from '../page/use_page.ts';
import { Board } from './board.ts';
import { BoardCanvas } from './board_canvas.tsx';
import { NoteField, RenameField } from './board_fields.tsx';
import { BoardTools } from './board_tools.tsx';
import { use_graph, use_layout } from './use_board.ts';

export function BoardPanel(): ReactElement {
  const page = use_page();
  const graph = use_graph();
  const layout = use_layout(graph);
  const { refused, renaming, noting, connecting } = use_store(page.tool(Board).state);
  return (
    <section className="board" aria-label="Board">
      <Trail />
      <BoardTools graph={graph} layout={layout} />
      {renaming !== null && <RenameField key={renaming} id={renaming} />}
      {noting !== null && <NoteField key={noting} id={noting} />}
      {connecting !== null && (
        <p className="board-word" role="status">
          Link from <b>{connecting}</b>: choose the other end with the arrow keys and Enter, or click it. Escape ends.
        </p>
      )}
      <BoardCanvas graph={graph} layout={layout} />
      {refused && (
        <p className="board-word fault" role="alert">
          {refused.reason}
        </p>
      )}
      <Legend />
    </section>
  );
}

/// The documents through which the open one was entered.
function Trail(): ReactElement | null {
  const { gardens } = use_page().tool(Board);
  const trail = use_store(gardens.trail);
  if (trail.length === 0) return null;
  return (
    <p className="crumbs board-trail">
      {trail.map(({ title }, number) => (
        <span key={number}>
          <button type="button" onClick={() => void gardens.leave(number)}>
            {title}
          </button>
          {' / '}
        </span>
      ))}
    </p>
  );
}

const kLines = [
  ['child', 'where the parent ends'],
  ['branch', 'along its stems'],
  ['leaf', 'where a recursion ends'],
  ['crown', 'in its crown'],
] as const;

function Legend(): ReactElement {
  return (
    <ul className="board-legend" aria-label="What the lines mean">
      {kLines.map(([kind, text]) => (
        <li key={kind} data-tip={`A ${kind} link: the child stands ${text}`}>
          <svg viewBox="0 0 24 8" aria-hidden="true">
            <path className={`board-line ${kind}`} d="M1 4h22" />
          </svg>
          {kind}
        </li>
      ))}
    </ul>
  );
}
