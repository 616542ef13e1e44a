// SPDX-License-Identifier: Apache-2.0
// Hints for new users, shown until they are closed.
import type { ReactElement } from 'react';

import { prefer } from '../base/preferences.ts';
import { use_store } from '../base/store.ts';
import { Button } from '../controls/button.tsx';
import { Icon } from '../controls/icon.tsx';
import { use_page } from '../page/use_page.ts';

export function Hints(): ReactElement | null {
  const page = use_page();
  const { shows_hints, kept } = use_store(page.shell);
  const chosen = use_store(page.chosen);
  if (!shows_hints || kept || chosen !== '') return null;
  const close = (): void => {
    prefer('hints', 'seen');
    page.shell.merge({ shows_hints: false });
  };
  return (
    <section className="hints" aria-label="Three things to try">
      <h2>Three things to try</h2>
      <ol>
        <li>
          <Icon name="sparkle" />
          <span>
            <b>Pull a handle</b> on the left. The plant follows while you pull.
          </span>
        </li>
        <li>
          <Icon name="leaf" />
          <span>
            <b>Click the plant,</b> or a name in the outline. The parameters are on the right.
          </span>
        </li>
        <li>
          <Icon name="models" />
          <span>
            <b>Open another plant.</b> The four squares show all that are shipped.
          </span>
        </li>
      </ol>
      <Button kind="main" press={close}>
        Start
      </Button>
    </section>
  );
}
