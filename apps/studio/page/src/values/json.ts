// SPDX-License-Identifier: Apache-2.0
// A parser of JSON with comments that records the position of every value, for the outline, the inspector and
// completion. Only the server decides what a document means.

export type Json = null | boolean | number | string | Json[] | { [name: string]: Json };

export interface JsonMember {
  name: string;
  name_start: number;
  name_end: number;
  node: JsonNode;
}

export interface JsonNode {
  start: number; // position in UTF-16 units, as in editors
  end: number;
  value: Json;
  members?: JsonMember[]; // members of an object
  elements?: JsonNode[]; // elements of a list
}

export class JsonFault extends Error {
  constructor(
    message: string,
    readonly offset: number,
  ) {
    super(message);
  }
}

const kMaxNested = 256;
const kMaxIndent = 64;
const kNumber = /-?(?:0|[1-9]\d*)(?:\.\d+)?(?:[eE][+-]?\d+)?/y;
const kText = /"(?:[^"\\\u0000-\u001f]|\\(?:["\\/bfnrt]|u[0-9a-fA-F]{4}))*"/y;
const kGap = /(?:[ \t\r\n\ufeff]|\/\/[^\n]*|\/\*[^]*?\*\/)*/y;

const kBrokenText = /"(?:[^"\\\n,}\]]|\\.)*"?/y; // ends with its line or its container
const kNoValue = /[^,\]}\n"]*/y;
const kUntilName = /[^"}\]]*/y;

class Parser {
  private at_ = 0;
  private nested_ = 0;
  private top_indent_: string | null = null; // spaces before the names at the top level

  /// If `mends`, faults of the form are skipped, so that the values around them are found.
  constructor(
    private readonly text_: string,
    private readonly mends_ = false,
  ) {}

  document(): JsonNode {
    const node = this.value();
    if (this.at_ < this.text_.length && !this.mends_) throw new JsonFault('expected the end of the document', this.at_);
    return node;
  }

  private match(pattern: RegExp): string | null {
    pattern.lastIndex = this.at_;
    const found = pattern.exec(this.text_);
    if (!found) return null;
    this.at_ = pattern.lastIndex;
    return found[0];
  }

  private skip(): void {
    this.match(kGap);
  }

  private take(sign: string): boolean {
    if (this.text_[this.at_] !== sign) return false;
    this.at_ += 1;
    this.skip();
    return true;
  }

  private expect(sign: string): void {
    if (this.text_[this.at_] !== sign && this.mends_) return;
    if (this.text_[this.at_] !== sign) throw new JsonFault(`expected '${sign}'`, this.at_);
    this.at_ += 1;
  }

  private value(): JsonNode {
    this.skip();
    const start = this.at_;
    this.nested_ += 1;
    if (this.nested_ > kMaxNested) throw new JsonFault('too deeply nested', start);
    const node = this.value_at(start);
    this.nested_ -= 1;
    this.skip();
    return node;
  }

  private value_at(start: number): JsonNode {
    const sign = this.text_[start];
    if (sign === '{') return this.object(start);
    if (sign === '[') return this.list(start);
    if (sign === '"') return { start, value: this.text(), end: this.at_ };
    for (const [word, value] of [
      ['true', true],
      ['false', false],
      ['null', null],
    ] as const) {
      if (!this.text_.startsWith(word, start)) continue;
      this.at_ += word.length;
      return { start, value, end: this.at_ };
    }
    const number = this.match(kNumber);
    if (number === null && this.mends_) {
      this.match(kNoValue);
      return { start, value: null, end: this.at_ };
    }
    if (number === null) throw new JsonFault('expected a value', start);
    return { start, value: Number(number), end: this.at_ };
  }

  private text(): string {
    const found = this.match(kText);
    if (found === null && this.mends_) return (this.match(kBrokenText) ?? '').replaceAll('"', '');
    if (found === null) throw new JsonFault('this text is not closed, or has a sign that must be escaped', this.at_);
    return JSON.parse(found) as string;
  }

  /// Returns true if a top-level name begins a line, by its indentation. A bracket before it is then missing.
  private is_at_top(): boolean {
    const indent = /(?:^|\n)([ \t]*)$/.exec(this.text_.slice(Math.max(0, this.at_ - kMaxIndent), this.at_))?.[1];
    if (this.nested_ === 1) this.top_indent_ ??= indent ?? null;
    return this.nested_ > 1 && indent !== undefined && indent !== '' && indent === this.top_indent_;
  }

  private object(start: number): JsonNode {
    const members: JsonMember[] = [];
    // The object has no prototype, because a document may name a member "__proto__".
    const value = Object.create(null) as { [name: string]: Json };
    this.expect('{');
    this.skip();
    while (this.text_[this.at_] !== '}') {
      if (members.length > 0 && !this.take(',') && !this.mends_) throw new JsonFault("expected ',' or '}'", this.at_);
      if (this.mends_) this.match(kUntilName);
      if (this.mends_ && (this.text_[this.at_] !== '"' || this.is_at_top())) break;
      const name_start = this.at_;
      if (this.text_[name_start] !== '"') throw new JsonFault('expected a name in quotes', name_start);
      const name = this.text();
      const name_end = this.at_;
      this.skip();
      this.expect(':');
      const node = this.value();
      members.push({ name, name_start, name_end, node });
      value[name] = node.value;
    }
    this.expect('}');
    return { start, end: this.at_, value, members };
  }

  private list(start: number): JsonNode {
    const elements: JsonNode[] = [];
    this.expect('[');
    this.skip();
    while (this.text_[this.at_] !== ']') {
      const before = this.at_;
      if (elements.length > 0 && !this.take(',') && !this.mends_) throw new JsonFault("expected ',' or ']'", this.at_);
      if (this.mends_ && (this.text_[this.at_] === ']' || this.is_at_top())) break; // a superfluous comma
      elements.push(this.value());
      if (this.at_ === before) break; // a missing bracket
    }
    this.expect(']');
    return { start, end: this.at_, value: elements.map((node) => node.value), elements };
  }
}

/// Parses a text. Throws a JsonFault.
export function parse_json(text: string): JsonNode {
  return new Parser(text).document();
}

/// Returns the values that can be found in a text with faults, with their positions. Throws a JsonFault if the text is
/// nested too deeply.
export function parse_broken_json(text: string): JsonNode {
  return new Parser(text, true).document();
}

/// Replaces values that have not changed by the previous objects, from the root down. Users of a part of the document
/// can then compare by identity.
export function keep_values(node: JsonNode, before: Json | undefined): void {
  const { value, members, elements } = node;
  if (members && is_object(value)) {
    const known = is_object(before) ? before : null;
    const names = known ? Object.keys(known) : [];
    for (const { name, node: member } of members) {
      keep_values(member, known?.[name]);
      value[name] = member.value;
    }
    if (
      known &&
      names.length === members.length &&
      members.every(({ name }, k) => names[k] === name && known[name] === value[name])
    )
      node.value = known;
  } else if (elements && Array.isArray(value)) {
    const known = Array.isArray(before) ? before : null;
    for (const [k, element] of elements.entries()) {
      keep_values(element, known?.[k]);
      value[k] = element.value;
    }
    if (known && known.length === value.length && value.every((one, k) => one === known[k])) node.value = known;
  }
}

export function is_object(value: Json | undefined): value is { [name: string]: Json } {
  return typeof value === 'object' && value !== null && !Array.isArray(value);
}

/// Returns a value on one line, as documents write it.
export function write_json(value: Json): string {
  if (Array.isArray(value)) return `[${value.map(write_json).join(', ')}]`;
  if (!is_object(value)) return JSON.stringify(value);
  return `{${Object.keys(value)
    .map((name) => `${JSON.stringify(name)}: ${write_json(value[name] ?? null)}`)
    .join(', ')}}`;
}
