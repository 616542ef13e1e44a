// SPDX-License-Identifier: Apache-2.0
// The queue of edits that are not made yet.
import type { Edit, Fault } from '../server/protocol.ts';
import { Refusal } from '../server/protocol.ts';
import type { WaitingEdits } from './document_state.ts';

/// Options of an edit.
export interface EditOptions {
  only_if_good?: boolean | undefined; // true: not made if the text would then have errors
  choose?: string | undefined; // path to choose after the edit
}

export interface QueuedEdit {
  edits: Edit[];
  label: string;
  options: EditOptions;
  done: ((faults: Fault[] | null) => void)[];
}

/// The answer to an edit that was dropped because another document was opened.
export const kDropped = new Refusal('Another document was opened before the edit was made', { cancelled: true })
  .reasons;

export class EditQueue {
  private readonly queue_: QueuedEdit[] = [];

  get first(): QueuedEdit | null {
    return this.queue_[0] ?? null;
  }

  /// Adds edits that form one step. If they set the same values as the last waiting edits, they replace them. Resolves
  /// to what was wrong, or null.
  add(edits: Edit[], label: string, options: EditOptions): Promise<Fault[] | null> {
    return new Promise((done) => {
      const last = this.queue_.at(-1);
      if (last && sets_the_same(last.edits, edits)) {
        last.edits = edits;
        last.done.push(done);
      } else {
        this.queue_.push({ edits, label, options, done: [done] });
      }
    });
  }

  take(): QueuedEdit | null {
    return this.queue_.shift() ?? null;
  }

  put_back(edit: QueuedEdit): void {
    this.queue_.unshift(edit);
  }

  /// Drops all edits, because another document is opened.
  drop_all(): void {
    for (const { done } of this.queue_.splice(0)) for (const tell of done) tell(kDropped);
  }

  /// Returns the edits in the form that the browser keeps.
  plain(): WaitingEdits[] {
    return this.queue_.map(({ edits, label }) => ({ edits, label }));
  }
}

function sets_the_same(a: Edit[], b: Edit[]): boolean {
  const paths = (edits: Edit[]): string => JSON.stringify(edits.map((edit) => ('set' in edit ? edit.set : null)));
  return paths(a) === paths(b) && !paths(a).includes('null');
}
