// SPDX-License-Identifier: Apache-2.0
// Computations of the page itself.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { text_hash } from '../src/document/hash.ts';
import { line_difference } from '../src/document/line_difference.ts';
import { kNothingDone, step_back, step_forward, with_step, with_typing } from '../src/document/undo_list.ts';
import { Tools } from '../src/page/tools.ts';
import { in_form } from '../src/rows/number_form.ts';
import { floats, read_packet } from '../src/server/packet.ts';
import { cursor_position } from '../src/text/cursor_path.ts';
import { with_line_ends } from '../src/text/line_ends.ts';
import { calculate, fitting_step, rounded } from '../src/values/arithmetic.ts';
import { JsonFault, keep_values, parse_json, write_json } from '../src/values/json.ts';
import { apply_patch, inverse_patch, patch_between, rebased } from '../src/values/patch.ts';
import { node_at, path_at, path_below, steps_of, value_at } from '../src/values/path.ts';
import { scale_bar } from '../src/view/scale_bar.ts';

const kText = '\ufeff// head\r\n{\r\n\t"a": {"b": [1, /* two */ 2.5e1, "x\\n"]},\r\n\t"l": [["p", "q"]]\r\n}\r\n';

test('json: reads comments, a byte order mark and CRLF, with the place of everything', () => {
  const tree = parse_json(kText);
  assert.deepEqual(JSON.parse(JSON.stringify(tree.value)), { a: { b: [1, 25, 'x\n'] }, l: [['p', 'q']] });
  const node = node_at(tree, 'a.b[1]');
  assert.equal(kText.slice(node?.start, node?.end), '2.5e1');
  assert.equal(path_at(tree, kText.indexOf('2.5e1') + 1), 'a.b[1]');
});

test('json: says where it is broken, and reads no names of prototypes', () => {
  assert.throws(
    () => parse_json('{"a": 1 "b": 2}'),
    (fault) => fault instanceof JsonFault && fault.offset === 8,
  );
  assert.throws(() => parse_json('['.repeat(1000)), JsonFault);
  assert.equal(value_at(parse_json('{}'), 'constructor'), undefined);
  assert.deepEqual(Object.keys(parse_json('{"__proto__": 1}').value as object), ['__proto__']);
});

test('json: values that an edit leaves alone stay the same ones', () => {
  const before = parse_json('{"a": {"b": [1, {"c": 2}]}, "d": [3, 4], "e": {"x": 1, "y": 2}}');
  const after = parse_json('{"a": {"b": [1, {"c": 2}]}, "d": [3, 5], "e": {"y": 2, "x": 1}}');
  const wanted = JSON.stringify(after.value);
  keep_values(after, before.value);
  assert.equal(JSON.stringify(after.value), wanted);
  assert.equal(value_at(after, 'a'), value_at(before, 'a'));
  assert.equal((after.value as { a: unknown }).a, value_at(before, 'a'));
  for (const path of ['', 'd', 'e']) assert.notEqual(value_at(after, path), value_at(before, path), path); // another order is another value
});

test('json: a line is written as documents have it', () => {
  assert.equal(write_json({ a: [1, 'x'], b: null }), '{"a": [1, "x"], "b": null}');
});

test('path: steps and back', () => {
  assert.deepEqual(steps_of('components.leaf.turns[2].at'), ['components', 'leaf', 'turns', 2, 'at']);
  assert.deepEqual(steps_of('profiles["22.5"]'), ['profiles', '22.5']);
  assert.deepEqual(steps_of('links[]'), ['links', -1]);
  assert.equal(path_below('profiles', '22.5'), 'profiles["22.5"]');
  assert.equal(path_below('links', -1), 'links[]');
});

test('patch: the inverse gives the first text back, pairs of surrogates stay whole', () => {
  for (const [before, after] of [
    ['abc', 'axc'],
    ['', 'x'],
    ['aa', 'aaa'],
    ['x🌳y', 'x🌴y'],
    [kText, kText.replace('25', '7')],
  ] as const) {
    const patch = patch_between(before, after);
    assert.equal(apply_patch(before, patch), after);
    assert.equal(apply_patch(after, inverse_patch(before, patch)), before);
    for (const { replacement } of patch) assert.doesNotThrow(() => encodeURIComponent(replacement));
  }
  assert.deepEqual(patch_between('same', 'same'), []);
  assert.throws(() => apply_patch('ab', [{ offset: 1, length: 5, replacement: '' }]), RangeError);
});

test('patch: what was typed beside an edit keeps its place', () => {
  const edit = [{ offset: 2, length: 1, replacement: 'long' }];
  assert.deepEqual(rebased(edit, [{ offset: 5, length: 0, replacement: '!' }]), [
    { offset: 8, length: 0, replacement: '!' },
  ]);
  assert.equal(rebased(edit, [{ offset: 2, length: 1, replacement: 'x' }]), null);
});

test('hash: that of the server', () => {
  assert.equal(text_hash(''), '488bdcb81aee8d83');
  assert.equal(text_hash('{"meristem": 1}'), 'a3a506818f059667');
  assert.equal(text_hash('hé \u{1f333}'), 'c1f37d5b4891e0a0');
});

test('undo: goes back and forward, and a new step forgets what was undone', () => {
  const step = (label: string) => ({ label, patch: [], inverse: [], chosen: '' });
  let state = with_step(with_step(kNothingDone, step('a')), step('b'));
  const back = step_back(state);
  assert.equal(back?.step.label, 'b');
  state = back?.state ?? state;
  assert.equal(step_forward(state)?.step.label, 'b');
  assert.equal(step_forward(with_step(state, step('c'))), null);
  assert.equal(step_back(kNothingDone), null);
});

test('undo: typing that goes on is one step, and joins no other step', () => {
  const typed = (text: string, next: string) => {
    const patch = patch_between(text, next);
    return { label: 'Type', patch, inverse: inverse_patch(text, patch), chosen: '' };
  };
  const edited = with_step(kNothingDone, { ...typed('', 'a'), label: 'Set' });
  const once = with_typing(edited, typed('a', 'ab'), 'a');
  const twice = with_typing(once, typed('ab', 'abc'), 'ab');
  assert.deepEqual(
    twice.done.map((one) => one.label),
    ['Set', 'Type'],
  );
  assert.equal(apply_patch('abc', twice.done[1]?.inverse ?? []), 'a');
});

test('tools: found by their class, and a missing one is named', () => {
  class Ruler {
    readonly length = 1;
  }
  class Compass {}
  const tools = new Tools();
  const ruler = tools.add(new Ruler());
  assert.equal(tools.find(Ruler), ruler);
  assert.throws(() => tools.find(Compass), /the page has no Compass/);
});

test('arithmetic: numbers, not expressions of the document', () => {
  for (const [text, value] of [
    ['1/4', 0.25],
    ['2*(4+0.5)', 9],
    ['-2^2', -4],
    ['.5', 0.5],
    ['1e-3', 0.001],
    ['0.1+0.2', 0.3],
    ['2^3^2', 512],
    ['1,5', 1.5],
  ] as const) {
    assert.equal(calculate(text), value, text);
  }
  for (const text of ['age', '', '2*', '(1', '1/0', 'rand()', '2 3']) assert.equal(calculate(text), null, text);
});

test('arithmetic: steps are 1, 2 or 5', () => {
  assert.equal(fitting_step(0, 1), 0.01);
  assert.equal(fitting_step(8, 160, 200), 1);
  assert.equal(rounded(0.123456, 0.01), 0.12);
});

test('number forms: what was said stays where it can', () => {
  assert.deepEqual(in_form('range', 2, 2), [2, 2]);
  assert.deepEqual(in_form('both', [1, 3], 1), { range: [1, 3], apply: 'v' });
  assert.equal(in_form('expression', { range: [1, 3], apply: 'v*2' }, 1), 'v*2');
  assert.equal(in_form('number', [1, 3], 0), 1);
  assert.equal(in_form('expression', 0.5, 0.5), '0.5');
});

test('cursor: where it stands while the text is no JSON yet', () => {
  const at = (text: string) => cursor_position(text, text.length);
  const inside = at('{"components": {"leaf": {"type": "leaf", "len');
  assert.deepEqual(inside.steps, ['components', 'leaf']);
  assert.equal(inside.name, null);
  assert.deepEqual(inside.given, ['type']);
  assert.equal(at('{"links": [["a", "b"], {"kind": "br').name, 'kind');
  assert.deepEqual(at('{"links": [["a", "b"], {"kind": "br').steps, ['links', 1]);
  assert.deepEqual(at('{"a": 1, // "b": {\n "c').given, ['a']);
});

test('line ends: typed lines end as those of the document', () => {
  assert.equal(with_line_ends('a\r\nb\n\nc', 'a\r\nc'), 'a\r\nb\r\n\r\nc');
  assert.equal(with_line_ends('a\nb', 'a'), 'a\nb');
});

test('difference: only what differs, with a line around', () => {
  const lines = line_difference('a\nb\nc\nd', 'a\nb\nx\nd');
  assert.deepEqual(
    lines.map((one) => one.sign + one.text),
    [' b', '-c', '+x', ' d'],
  );
  assert.deepEqual(line_difference('a', 'a'), []);
});

test('scale: bars of 1, 2 and 5 between 60 and 160 pixels', () => {
  for (let metres = 1e-6; metres < 100; metres *= 1.37) {
    const { pixels, text } = scale_bar(metres);
    assert.ok(pixels >= 55 && pixels <= 160, `${metres}: ${pixels}`);
    assert.match(text, /^[125]0*(\.\d+)? (mm|cm|m|km)$|^0\.0*[125] mm$/);
  }
});

test('packet: arrays lie where the head says', () => {
  const head = new TextEncoder().encode(JSON.stringify({ packet: 1, hash: '', at: [0, 2] }).padEnd(40));
  const buffer = new ArrayBuffer(8 + head.length + 8);
  const view = new DataView(buffer);
  new Uint8Array(buffer).set([77, 83, 80, 49]);
  view.setUint32(4, head.length, true);
  new Uint8Array(buffer, 8).set(head);
  view.setFloat32(8 + head.length, 1.5, true);
  assert.deepEqual([...floats(read_packet(buffer), [0, 2])], [1.5, 0]);
  assert.throws(() => read_packet(new ArrayBuffer(4)));
});

test('no source writes texts as markup, and every file begins with its licence', async () => {
  const { readdirSync } = await import('node:fs');
  for (const entry of readdirSync('src', { recursive: true, encoding: 'utf8' })) {
    if (!/\.(tsx?|css)$/.test(entry)) continue;
    const text = readFileSync(`src/${entry}`, 'utf8');
    assert.doesNotMatch(
      text,
      /innerHTML|outerHTML|dangerouslySet|insertAdjacentHTML|document\.write|\beval\(|new Function/,
      entry,
    );
    assert.match(text, /SPDX-License-Identifier: Apache-2\.0/, entry);
    assert.ok(text.split('\n').length <= 252, `${entry} is too long`);
  }
});
