// SPDX-License-Identifier: Apache-2.0
// The parameter tables as `meristem components --json` prints them. The page knows parameters only from these tables.
import type { Json } from '../values/json.ts';
import { is_object } from '../values/json.ts';
import { member_of } from '../values/path.ts';

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
  second?: NumberRange & { usual: [number, number] }; // range of the second numbers of points, if it differs
  varies?: 'instance' | 'child';
  choices?: string[];
  names?: string[];
  count?: number;
  table?: string;
  kinds?: { key: string; doc: string; tables: Record<string, string> };
  /// How points and positions are joined: line, polygon, silhouette, or apart.
  together?: string;
  /// Geometric role of the row: position, shift, turn, direction, radii, radius, height, width, profile.
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
  components: Record<
    string,
    {
      doc: string;
      table: string;
      is_camera?: boolean;
      makes_stems?: boolean;
      is_whole_plant?: boolean;
      has_geometry?: boolean;
    }
  >;
  all_components: string;
  link: string;
  links: Record<string, string>;
  document: string;
  variable: string;
  animation: string;
  limits: string;
  tables: Record<string, ParameterTable>;
}

/// Rows with a heading.
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

/// Names at the top level of documents that the document's table does not have, as in the library.
const kSections = ['variables', 'components', 'links', 'animation', 'limits'];
// Their elements are chosen one by one
const kLists: ReadonlySet<string> = new Set(['variables', 'components', 'links']);

/// Returns all names at the top level of documents.
export function document_names(tables: Tables): string[] {
  return [...table_of(tables, tables.document).rows.map((row) => row.name), ...kSections];
}

/// Returns the top-level names of parts that are chosen as a whole, such as "scene".
export function document_parts(tables: Tables): string[] {
  const objects = table_of(tables, tables.document).rows.filter((row) => row.table !== undefined);
  return [...objects.map((row) => row.name), ...kSections.filter((name) => !kLists.has(name))];
}

/// Returns the rows of a component: its type's own rows, and the rows of all components.
export function component_groups(tables: Tables, type: string): RowGroup[] {
  const facts = tables.components[type];
  if (!facts) return [];
  const table = table_of(tables, facts.table);
  const without = new Set(table.without?.flatMap((rule) => rule.rows) ?? []);
  return [group(tables, facts.table, type), group(tables, tables.all_components, 'Every component', without)];
}

/// Returns the rows of a link of this kind.
export function link_groups(tables: Tables, kind: string): RowGroup[] {
  const groups = [group(tables, tables.link, 'Link')];
  const placement = tables.links[kind];
  if (placement !== undefined) groups.push(group(tables, placement, 'Placement'));
  return groups;
}

/// Returns the rows of a top-level part of the document, such as "scene". For "", returns the rows that are not tables.
export function document_groups(tables: Tables, part: string): RowGroup[] {
  const head = table_of(tables, tables.document);
  if (part === 'limits') return [group(tables, tables.limits, 'Limits')];
  if (part === 'animation') return [group(tables, tables.animation, 'Animation')];
  const row = head.rows.find((one) => one.name === part);
  if (row?.table !== undefined) return [group(tables, row.table, part)];
  const plain = head.rows.filter(
    (one) => one.table === undefined && one.kinds === undefined && one.name !== 'meristem',
  );
  return [{ title: 'Document', table: head, rows: plain }];
}

/// Returns true if a row has an effect beside the other values of its table.
export function has_meaning(table: ParameterTable, row: string, value: Json | undefined): boolean {
  const rules = table.only_where?.filter((rule) => rule.rows.includes(row)) ?? [];
  return rules.every((rule) => rule.any_of.some((giver) => gives(table, giver, value)));
}

function gives(table: ParameterTable, giver: { row: string; values?: Json[] }, value: Json | undefined): boolean {
  // A giver may be in a nested table: "sun.day".
  const said = giver.row.split('.').reduce<Json | undefined>(member_of, value);
  if (!giver.values) return said !== undefined;
  const held = said ?? table.rows.find((row) => row.name === giver.row)?.default;
  return giver.values.some((one) => JSON.stringify(one) === JSON.stringify(held));
}

/// Returns the range of a slider: the usual range, widened to include the value.
export function slider_range(row: Row, value: number | null): [number, number] {
  const [low, high] = row.usual ?? [row.min ?? row.above ?? 0, row.max ?? 1];
  if (value === null || !Number.isFinite(value)) return [low, high];
  return [Math.min(low, value), Math.max(high, value)];
}

/// Returns the minimum and maximum legal number.
export function hard_range({ min, above, max }: NumberRange): { low: number; high: number } {
  const low = min ?? (above !== undefined ? above + Math.max(1e-6, Math.abs(above) * 1e-6) : -Infinity);
  return { low, high: max ?? Infinity };
}

/// Returns the nearest number that the row allows.
export function within_hard_range(row: NumberRange, value: number): number {
  const { low, high } = hard_range(row);
  return Math.min(Math.max(value, low), high);
}

/// Returns the first value of a row that was not given before.
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
  curve: {
    curve: [
      [0, 1],
      [1, 1],
    ],
    kind: 'spline',
  },
  points: [
    [0, 0],
    [1, 0],
    [1, 1],
  ],
  positions: [[0, 0, 0]],
  condition: 'true',
  formula: 0,
  selection: [0],
  box: [
    [0, 0, 0],
    [1, 1, 1],
  ],
  file: '',
  list: [],
  map: {},
};

function first_number(row: Row): number {
  const [low, high] = slider_range(row, null);
  const middle = (low + high) / 2;
  return row.kind === 'integer' || row.kind === 'integers' ? Math.round(middle) : Number(middle.toPrecision(2));
}

/// Returns an object with everything that its table requires.
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

/// Returns the members of a value that stands for an object, including the shorthand form.
export function as_object(table: ParameterTable, value: Json | undefined): { [name: string]: Json } {
  if (is_object(value)) return value;
  if (value === undefined || table.shorthand === undefined) return {};
  return { [table.shorthand]: value };
}
