// SPDX-License-Identifier: Apache-2.0
// A film or a still that the server makes. It continues when its window is closed.
import { Store } from '../base/store.ts';
import type { Page } from '../page/page.ts';
import type { Job } from '../server/connection.ts';
import type { ExportRequest, MadeFile } from '../server/protocol.ts';
import { Refusal } from '../server/protocol.ts';

export class Recording {
  readonly made = new Store<MadeFile | null>(null);
  readonly is_busy = new Store(false);
  private job_: Job<{ file: MadeFile }> | null = null;

  /// If `takes`, the browser downloads the result at once.
  constructor(
    private readonly page_: Page,
    private readonly takes_: boolean,
  ) {}

  make(request: ExportRequest): void {
    if (this.is_busy.get()) return;
    this.is_busy.set(true);
    this.made.set(null);
    this.job_ = this.page_.connection.begin('export', request);
    this.job_.answer
      .then(({ file }) => {
        this.made.set(file);
        if (!this.takes_) return;
        this.page_.notify(`Recorded ${file.name}`);
        take_file(file);
      })
      .catch((fault: Error) => {
        const is_cancelled = fault instanceof Refusal && fault.facts.cancelled === true;
        this.page_.notify(is_cancelled ? 'Cancelled' : fault.message, !is_cancelled);
      })
      .finally(() => this.is_busy.set(false));
  }

  /// Cancels only this job; all other jobs of the server continue.
  cancel(): void {
    this.job_?.cancel();
  }
}

/// The films and the stills of the open document.
export class Recordings {
  readonly film: Recording;
  readonly still: Recording;

  constructor(page: Page) {
    this.film = new Recording(page, true);
    this.still = new Recording(page, false);
  }

  /// Resets the results for another document.
  forget(): void {
    this.still.made.set(null);
    this.film.made.set(null);
  }
}

/// Downloads a file that the server has made.
export function take_file(file: MadeFile): void {
  const link = document.createElement('a');
  link.href = file.address;
  link.download = file.name;
  link.click();
}
