// SPDX-License-Identifier: Apache-2.0
// Values with keys are shown and edited at the view's time. A new value at a path becomes a key if the path has keys,
// and the value in the text otherwise.

import type { Page } from '../page/page.ts';
import type { Edit } from '../server/protocol.ts';
import type { Json } from '../values/json.ts';
import type { PathStep } from '../values/path.ts';
import { steps_of } from '../values/path.ts';
import { value_within, with_value, with_values } from '../values/put_values.ts';
import type { Track } from './keys.ts';
import { dragged_keys, keys_edits, with_key } from './keys.ts';
import { TimeModel } from './time_model.ts';
import type { Key } from './track.ts';
import { value_at_time } from './track.ts';
import { keyed_path, with_dragged } from './use_keyed.ts';

export type Values = Readonly<Record<string, Json>>;

/// Values separated into values of the text and keys of tracks, by their names.
export interface PartedValues {
  plain: Record<string, Json>;
  keys: Record<string, readonly Key[]>;
}

/// A track may be at a path, below it (for an element of a vector), or above it.
export function parted(values: Values, tracks: readonly Track[], time: number): PartedValues {
  const made: PartedValues = { plain: {}, keys: {} };
  const keys_of = (track: Track): readonly Key[] => made.keys[track.name] ?? track.keys;
  const put = (track: Track, value: Json, is_part = false): void => {
    // If a vector is edited as a whole, elements whose value does not change get no new key.
    if (is_part && JSON.stringify(value) === JSON.stringify(value_at_time(keys_of(track), time))) return;
    made.keys[track.name] = with_key(keys_of(track), time, value);
  };
  for (const [path, value] of Object.entries(values)) {
    const steps = steps_of(path);
    const whole = tracks.find((one) => one.path === keyed_path(path) || one.name === path);
    const above = tracks.find((one) => is_below(steps, steps_of(one.path)));
    if (whole) put(whole, value);
    else if (above)
      put(above, with_value(value_at_time(keys_of(above), time), steps.slice(steps_of(above.path).length), value));
    else {
      made.plain[path] = value;
      for (const track of tracks) {
        const own = is_below(steps_of(track.path), steps)
          ? value_within(value, steps_of(track.path).slice(steps.length))
          : undefined;
        if (own !== undefined) put(track, own, true);
      }
    }
  }
  return made;
}

function is_below(steps: readonly PathStep[], above: readonly PathStep[]): boolean {
  return steps.length > above.length && above.every((step, k) => steps[k] === step);
}

/// Returns the value at a path as shown: of a drag, else with the values of keys at the view's time.
export function value_now(page: Page, path: string, value: Json | undefined): Json | undefined {
  const time = page.tool(TimeModel);
  const dragged = page.dragged.get();
  const steps = steps_of(path);
  const keyed = Object.fromEntries(
    time.tracks
      .filter((one) => one.path === path || is_below(steps_of(one.path), steps))
      .map((one) => [one.path, value_at_time(with_dragged(one, dragged, time.document, time.tops).keys, time.time)]),
  );
  return with_values(value, steps, { ...keyed, ...dragged });
}

/// Returns true if a part below a path has keys of its own, for example an element of a vector.
export function has_keys_below(tracks: readonly Track[], path: string): boolean {
  return tracks.some((one) => is_below(steps_of(one.path), steps_of(path)));
}

/// Grows with these values temporarily, like `drag` of the studio.
export function drag_values(page: Page, values: Values): void {
  page.drag(dragged_values(page, values));
}

/// Returns the members of a drag with these values.
export function dragged_values(page: Page, values: Values): Record<string, Json> {
  const time = page.tool(TimeModel);
  const { plain, keys } = parted(values, time.tracks, time.time);
  return Object.keys(keys).length > 0 ? { ...plain, ...dragged_keys(time.document, keys) } : plain;
}

/// Sets these values as one step, and removes excluded ones. The label "Set ..." becomes "Key ..." if only keys are
/// written.
export function set_values(page: Page, values: Values, label: string, excluded: readonly string[] = []): void {
  const time = page.tool(TimeModel);
  const { plain, keys } = parted(values, time.tracks, time.time);
  const edits: Edit[] = Object.entries(plain).map(([set, value]) => ({ set, value }));
  if (edits.length === 0) return void page.edit(edits_of_keys(page, keys), label.replace(/^Set /, 'Key '));
  give(page, [...edits, ...edits_of_keys(page, keys)], label, excluded);
}

/// Makes edits and removes excluded values, as one step.
export function give(page: Page, edits: Edit[], label: string, excluded: readonly string[]): void {
  void page.edit([...edits, ...excluded.map((path) => ({ unset: path }))], label);
  if (excluded.length > 0)
    page.notify(`Removed ${excluded.map(last_name).join(' and ')}, which cannot stand beside it`);
}

function edits_of_keys(page: Page, keys: PartedValues['keys']): Edit[] {
  return Object.entries(keys).flatMap(([name, made]) => keys_edits(page.tool(TimeModel).document, name, made));
}

function last_name(path: string): string {
  return path.slice(path.lastIndexOf('.') + 1).replaceAll('_', ' ');
}
