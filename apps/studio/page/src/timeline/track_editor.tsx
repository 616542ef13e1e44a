// SPDX-License-Identifier: Apache-2.0
// A large editor for the keys of one parameter: its curve with movable points, and the time, the value and the
// interpolation of the chosen key. A gesture is one step.
import type { ReactElement } from 'react';
import { useRef } from 'react';

import { without } from '../base/lists.ts';
import { use_store } from '../base/store.ts';
import { IconButton, Segments } from '../controls/button.tsx';
import { NumberField } from '../controls/number_field.tsx';
import type { Limits } from '../editors/limits.ts';
import { with_limits } from '../editors/limits.ts';
import { focus_point, PlaneCanvas } from '../editors/plane_canvas.tsx';
import type { Frame, Point, Range } from '../editors/shape.ts';
import { use_snapping } from '../editors/snapping.ts';
import { use_document, use_page } from '../page/use_page.ts';
import { legal_value, row_of_value } from '../tables/legal.ts';
import { hard_range } from '../tables/tables.ts';
import type { Track } from '../time/keys.ts';
import { tidy_time, with_key, with_time, with_way } from '../time/keys.ts';
import { TimeModel } from '../time/time_model.ts';
import type { Key } from '../time/track.ts';
import { curve_of, has_values_between, value_at_time } from '../time/track.ts';
import { commit_keys, drag_keys, with_dragged } from '../time/use_keyed.ts';
import { fitting_step, rounded } from '../values/arithmetic.ts';
import type { Json } from '../values/json.ts';
import { KeyValue } from './key_value.tsx';

const kFree: Range = { low: -Infinity, high: Infinity };
const kSize = { wide: 720, high: 150, margin: 20 };

export function TrackEditor({ track: written }: { track: Track }): ReactElement {
  const page = use_page();
  const model = page.tool(TimeModel);
  const state = use_store(model.state);
  const dragged = use_store(page.dragged);
  const { tree } = use_document();
  const { keys, name } = with_dragged(written, dragged, model.document, model.tops);
  const index = Math.min(state.key, keys.length - 1);
  const label = name.replaceAll('_', ' ');
  const acts = {
    drag: (made: readonly Key[]) => drag_keys(page, name, made),
    commit: (made: readonly Key[], what: string) => commit_keys(page, name, made, `${what} of ${label}`),
    cancel: () => page.stop_drag(),
  };
  const choose = (which: number): void => model.choose(name, which);
  const add = (time: number, value: Json): void => {
    const made = with_key(keys, time, value);
    acts.commit(made, 'Add a key');
    choose(made.findIndex((one) => Math.abs(one.time - tidy_time(time)) < 1e-3));
  };
  const remove = (which: number): void => {
    acts.commit(without(keys, which), 'Remove a key');
    choose(Math.max(0, which - 1));
  };
  const row = row_of_value(page.tables, tree, name, keys[index]?.value ?? null);
  const legal = (value: Json): Json => (row ? legal_value(row, value) : value);
  const range = row ? hard_range(row) : kFree;
  const props = { label, keys, index, legal, range, length: model.animation.length, choose, add, remove, ...acts };
  return (
    <div className="track-editor" data-edited={name}>
      <KeyCurve {...props} />
      <KeyFields {...props} now={state.time} />
    </div>
  );
}

interface KeysProps {
  label: string;
  keys: readonly Key[];
  index: number; // index of the chosen key
  length: number; // length of the animation, seconds
  legal: (value: Json) => Json; // returns the nearest value that the row allows
  range: Range; // range of legal numbers
  choose: (which: number) => void;
  add: (time: number, value: Json) => void;
  remove: (which: number) => void;
  drag: (keys: readonly Key[]) => void;
  commit: (keys: readonly Key[], what: string) => void;
  cancel: () => void;
}

/// The curve of numeric keys; other keys have none.
function KeyCurve({
  label,
  keys,
  index,
  length,
  legal,
  range,
  choose,
  add,
  remove,
  drag,
  commit,
  cancel,
}: KeysProps): ReactElement | null {
  const root = useRef<HTMLDivElement>(null);
  const { snaps } = use_snapping();
  const end = Math.max(length, keys.at(-1)?.time ?? 0);
  const curve = curve_of(keys, end);
  if (!curve) return null;
  const points = keys.map((one): Point => [one.time, one.value as number]);
  const limits: Limits = { x: { low: 0, high: end }, y: range };
  const frame = with_limits(frame_of(points, end), limits, 'function');
  const digits = fitting_step(frame.y.low, frame.y.high, 200);
  const moved = (which: number, [time, value]: Point): Key[] =>
    with_time(keys, which, time, end).map((one, k) =>
      k === which ? { ...one, value: legal(rounded(value, digits / 10)) } : one,
    );
  const between = (which: number): number => ((keys[which]?.time ?? 0) + (keys[which + 1]?.time ?? end)) / 2;
  return (
    <div ref={root} className="curve-editor">
      <PlaneCanvas
        label={`Curve of ${label}: ${keys.length} keys`}
        point_label={label}
        names={['seconds', label]}
        points={points}
        lines={[{ points: curve, kind: 'line' }]}
        frame={frame}
        limits={limits}
        is_even={false}
        size={kSize}
        is_numbered
        snaps={snaps}
        digits={digits}
        chosen={index}
        choose={choose}
        drag={(which, point) => drag(moved(which, point))}
        commit={(which, point) => commit(moved(which, point), 'Move a key')}
        cancel={cancel}
        add={([time, value]) => add(tidy_time(Math.min(end, time)), legal(rounded(value, digits / 10)))}
        add_after={(which) => {
          add(between(which), value_at_time(keys, between(which)));
          focus_point(root.current, which + 1);
        }}
        remove={remove}
      />
    </div>
  );
}

function frame_of(points: readonly Point[], end: number): Frame {
  const values = points.map((one) => one[1]);
  const [low, high] = [Math.min(...values), Math.max(...values)];
  const room = high > low ? 0.1 * (high - low) : 0.5 * Math.max(1e-3, Math.abs(high));
  return { x: { low: 0, high: end }, y: { low: low - room, high: high + room } };
}

function KeyFields({
  label,
  keys,
  index,
  length,
  now,
  legal,
  choose,
  add,
  remove,
  drag,
  commit,
  cancel,
}: KeysProps & { now: number }): ReactElement | null {
  const key = keys[index];
  if (!key) return null;
  const end = Math.max(length, keys.at(-1)?.time ?? 0);
  const at = (time: number): Key[] => with_time(keys, index, time, end);
  const having = (value: Json): Key[] => keys.map((one, k) => (k === index ? { ...one, value } : one));
  const name = `key ${index + 1} of ${label}`;
  const can_bend = has_values_between(keys);
  return (
    <div className="key-fields">
      <IconButton
        is_small
        icon="left"
        label={`Key before, of ${label}`}
        is_off={index === 0}
        press={() => choose(index - 1)}
      />
      <IconButton
        is_small
        icon="right"
        label={`Key behind, of ${label}`}
        is_off={index + 1 >= keys.length}
        press={() => choose(index + 1)}
      />
      <NumberField
        label={`Time of ${name}`}
        value={key.time}
        step={0.04}
        unit="s"
        limit={(one) => Math.max(0, one)}
        drag={(one) => drag(at(one))}
        commit={(one) => commit(at(one), 'Move a key')}
        cancel={cancel}
      />
      <KeyValue
        label={`Value of ${name}`}
        value={key.value}
        legal={legal}
        drag={(one) => drag(having(legal(one)))}
        commit={(one) => commit(having(legal(one)), 'Set a key')}
        cancel={cancel}
      />
      {can_bend && index > 0 && (
        <Segments
          label={`Way to ${name}`}
          value={key.way ?? 'linear'}
          choices={[
            ['linear', 'Even'],
            ['smooth', 'Smooth'],
            ['step', 'Jump'],
          ]}
          choose={(way) => commit(with_way(keys, index, way), 'Join the keys')}
        />
      )}
      <IconButton
        is_small
        icon="plus"
        label={`Add a key to ${label} where the time stands`}
        press={() => add(now, value_at_time(keys, now))}
      />
      <IconButton is_small icon="close" label={`Remove the key of ${label}`} press={() => remove(index)} />
    </div>
  );
}
