// SPDX-License-Identifier: Apache-2.0
import type { ExportOptions } from '../server/protocol.ts';
import type { Studio } from '../studio.ts';

export interface ExportWish {
  format: string;
  name: string | null;
  options: ExportOptions;
}

/// Copies the command line that exports the same files in a terminal.
export async function copy_command(studio: Studio, wish: ExportWish): Promise<void> {
  try {
    const { command } = await studio.connection.request<{ command: string }>('command', wish);
    await navigator.clipboard.writeText(command);
    studio.tell(`Copied: ${command}`);
  } catch (fault) {
    studio.tell(fault instanceof Error ? fault.message : 'could not copy', true);
  }
}
