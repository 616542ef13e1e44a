// SPDX-License-Identifier: Apache-2.0
// The choice of a grass leaf, and its curves.
import { Newest } from '../base/newest.ts';
import { Store } from '../base/store.ts';
import type { Page } from '../page/page.ts';
import type { LeafCurves } from '../server/protocol.ts';

export class LeafCurvesModel {
  readonly component = new Store<string | null>(null);
  readonly told = new Store<LeafCurves | null>(null);
  private readonly newest_ = new Newest();

  constructor(private readonly page_: Page) {
    this.component.subscribe(() => this.told.set(null));
  }

  /// Resets the curves for another document.
  forget(): void {
    this.newest_.drop();
    this.component.set(null);
    this.told.set(null);
  }

  /// Requests the curves of a leaf in the last grown document. Only the newest answer counts.
  ask(component: string, rank: number | null, leaf: number | null): void {
    const counts = this.newest_.begin();
    this.page_.connection
      .request('curves', {
        component,
        ...(rank === null ? {} : { rank }),
        ...(leaf === null ? {} : { leaf }),
      })
      .then(({ curves }) => {
        if (counts() && this.component.get() === component) this.told.set(curves);
      })
      .catch(() => undefined);
  }
}
