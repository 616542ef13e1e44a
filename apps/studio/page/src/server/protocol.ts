// SPDX-License-Identifier: Apache-2.0
// The messages between page and server. The types in ./types are made from the tables in apps/studio/protocol; the
// types below are parts of them.
import type { EditRequest, Fault, Refused } from './types/document.ts';
import type { Requests } from './types/messages.ts';
import type { FoundInstance, OperationEffects, ShootName, ShootRequest } from './types/shoots.ts';

export type * from './types/document.ts';
export type * from './types/export.ts';
export type * from './types/files.ts';
export type * from './types/measures.ts';
export type * from './types/messages.ts';
export type * from './types/plant.ts';
export type * from './types/shoots.ts';
export type * from './types/view.ts';

export type RequestName = keyof Requests;

/// One change of the document.
export type Edit = EditRequest['edits'][number];

/// A shoot on which operations can act.
export type FoundShoot = FoundInstance & ShootName & { course: number[]; metamers: number[]; iteration: number };

/// A step from one shoot to another along the tree.
export type ShootWay = NonNullable<ShootRequest['go']>;

/// Path of an operation, iteration after which it acted, kind of the act, and count.
export type OperationAct = OperationEffects['acts'][number];

/// The reason why the server refused a request.
export class Refusal extends Error {
  constructor(
    message: string,
    readonly facts: Omit<Refused, 'message'>,
  ) {
    super(message);
  }

  /// The faults of the text, or else the message as a fault. There is always at least one.
  get reasons(): Fault[] {
    const own: Fault = {
      severity: 'error',
      message: this.message,
      expected: '',
      nearest: '',
      path: '',
      line: null,
      column: null,
      offset: null,
      text: this.message,
    };
    return this.facts.faults?.length ? this.facts.faults : [own];
  }
}
