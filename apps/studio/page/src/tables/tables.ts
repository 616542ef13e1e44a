// SPDX-License-Identifier: Apache-2.0
// The parameter tables as `meristem components --json` prints them: all that the page knows of parameters.
import type { Json } from '../document/json.ts';
import { is_object } from '../document/json.ts';
import { member_of } from '../document/path.ts';

/// The legal values of a number.
export interface NumberRange {
  min?: number;
  above?: number; // a lower end that is excluded
  max?: number;
}

export interface Row extends NumberRange {
  name: string;
  kind: string;
  doc: string;
  unit?: string;
  usual?: [number, number];
  second?: NumberRange & { usual: [number, number] }; // of the second numbers of points, if it is another range
  varies?: 'instance' | 'child';
  choices?: string[];
  names?: string[];
  count?: number;
  table?: string;
  kinds?: { key: string; doc: string; tables: Record<string, string> };
  /// What points and positions are together: line, polygon, silhouette, or apart.
  together?: string;
  /// What the row says of space: position, shift, turn, direction, radii, radius, height, width, profile.
  in_space?: string;
  required?: boolean;
  keyed?: boolean; // whether it can have keys
  default?: Json;
}

interface Meaning {
  rows: string[];
  any_of: { row: string; values?: Json[] }[];
}

export interface ParameterTable {
  doc: string;
  rows: Row[];
  shorthand?: string;
  one_of?: string[][];
  only_with?: [string, string][];
  never_with?: [string, string][];
  only_where?: Meaning[];
  without?: { rows: string[]; reason: string }[];
}

export interface Tables {
  format: number;
  components: Record<string, { doc: string; table: string; is_camera?: boolean; makes_stems?: boolean; is_whole_plant?: boolean; has_geometry?: boolean }>;
  all_components: string;
  link: string;
  links: Record<string, string>;
  document: string;
  variable: string;
  animation: string;
  limits: string;
  tables: Record<string, ParameterTable>;
}

/// Rows under a heading.
export interface RowGroup {
  title: string;
  table: ParameterTable;
  rows: Row[];
}

export function table_of(tables: Tables, name: string): ParameterTable {
  return tables.tables[name] ?? { doc: '', rows: [] };
}

function group(tables: Tables, name: string, title: string, without: ReadonlySet<string> = new Set()): RowGroup {
  const table = table_of(tables, name);
  return { title, table, rows: table.rows.filter((row) => !without.has(row.name)) };
}

/// Names at the top of documents beside the rows of the document's table, as the library has them.
const kSections = ['variables', 'components', 'links', 'animation', 'limits'];
const kLists: ReadonlySet<string> = new Set(['variables', 'components', 'links']); // their elements are chosen one by one

/// All names at the top of documents.
export function document_names(tables: Tables): string[] {
  return [...table_of(tables, tables.document).rows.map((row) => row.name), ...kSections];
}

/// Names at the top of documents of what is chosen as a whole, such as "scene".
export function document_parts(tables: Tables): string[] {
  const objects = table_of(tables, tables.document).rows.filter((row) => row.table !== undefined);
  return [...objects.map((row) => row.name), ...kSections.filter((name) => !kLists.has(name))];
}

/// The rows of a component: its type's own, and those of all.
export function component_groups(tables: Tables, type: string): RowGroup[] {
  const facts = tables.components[type];
  if (!facts) return [];
  const table = table_of(tables, facts.table);
  const without = new Set(table.without?.flatMap((rule) => rule.rows) ?? []);
  return [group(tables, facts.table, type), group(tables, tables.all_components, 'Every component', without)];
}

/// The rows of a link of this kind.
export function link_groups(tables: Tables, kind: string): RowGroup[] {
  const groups = [group(tables, tables.link, 'Link')];
  const placement = tables.links[kind];
  if (placement !== undefined) groups.push(group(tables, placement, 'Placement'));
  return groups;
}

/// The rows of a part of the document's top level, such as "scene"; of "" those that are no tables themselves.
export function document_groups(tables: Tables, part: string): RowGroup[] {
  const head = table_of(tables, tables.document);
  if (part === 'limits') return [group(tables, tables.limits, 'Limits')];
  if (part === 'animation') return [group(tables, tables.animation, 'Animation')];
  const row = head.rows.find((one) => one.name === part);
  if (row?.table !== undefined) return [group(tables, row.table, part)];
  const plain = head.rows.filter((one) => one.table === undefined && one.kinds === undefined && one.name !== 'meristem');
  return [{ title: 'Document', table: head, rows: plain }];
}

/// Whether a row means something beside the other values of its table.
export function has_meaning(table: ParameterTable, row: string, value: Json | undefined): boolean {
  const rules = table.only_where?.filter((rule) => rule.rows.includes(row)) ?? [];
  return rules.every((rule) => rule.any_of.some((giver) => gives(table, giver, value)));
}

function gives(table: ParameterTable, giver: { row: string; values?: Json[] }, value: Json | undefined): boolean {
  // A giver may lie deeper: "sun.day".
  const said = giver.row.split('.').reduce<Json | undefined>(member_of, value);
  if (!giver.values) return said !== undefined;
  const held = said ?? table.rows.find((row) => row.name === giver.row)?.default;
  return giver.values.some((one) => JSON.stringify(one) === JSON.stringify(held));
}

/// The range that a slider spans: the usual one, widened to hold the value.
export function slider_range(row: Row, value: number | null): [number, number] {
  const [low, high] = row.usual ?? [row.min ?? row.above ?? 0, row.max ?? 1];
  if (value === null || !Number.isFinite(value)) return [low, high];
  return [Math.min(low, value), Math.max(high, value)];
}

/// The least and the greatest legal number.
export function hard_range({ min, above, max }: NumberRange): { low: number; high: number } {
  const low = min ?? (above !== undefined ? above + Math.max(1e-6, Math.abs(above) * 1e-6) : -Infinity);
  return { low, high: max ?? Infinity };
}

/// The nearest number that the row allows.
export function within_hard_range(row: NumberRange, value: number): number {
  const { low, high } = hard_range(row);
  return Math.min(Math.max(value, low), high);
}

/// A value to begin with where a row is given for the first time.
export function first_value(tables: Tables, row: Row): Json {
  if (row.default !== undefined) return row.default;
  if (row.kind === 'choice') return row.choices?.[0] ?? '';
  if (row.kind === 'number' || row.kind === 'integer') return first_number(row);
  if (row.kind === 'integers') return Array.from({ length: row.count ?? 1 }, () => first_number(row));
  if (row.kind === 'object' && row.table !== undefined) return first_object(tables, row.table);
  return kFirst[row.kind] ?? '';
}

const kFirst: Record<string, Json> = {
  boolean: true,
  text: '',
  lines: [''],
  vector: [0, 0, 0],
  facing: [0, 1, 0],
  colour: '#6b8e23',
  colours: ['#6b8e23'],
  curve: { curve: [[0, 1], [1, 1]], kind: 'spline' },
  points: [[0, 0], [1, 0], [1, 1]],
  positions: [[0, 0, 0]],
  condition: 'true',
  formula: 0,
  selection: [0],
  box: [[0, 0, 0], [1, 1, 1]],
  file: '',
  list: [],
  map: {},
};

function first_number(row: Row): number {
  const [low, high] = slider_range(row, null);
  const middle = (low + high) / 2;
  return row.kind === 'integer' || row.kind === 'integers' ? Math.round(middle) : Number(middle.toPrecision(2));
}

/// An object with all that its table demands.
export function first_object(tables: Tables, name: string): Json {
  const table = table_of(tables, name);
  const made: { [name: string]: Json } = {};
  for (const row of table.rows) if (row.required) made[row.name] = first_value(tables, row);
  for (const names of table.one_of ?? []) {
    const row = table.rows.find((one) => one.name === names[0]);
    if (row && !names.some((one) => one in made)) made[row.name] = first_value(tables, row);
  }
  return made;
}

/// The members of a value that stands for an object, also where its shorthand is written.
export function as_object(table: ParameterTable, value: Json | undefined): { [name: string]: Json } {
  if (is_object(value)) return value;
  if (value === undefined || table.shorthand === undefined) return {};
  return { [table.shorthand]: value };
}
