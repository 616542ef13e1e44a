// SPDX-License-Identifier: Apache-2.0
// Completion at the cursor, from the parameter tables.
import type { Completion, CompletionContext, CompletionResult } from '@codemirror/autocomplete';
import { rows_at } from '../tables/resolve.ts';
import type { Row, Tables } from '../tables/tables.ts';
import { document_names, first_value } from '../tables/tables.ts';
import type { JsonNode } from '../values/json.ts';
import { is_object, write_json } from '../values/json.ts';
import { member_of, path_of } from '../values/path.ts';
import { cursor_position } from './cursor_path.ts';

export function completions(
  tables: Tables,
  tree: JsonNode | null,
  text: string,
  offset: number,
): { from: number; options: Completion[] } {
  const at = cursor_position(text, offset);
  const path = path_of(at.steps);
  const options =
    at.name === null && !at.is_list
      ? names_at(tables, tree, path, at.given)
      : values_at(tables, tree, path, at.name, at.steps);
  return { from: at.word_start, options };
}

function names_at(tables: Tables, tree: JsonNode | null, path: string, given: string[]): Completion[] {
  const rows = rows_at(tables, tree, path).filter((row) => !given.includes(row.name));
  const made = rows.map((row) => name_of_row(tables, row));
  const is_known = (name: string): boolean => given.includes(name) || rows.some((row) => row.name === name);
  if (path === '')
    made.push(
      ...document_names(tables)
        .filter((name) => !is_known(name))
        .map((name) => ({ label: `"${name}"`, type: 'property' })),
    );
  if (/^components\.[^.[]+$/.test(path) && !given.includes('type'))
    made.unshift({ label: '"type"', apply: '"type": "', type: 'property', detail: 'the kind of component' });
  return made;
}

function name_of_row(tables: Tables, row: Row): Completion {
  return {
    label: `"${row.name}"`,
    apply: `"${row.name}": ${write_json(first_value(tables, row))}`,
    type: 'property',
    detail: row.unit ? `${row.kind}, ${row.unit}` : row.kind,
    info: row.doc,
  };
}

function values_at(
  tables: Tables,
  tree: JsonNode | null,
  path: string,
  name: string | null,
  steps: (string | number)[],
): Completion[] {
  const ids = Object.keys(object_at(tree, 'components'));
  const variables = Object.keys(object_at(tree, 'variables'));
  const text = (label: string, detail = ''): Completion => ({ label: `"${label}"`, type: 'text', detail });
  if (name === 'type' && steps[0] === 'components')
    return Object.keys(tables.components).map((type) => ({ ...text(type), info: tables.components[type]?.doc ?? '' }));
  if (steps[0] === 'links' && (name === 'from' || name === 'to' || (name === null && steps.length === 2)))
    return ids.map((id) => text(id));
  if (name === null) return [];
  const row = rows_at(tables, tree, path).find((one) => one.name === name);
  if (!row) return [];
  if (row.choices) return row.choices.map((choice) => text(choice));
  if (row.kind === 'boolean') return ['true', 'false'].map((label) => ({ label, type: 'keyword' }));
  if (row.kind === 'number' || row.kind === 'integer') return variables.map((variable) => text(variable, 'variable'));
  return [];
}

function object_at(tree: JsonNode | null, name: string): object {
  const value = member_of(tree?.value, name);
  return is_object(value) ? value : {};
}

/// Returns the completion source for the editor.
export function completion_source(
  tables: Tables,
  tree: () => JsonNode | null,
): (context: CompletionContext) => CompletionResult | null {
  return (context) => {
    const word = context.matchBefore(/"?[\w-]*/);
    if (!context.explicit && (!word || word.from === word.to)) return null;
    const { from, options } = completions(tables, tree(), context.state.doc.toString(), context.pos);
    return options.length > 0 ? { from, options, validFor: /^"?[\w-]*$/ } : null;
  };
}
