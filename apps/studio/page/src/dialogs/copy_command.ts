// SPDX-License-Identifier: Apache-2.0

import type { Page } from '../page/page.ts';
import type { ExportRequest } from '../server/protocol.ts';

/// Copies the command line that exports the same files in a terminal.
export async function copy_command(page: Page, request: ExportRequest): Promise<void> {
  try {
    const { command } = await page.connection.request('command', request);
    await navigator.clipboard.writeText(command);
    page.notify(`Copied: ${command}`);
  } catch (fault) {
    page.notify(fault instanceof Error ? fault.message : 'could not copy', true);
  }
}
