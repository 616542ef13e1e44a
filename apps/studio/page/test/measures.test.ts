// SPDX-License-Identifier: Apache-2.0
// Requests for measures, and their cancellation.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { Store } from '../src/base/store.ts';
import { MeasureModel } from '../src/measures/measure_model.ts';
import type { Page } from '../src/page/page.ts';
import { Refusal } from '../src/server/protocol.ts';

interface Asked {
  what: string;
  members: Record<string, unknown>;
  refuse: (fault: Error) => void;
}

/// Returns a model with a page that answers only when the test tells it to.
function asking(): { model: MeasureModel; asked: Asked[]; grow: (hash: string) => void; wait: () => void } {
  let due: (() => void) | null = null;
  const setTimeout = (act: () => void): number => {
    due = act;
    return 1;
  };
  Object.assign(globalThis, { window: { setTimeout } });
  const asked: Asked[] = [];
  const request = (what: string, members: Record<string, unknown> = {}): Promise<never> =>
    new Promise((_, refuse) => asked.push({ what, members, refuse }));
  const begin = (what: string, members: Record<string, unknown>): object => ({
    answer: request(what, members),
    cancel: () => void request('cancel', { of: what }).catch(() => undefined),
  });
  const growth = new Store<object>({ grown: null });
  const wait = (): void => {
    due?.();
    due = null;
  };
  const page = { growth, connection: { request, begin }, tool: () => ({ time: 0 }) } as unknown as Page;
  return {
    model: new MeasureModel(page),
    asked,
    grow: (hash) => growth.set({ grown: { hash, dragged: false } }),
    wait,
  };
}

const cancelled = (): Refusal => new Refusal('cancelled', { cancelled: true });

test('measures that were cancelled are asked for when somebody looks again, or when the plant has grown again', async () => {
  const { model, asked, grow, wait } = asking();
  const measures = (): Asked[] => asked.filter((one) => one.what === 'measures');
  const stop = model.look();
  grow('a');
  wait();
  assert.equal(measures().length, 1);
  measures()[0]?.refuse(cancelled());
  await Promise.resolve().then(() => undefined);
  model.state.merge({});
  wait();
  assert.equal(measures().length, 1, 'who has cancelled is not asked again at once');
  stop();
  model.look();
  wait();
  assert.equal(measures().length, 2);
  measures()[1]?.refuse(cancelled());
  await Promise.resolve().then(() => undefined);
  grow('a');
  wait();
  assert.equal(measures().length, 3, 'the same text has grown again');
});

test('to stop a sweep cancels nothing else', () => {
  const { model, asked } = asking();
  void model.measure_over('age', [1, 2]);
  model.stop_sweep();
  assert.deepEqual(asked.at(-1)?.members, { of: 'sweep' });
});
