// SPDX-License-Identifier: Apache-2.0
// The lower part of an export window: the equivalent command line, and the buttons.
import type { ReactElement, ReactNode } from 'react';

import { Button } from '../controls/button.tsx';
import { use_page } from '../page/use_page.ts';
import type { ExportRequest } from '../server/protocol.ts';
import { copy_command } from './copy_command.ts';

export function ExportFooter({ request, children }: { request: ExportRequest; children: ReactNode }): ReactElement {
  const page = use_page();
  return (
    <>
      <Button
        icon="command"
        tip="The line that does the same in a terminal"
        press={() => void copy_command(page, request)}
      >
        Copy as command
      </Button>
      <span className="stretch" />
      {children}
    </>
  );
}
