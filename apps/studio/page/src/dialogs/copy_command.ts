// SPDX-License-Identifier: Apache-2.0

import type { Page } from '../page/page.ts';
import type { ExportOptions } from '../server/protocol.ts';

export interface ExportWish {
  format: string;
  name: string | null;
  options: ExportOptions;
}

/// Copies the command line that exports the same files in a terminal.
export async function copy_command(page: Page, wish: ExportWish): Promise<void> {
  try {
    const { command } = await page.connection.request<{ command: string }>('command', wish);
    await navigator.clipboard.writeText(command);
    page.notify(`Copied: ${command}`);
  } catch (fault) {
    page.notify(fault instanceof Error ? fault.message : 'could not copy', true);
  }
}
