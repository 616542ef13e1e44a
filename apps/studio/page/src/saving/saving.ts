// SPDX-License-Identifier: Apache-2.0
// Saves the open document to a file of the server's folder.

import type { Page } from '../page/page.ts';
import type { SaveAnswer } from '../server/protocol.ts';
import { Refusal } from '../server/protocol.ts';
import { Keeper } from './keeper.ts';

/// Returns true if the document was saved. Otherwise reports the reason, or asks whether to replace somebody else's
/// changes.
export async function save_document(page: Page, path: string, over: boolean): Promise<boolean> {
  await page.document.idle();
  const slot = page.tool(Keeper).slot();
  try {
    const answer = await ask_save(page, path, over);
    page.document.take_saved(answer);
    await page.tool(Keeper).take_saved(slot);
    tell_saved(page, answer);
    return true;
  } catch (fault) {
    if (fault instanceof Refusal && fault.facts.changed) page.shell.merge({ conflict: { path } });
    else if (fault instanceof Error) page.notify(fault.message, true);
    return false;
  }
}

/// Saves exactly the page's text. A server with another text first gets the page's.
async function ask_save({ document, connection }: Page, path: string, over: boolean): Promise<SaveAnswer> {
  for (let tries = 0; ; tries += 1) {
    const { path: known, saved, hash } = document.state.get();
    try {
      return await connection.request('save', { path, hash, saved: path === known ? saved : null, over });
    } catch (fault) {
      if (!(fault instanceof Refusal) || !fault.facts.stale || tries > 0) throw fault;
      document.send_whole();
    }
  }
}

const kMaxNamed = 4; // files in a message

function tell_saved(page: Page, { path, copied = [], omitted = [] }: SaveAnswer): void {
  page.notify(`Saved ${path}${copied.length > 0 ? `, and copied ${listed(copied)}, which it names` : ''}`);
  if (omitted.length > 0)
    page.notify(
      `Not copied to the new place: ${listed(omitted.map(({ file, reason }) => `${file} (${reason})`))}`,
      true,
    );
}

/// Returns the first of some names as text.
export function listed(names: readonly string[]): string {
  const more = names.length - kMaxNamed;
  return `${names.slice(0, kMaxNamed).join(', ')}${more > 0 ? `, and ${more} more` : ''}`;
}
