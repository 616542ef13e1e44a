// SPDX-License-Identifier: Apache-2.0
// Edits that the page makes in the text itself. It does so without a server, or if the text is not JSON, which the
// library cannot edit. Only setting and removing values is possible here.
import type { Edit } from '../server/protocol.ts';
import type { Json, JsonMember, JsonNode } from '../values/json.ts';
import { is_object, parse_broken_json, parse_json, write_json } from '../values/json.ts';
import type { PathStep } from '../values/path.ts';
import { node_at, path_of, steps_of } from '../values/path.ts';

/// Returns the text with the edits, or null if one of them cannot be made here.
export function text_with_edits(text: string, edits: readonly Edit[]): string | null {
  let made: string | null = text;
  for (const edit of edits) made = made === null ? null : text_with_edit(made, edit);
  return made;
}

function text_with_edit(text: string, edit: Edit): string | null {
  const tree = tree_or_nothing(text);
  if (!tree) return null;
  if ('set' in edit) return with_set(text, tree, edit.set, edit.value);
  if ('unset' in edit) return without_member(text, tree, edit.unset);
  return null;
}

function tree_or_nothing(text: string): JsonNode | null {
  for (const parse of [parse_json, parse_broken_json]) {
    try {
      return parse(text);
    } catch {
      // The other parser may find more.
    }
  }
  return null;
}

/// Returns the steps from the root. A path may begin with a variable or a component.
function whole_steps(tree: JsonNode, path: string): PathStep[] {
  const steps = steps_of(path);
  const [first] = steps;
  if (typeof first !== 'string' || tree.members?.some((member) => member.name === first)) return steps;
  return steps.length === 1 ? ['variables', first] : ['components', ...steps];
}

function with_set(text: string, tree: JsonNode, path: string, value: Json): string | null {
  const steps = whole_steps(tree, path);
  const there = node_at(tree, path_of(steps));
  // A variable with more members than its value keeps them.
  const is_number_of = steps.length === 2 && steps[0] === 'variables' && is_object(there?.value) && !is_object(value);
  const target = is_number_of ? node_at(tree, path_of([...steps, 'value'])) : there;
  if (target) return text.slice(0, target.start) + write_json(value) + text.slice(target.end);
  const name = is_number_of ? 'value' : steps.at(-1);
  const around = is_number_of ? there : node_at(tree, path_of(steps.slice(0, -1)));
  return around && typeof name === 'string' ? with_member(text, around, name, value) : null;
}

/// Returns the text with a member after the last one, on a line of its own if the last one has a line of its own.
function with_member(text: string, { start, members }: JsonNode, name: string, value: Json): string | null {
  if (!members) return null;
  const said = `${JSON.stringify(name)}: ${write_json(value)}`;
  const last = members.at(-1);
  if (!last) return `${text.slice(0, start + 1)}${said}${text.slice(start + 1)}`;
  const line = /\n[ \t]*$/.exec(text.slice(0, last.name_start))?.[0];
  return `${text.slice(0, last.node.end)},${line ?? ' '}${said}${text.slice(last.node.end)}`;
}

/// A value that does not exist needs no removal.
function without_member(text: string, tree: JsonNode, path: string): string | null {
  const steps = whole_steps(tree, path);
  const around = node_at(tree, path_of(steps.slice(0, -1)));
  if (!around?.members) return around ? null : text;
  const k = around.members.findIndex((member) => member.name === steps.at(-1));
  const [before, member, behind]: (JsonMember | undefined)[] = [
    around.members[k - 1],
    around.members[k],
    around.members[k + 1],
  ];
  if (!member) return text;
  if (behind) return text.slice(0, member.name_start) + text.slice(behind.name_start);
  return text.slice(0, before ? before.node.end : member.name_start) + text.slice(member.node.end);
}
