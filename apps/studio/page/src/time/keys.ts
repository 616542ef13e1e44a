// SPDX-License-Identifier: Apache-2.0
// The keys of a document's animation, and edits of them. The text uses short names such as "stem.length", like --set.
// Rows have full paths such as "components.stem.length".

import type { Edit } from '../server/protocol.ts';
import type { Json } from '../values/json.ts';
import { is_object } from '../values/json.ts';
import { member_of, path_below, path_of, steps_of } from '../values/path.ts';
import type { Key, Way } from './track.ts';
import { kWays } from './track.ts';

export interface Track {
  name: string; // name in the animation
  path: string; // path of the value in the text
  keys: Key[];
}

export interface AnimationFacts {
  length: number; // seconds
  fps: number;
}

export const kKeysPath = 'animation.keys';
const kUsual: AnimationFacts = { length: 10, fps: 25 };
const kNear = 1e-4; // two times within this many seconds count as equal
const kBetween = 0.01; // minimum distance of keys in seconds when they are dragged

export function animation_of(document: Json | undefined): AnimationFacts | null {
  const said = member_of(document, 'animation');
  if (!is_object(said)) return null;
  const number = (name: keyof AnimationFacts): number =>
    typeof said[name] === 'number' && said[name] > 0 ? said[name] : kUsual[name];
  return { length: number('length'), fps: number('fps') };
}

/// Returns the path in the text of a name in an animation or in --set.
export function path_of_name(document: Json | undefined, tops: ReadonlySet<string>, name: string): string {
  const steps = steps_of(name);
  const is_key = tops.has(String(steps[0]));
  if (steps.length > 1) return is_key ? name : `components.${name}`;
  const variables = member_of(document, 'variables');
  return is_object(variables) && name in variables ? path_below('variables', name) : name;
}

/// Returns the name in an animation of the value at a path of the text.
export function name_of_path(tops: ReadonlySet<string>, path: string): string {
  const [head, second, ...rest] = steps_of(path);
  if (head === 'variables' && second !== undefined) return String(second);
  if (head === 'components' && second !== undefined && !tops.has(String(second))) return path_of([second, ...rest]);
  return path;
}

/// Returns all parameters with keys, in the order of the text. Omits keys that are not well formed.
export function tracks_of(
  document: Json | undefined,
  tops: ReadonlySet<string>,
  keys = member_of(member_of(document, 'animation'), 'keys'),
): Track[] {
  if (!is_object(keys)) return [];
  return Object.entries(keys).flatMap(([name, said]) => {
    const read = Array.isArray(said) ? said.map(key_of) : [];
    const good = read.filter((one): one is Key => one !== null);
    return good.length === 0 || good.length < read.length
      ? []
      : [{ name, path: path_of_name(document, tops, name), keys: good }];
  });
}

function key_of(said: Json): Key | null {
  if (!Array.isArray(said) || said.length < 2 || typeof said[0] !== 'number') return null;
  const way = said[2];
  return { time: said[0], value: said[1] ?? null, way: kWays.find((one) => one === way) ?? null };
}

/// Returns the keys in the form of the text.
export function written_keys(keys: readonly Key[]): Json {
  return keys.map(({ time, value, way }) => (way === null ? [time, value] : [time, value, way]));
}

export function track_path(name: string): string {
  return path_below(kKeysPath, name);
}

/// Returns the index of the key at a time, or -1.
export function key_at(keys: readonly Key[], time: number): number {
  return keys.findIndex((one) => Math.abs(one.time - time) < kNear);
}

/// Returns the keys with this value at a time. A new key is interpolated like the key before it.
export function with_key(keys: readonly Key[], time: number, value: Json): Key[] {
  const at = key_at(keys, time);
  if (at >= 0) return keys.map((one, k) => (k === at ? { ...one, value } : one));
  const behind = keys.findIndex((one) => one.time > time);
  const index = behind < 0 ? keys.length : behind;
  const way = (keys[behind] ?? keys.at(-1))?.way ?? null;
  return [...keys.slice(0, index), { time: tidy_time(time), value, way }, ...keys.slice(index)];
}

/// Returns the keys with one key moved in time, between its neighbours and within `end`.
export function with_time(keys: readonly Key[], index: number, time: number, end: number): Key[] {
  const low = (keys[index - 1]?.time ?? -kBetween) + kBetween;
  const high = (keys[index + 1]?.time ?? end + kBetween) - kBetween;
  const at = tidy_time(Math.max(low, Math.min(high, time)));
  return keys.map((one, k) => (k === index ? { ...one, time: at } : one));
}

export function with_way(keys: readonly Key[], index: number, way: Way): Key[] {
  return keys.map((one, k) => (k === index ? { ...one, way } : one));
}

/// Sets the animation keys of a parameter. An empty list removes its keys. A document without an animation gets one.
export function keys_edits(document: Json | undefined, name: string, keys: readonly Key[]): Edit[] {
  const animation = member_of(document, 'animation');
  const all = member_of(animation, 'keys');
  if (keys.length === 0) {
    const is_last = is_object(all) && Object.keys(all).length === 1 && name in all;
    return [{ unset: is_last ? kKeysPath : track_path(name) }];
  }
  const written = written_keys(keys);
  const end = Math.max(...keys.map((one) => one.time));
  if (!is_object(animation))
    return [{ set: 'animation', value: { length: Math.max(kUsual.length, end), keys: { [name]: written } } }];
  const set: Edit = is_object(all)
    ? { set: track_path(name), value: written }
    : { set: kKeysPath, value: { [name]: written } };
  return [set];
}

/// Returns all keys of a document, with the keys of some parameters replaced, for a drag.
export function dragged_keys(
  document: Json | undefined,
  keys: Readonly<Record<string, readonly Key[]>>,
): Record<string, Json> {
  const animation = member_of(document, 'animation');
  const all = member_of(animation, 'keys');
  const written = Object.entries(keys).map(([name, one]) => [name, written_keys(one)] as const);
  const made = { ...(is_object(all) ? all : {}), ...Object.fromEntries(written) };
  return is_object(animation) ? { [kKeysPath]: made } : { animation: { length: kUsual.length, keys: made } };
}

export function tidy_time(time: number): number {
  return Math.max(0, Number(time.toFixed(3)));
}
