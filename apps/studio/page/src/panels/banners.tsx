// SPDX-License-Identifier: Apache-2.0
// Banners with decisions for the user: a lost server, unsaved earlier work, a file that someone else has changed.
import type { ReactElement } from 'react';
import { useState } from 'react';

import { use_store } from '../base/store.ts';
import { Button } from '../controls/button.tsx';
import { Icon } from '../controls/icon.tsx';
import { line_difference } from '../document/line_difference.ts';
import type { Page } from '../page/page.ts';
import { use_page } from '../page/use_page.ts';
import { Keeper } from '../saving/keeper.ts';
import { save_document } from '../saving/saving.ts';

export function LostBanner(): ReactElement | null {
  const page = use_page();
  const { link } = use_store(page.server);
  if (link !== 'lost') return null;
  return (
    <div className="banner warning" role="alert" data-banner="lost">
      <Icon name="warning" />
      <p>
        The server is gone. Your work is kept in this browser: start <code>meristem studio</code> again and open the
        address that it prints. What you change here until then is kept, too.
      </p>
      <Button press={() => save_copy(page)}>Download the text</Button>
    </div>
  );
}

/// Saves the text as a download of the browser, which needs no server.
function save_copy(page: Page): void {
  const { text, name } = page.document.state.get();
  const link = document.createElement('a');
  link.href = URL.createObjectURL(new Blob([text], { type: 'application/json' }));
  link.download = /\.json$/i.test(name) ? name : `${name || 'plant'}.json`;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}

/// Reports that another tab or program has the file open.
export function ElsewhereBanner(): ReactElement | null {
  const page = use_page();
  const { elsewhere } = use_store(page.shell);
  if (!elsewhere) return null;
  return (
    <div className="banner warning" role="alert" data-banner="elsewhere">
      <Icon name="warning" />
      <p>
        <strong>{elsewhere.path}</strong> is open in{' '}
        {elsewhere.count === 1 ? 'another tab or program' : `${elsewhere.count} other tabs or programs`}, too. Changes
        of one do not reach the other: save in one of them only.
      </p>
      <Button press={() => page.shell.merge({ elsewhere: null })}>Close this note</Button>
    </div>
  );
}

export function KeptBanner(): ReactElement | null {
  const page = use_page();
  const { kept } = use_store(page.shell);
  const [shows, set_shows] = useState(false);
  if (!kept) return null;
  const { work, before } = kept;
  const when = new Date(work.at).toLocaleString([], { dateStyle: 'medium', timeStyle: 'short' });
  if (before === null)
    return <OtherWork name={work.name} when={when} open={() => void page.tool(Keeper).open_other(work)} />;
  const lines = line_difference(before, work.text);
  const differing = lines.filter((one) => one.sign !== ' ').length;
  const waiting = work.waiting.length;
  return (
    <div className="banner" role="alert" data-banner="kept">
      <Icon name="reset" />
      <p>
        Unsaved changes of <strong>{work.name}</strong> from {when}: {differing}{' '}
        {differing === 1 ? 'line differs' : 'lines differ'}
        {waiting > 0 && `, and ${waiting} ${waiting === 1 ? 'edit waits' : 'edits wait'} for the server`}.
      </p>
      <Button kind="quiet" press={() => set_shows(!shows)}>
        {shows ? 'Hide' : 'Show'} what differs
      </Button>
      <Button press={() => void page.tool(Keeper).discard(work)}>Discard</Button>
      <Button kind="main" press={() => void page.tool(Keeper).restore(work)}>
        Restore
      </Button>
      {shows && (
        <pre className="difference" tabIndex={0} aria-label="What differs">
          {lines.slice(0, 200).map((line, index) => (
            <span key={index} className={line.sign === '+' ? 'added' : line.sign === '-' ? 'removed' : ''}>
              {`${line.sign} ${line.text}\n`}
            </span>
          ))}
        </pre>
      )}
    </div>
  );
}

function OtherWork({ name, when, open }: { name: string; when: string; open: () => void }): ReactElement {
  const page = use_page();
  return (
    <div className="banner" role="alert" data-banner="other">
      <Icon name="reset" />
      <p>
        There are unsaved changes of <strong>{name}</strong> from {when}.
      </p>
      <Button press={() => page.shell.merge({ kept: null })}>Not now</Button>
      <Button kind="main" press={open}>
        Open it
      </Button>
    </div>
  );
}

export function ConflictBanner(): ReactElement | null {
  const page = use_page();
  const { conflict } = use_store(page.shell);
  if (!conflict) return null;
  const close = (): void => page.shell.merge({ conflict: null });
  return (
    <div className="banner warning" role="alert" data-banner="conflict">
      <Icon name="warning" />
      <p>
        <strong>{conflict.path}</strong> on the disk is another one than this page knows. Saving puts this page’s text
        in its place.
      </p>
      <Button press={close}>Do not save</Button>
      <Button
        kind="main"
        press={() => {
          close();
          void save_document(page, conflict.path, true);
        }}
      >
        Save anyway
      </Button>
    </div>
  );
}
