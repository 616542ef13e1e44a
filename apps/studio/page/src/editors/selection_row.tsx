// SPDX-License-Identifier: Apache-2.0
// A selection of instances: a cell for each instance, to be clicked or dragged across, and a field for each number,
// range or condition.
import type { KeyboardEvent, PointerEvent, ReactElement } from 'react';
import { useRef, useState } from 'react';

import { use_store } from '../base/store.ts';
import { IconButton } from '../controls/button.tsx';
import { TextField } from '../controls/text_field.tsx';
import { use_held } from '../controls/use_held.ts';
import { use_page } from '../page/use_page.ts';
import type { RowEditorProps } from '../rows/row_kinds.ts';
import type { Json } from '../values/json.ts';
import { steps_of } from '../values/path.ts';
import { count_named, entries_of, named_numbers } from './selection_set.ts';
import { entry_of, entry_text } from './selection_text.ts';

export function SelectionRow({
  label,
  path,
  value,
  row,
  actions,
  is_faulty,
  size = 'row',
}: RowEditorProps): ReactElement {
  const entries = Array.isArray(value) ? value : [];
  const put_all = (made: Json[]): void => (made.length > 0 ? actions.commit(made) : actions.unset());
  const remove = (index: number): void => put_all(entries.filter((_, k) => k !== index));
  const put =
    (index: number) =>
    (typed: string): void => {
      const entry = entry_of(typed);
      if (entry === null) remove(index);
      else actions.commit(entries.map((old, k) => (k === index ? entry : old)));
    };
  const add = (typed: string): void => {
    const entry = entry_of(typed);
    if (entry !== null) actions.commit([...entries, entry]);
  };
  return (
    <div className={`stacked selection of-${size}`}>
      <Cells label={label} path={path} entries={entries} max={size === 'large' ? 1200 : 120} put={put_all} />
      {entries.map((entry, index) => (
        <div className="listed" key={index}>
          <TextField
            label={`${label} ${index + 1}`}
            value={entry_text(entry)}
            commit={put(index)}
            is_code
            is_faulty={is_faulty}
            description={row.doc}
          />
          <IconButton
            is_small
            icon="close"
            label={`Remove entry ${index + 1} of ${label}`}
            press={() => remove(index)}
          />
        </div>
      ))}
      <TextField
        label={`Add to ${label}`}
        value=""
        commit={add}
        is_code
        description={row.doc}
        placeholder="7, 3 to 5, or i % 10 == 9"
      />
    </div>
  );
}

const kFewest = 12; // number of cells if the number of instances is unknown

/// A drag over cells, and the state that they get.
interface DrawnWay {
  from: number;
  to: number;
  is_in: boolean;
}

interface CellsProps {
  label: string;
  path: string;
  entries: Json[];
  max: number;
  put: (entries: Json[]) => void;
}

/// A click on a cell switches it. A drag gives all cells the state of the first one, as one step.
function Cells({ label, path, entries, max, put }: CellsProps): ReactElement {
  const { grown } = use_store(use_page().growth);
  const component = String(steps_of(path)[1] ?? '');
  // Left-out instances are not among the grown ones.
  const left_out = named_numbers(entries, max).size;
  const known = grown?.components?.[component]?.instances;
  const count = Math.min(max, Math.max(count_named(entries), known === undefined ? kFewest : known + left_out));
  const named = named_numbers(entries, count);
  const drawn = use_held<DrawnWay>();
  const [focused, set_focused] = useState(0);
  const box = useRef<HTMLDivElement>(null);
  const with_drawn = (way: DrawnWay): Set<number> => {
    const made = new Set(named);
    for (let k = Math.min(way.from, way.to); k <= Math.max(way.from, way.to); k += 1) {
      if (way.is_in) made.add(k);
      else made.delete(k);
    }
    return made;
  };
  const shown = drawn.shown ? with_drawn(drawn.shown) : named;
  const finish = (way: DrawnWay | null): void => {
    drawn.set(null);
    if (way) put(entries_of(with_drawn(way), entries, count));
  };
  const cell_of = (event: PointerEvent): number | null => {
    const found = document.elementFromPoint(event.clientX, event.clientY)?.closest<HTMLElement>('[data-cell]');
    return found && box.current?.contains(found) ? Number(found.dataset['cell']) : null;
  };
  const down = (event: PointerEvent<HTMLDivElement>): void => {
    const cell = event.button === 0 ? cell_of(event) : null;
    if (cell === null) return;
    event.currentTarget.setPointerCapture(event.pointerId);
    set_focused(cell);
    drawn.set({ from: cell, to: cell, is_in: !named.has(cell) });
  };
  const move = (event: PointerEvent): void => {
    const way = drawn.get();
    const cell = way ? cell_of(event) : null;
    if (way && cell !== null && cell !== way.to) drawn.set({ ...way, to: cell });
  };
  const key = (event: KeyboardEvent): void => {
    const step = { ArrowRight: 1, ArrowLeft: -1, Home: -focused, End: count - 1 - focused }[event.key];
    if (event.key === 'Escape' && drawn.get()) drawn.set(null);
    else if (event.key === ' ' || event.key === 'Enter')
      finish({ from: focused, to: focused, is_in: !named.has(focused) });
    else if (step !== undefined) {
      const next = Math.min(count - 1, Math.max(0, focused + step));
      set_focused(next);
      if (event.shiftKey) finish({ from: focused, to: next, is_in: named.has(focused) });
      box.current?.querySelector<HTMLElement>(`[data-cell="${next}"]`)?.focus();
    } else return;
    event.preventDefault();
    event.stopPropagation();
  };
  return (
    <div
      ref={box}
      className="cells"
      role="group"
      aria-label={`Instances of ${label}`}
      onPointerDown={down}
      onPointerMove={move}
      onPointerUp={() => finish(drawn.get())}
      onPointerCancel={() => drawn.set(null)}
      onKeyDown={key}
    >
      {Array.from({ length: count }, (_, k) => (
        <button
          key={k}
          type="button"
          className="cell"
          data-cell={k}
          tabIndex={k === Math.min(focused, count - 1) ? 0 : -1}
          aria-pressed={shown.has(k)}
          aria-label={`Instance ${k}`}
          data-tip={`Instance ${k}`}
          onFocus={() => set_focused(k)}
        >
          {k % 10 === 0 ? k : ''}
        </button>
      ))}
    </div>
  );
}
