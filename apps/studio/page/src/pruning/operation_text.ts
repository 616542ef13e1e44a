// SPDX-License-Identifier: Apache-2.0
// Operations of a document as text, and sorted by the years in which they have acted.

import type { OperationAct } from '../server/protocol.ts';
import type { Json } from '../values/json.ts';
import { is_object, write_json } from '../values/json.ts';

/// Members that all kinds of operations have: when they act, and on which trees and shoots.
const kCommon: ReadonlySet<string> = new Set([
  'do',
  'at',
  'from',
  'every',
  'to',
  'when',
  'once',
  'season',
  'shoots',
  'tree',
  'off',
]);

function members_of(operation: Json): { [name: string]: Json } {
  return is_object(operation) ? operation : {};
}

/// Returns a value in a few words: the kind of a body, the number of points of a line.
function plain(value: Json): string {
  if (typeof value === 'string') return value;
  if (is_object(value)) return Object.keys(value).join(' and ').replaceAll('_', ' ');
  if (Array.isArray(value) && value.every(Array.isArray)) return `of ${value.length} points`;
  return write_json(value);
}

/// Returns what an operation does to which shoots: "cut main.4.2, above 3".
export function what_of(operation: Json): string {
  const said = members_of(operation);
  const shoots = typeof said['shoots'] === 'string' ? ` ${said['shoots']}` : '';
  const rest = Object.entries(said)
    .filter(([name]) => !kCommon.has(name))
    .map(([name, value]) => `, ${name.replaceAll('_', ' ')} ${plain(value)}`);
  return `${plain(said['do'] ?? 'operation')}${shoots}${rest.join('')}`;
}

/// Returns when an operation acts: "year 8, summer".
export function when_of(operation: Json): string {
  const { at, from, every, to, when, once, season, tree } = members_of(operation) as Record<string, Json | undefined>;
  const parts: string[] = [];
  if (at !== undefined) parts.push(`year ${plain(at)}`);
  else if (from === undefined && to === undefined)
    parts.push(every === undefined ? 'every year' : `every ${plain(every)} years`);
  else {
    const years = to === undefined ? `from year ${plain(from ?? 1)}` : `years ${plain(from ?? 1)} to ${plain(to)}`;
    parts.push(every === undefined ? years : `${years}, every ${plain(every)}`);
  }
  if (when !== undefined) parts.push(`when ${plain(when)}`);
  if (once === true) parts.push('once');
  if (season === 'summer') parts.push('summer');
  if (tree !== undefined) parts.push(`tree ${plain(tree)}`);
  return parts.join(', ');
}

export function is_off(operation: Json): boolean {
  return members_of(operation)['off'] === true;
}

/// Returns how often an operation acted, as text: "2 cuts".
export function counted_act(count: number, act: string): string {
  const [one, many] = kActs[act] ?? [act, act];
  return `${count} ${count === 1 ? one : many}`;
}

const kActs: Record<string, [string, string]> = {
  cut: ['cut', 'cuts'],
  disbud: ['bud off', 'buds off'],
  bend: ['bend', 'bends'],
  tie: ['tie', 'ties'],
  ring: ['ring', 'rings'],
  mark: ['mark', 'marks'],
};

/// Returns how often an operation has acted in total.
export function times_of(acts: readonly OperationAct[], path: string): number {
  return acts.reduce((sum, [operation, , , count]) => sum + (operation === path ? count : 0), 0);
}

/// Returns the index of the operation at a path within the list at another path. Returns -1 if it is not in that list.
export function index_in(list: string, path: string): number {
  return path.startsWith(`${list}[`) ? Number(path.slice(list.length + 1, -1)) : -1;
}

export interface PlanYear {
  year: number;
  seasons: { season: 'summer' | 'winter'; entries: { path: string; act: string; count: number }[] }[];
}

/// Returns the acts year by year, summers before winters, in the order of the document's list. Acts of a training come
/// first.
export function years_of(acts: readonly OperationAct[], operations: readonly Json[], list: string): PlanYear[] {
  const season_of = (path: string): 'summer' | 'winter' =>
    members_of(operations[index_in(list, path)] ?? null)['season'] === 'summer' ? 'summer' : 'winter';
  const years = [...new Set(acts.map(([, year]) => year))].sort((a, b) => a - b);
  return years.map((year) => {
    const entries = acts
      .filter(([, one]) => one === year)
      .map(([path, , act, count]) => ({ path, act, count }))
      .sort((a, b) => index_in(list, a.path) - index_in(list, b.path));
    const seasons = (['summer', 'winter'] as const).map((season) => ({
      season,
      entries: entries.filter(({ path }) => season_of(path) === season),
    }));
    return { year, seasons: seasons.filter((one) => one.entries.length > 0) };
  });
}

/// Returns the text of a document in which one operation is off, for comparison. `start` is the beginning of the
/// operation's object.
export function text_with_off(text: string, start: number, is_empty: boolean): string {
  return `${text.slice(0, start + 1)}"off": true${is_empty ? '' : ', '}${text.slice(start + 1)}`;
}
