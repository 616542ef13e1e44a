// SPDX-License-Identifier: Apache-2.0
// Document paths as the library writes them: "components.leaf.length", "links[1].density", "links[]".
import type { Json, JsonNode } from './json.ts';
import { is_object } from './json.ts';

export type PathStep = string | number;

/// Returns the steps of a path. Names with special characters are in quotes: profiles["22.5"]. "links[]" ends in -1.
export function steps_of(path: string): PathStep[] {
  const steps: PathStep[] = [];
  for (const found of path.matchAll(/\[(\d*)\]|\["((?:[^"\\]|\\.)*)"\]|([^.[\]]+)/g)) {
    if (found[3] !== undefined) steps.push(found[3]);
    else if (found[2] !== undefined) steps.push(JSON.parse(`"${found[2]}"`) as string);
    else steps.push(found[1] === '' ? -1 : Number(found[1]));
  }
  return steps;
}

/// Returns the path of a member or an element below a path.
export function path_below(path: string, step: PathStep): string {
  if (typeof step === 'number') return `${path}[${step < 0 ? '' : step}]`;
  if (/[.[\]"]/.test(step) || step === '') return `${path}[${JSON.stringify(step)}]`;
  return path === '' ? step : `${path}.${step}`;
}

export function path_of(steps: PathStep[]): string {
  return steps.reduce<string>(path_below, '');
}

/// Returns the node at the end of a path.
export function node_at(root: JsonNode | null, path: string): JsonNode | null {
  let node = root;
  for (const step of steps_of(path)) {
    if (!node) return null;
    if (typeof step === 'number') node = node.elements?.[step] ?? null;
    else node = node.members?.find((member) => member.name === step)?.node ?? null;
  }
  return node;
}

export function value_at(root: JsonNode | null, path: string): Json | undefined {
  return node_at(root, path)?.value;
}

export function member_of(value: Json | undefined, name: string): Json | undefined {
  return is_object(value) ? value[name] : undefined;
}

/// Returns the path of the innermost value, or member, around an offset.
export function path_at(root: JsonNode, offset: number): string {
  const steps: PathStep[] = [];
  let node: JsonNode | undefined = root;
  while (node) {
    const here: JsonNode = node;
    node = undefined;
    const member = here.members?.find((one) => one.name_start <= offset && offset <= one.node.end);
    if (member) {
      steps.push(member.name);
      node = member.node;
    }
    const index = here.elements?.findIndex((one) => one.start <= offset && offset <= one.end) ?? -1;
    if (index >= 0) {
      steps.push(index);
      node = here.elements?.[index];
    }
  }
  return path_of(steps);
}
