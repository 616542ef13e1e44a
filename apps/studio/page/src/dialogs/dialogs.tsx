// SPDX-License-Identifier: Apache-2.0
import type { ReactElement } from 'react';

import { use_store } from '../base/store.ts';
import { PaletteDialog } from '../board/palette_dialog.tsx';
import { Dialog } from '../controls/dialog.tsx';
import { ChanceDialog } from '../find/chance_dialog.tsx';
import { use_page } from '../page/use_page.ts';
import { ExportDialog } from './export_dialog.tsx';
import { OpenDialog, SaveDialog } from './file_dialogs.tsx';
import { ModelsDialog } from './models_dialog.tsx';
import { RecordDialog } from './record_dialog.tsx';
import { kShortcuts } from './shortcut_list.ts';
import { StillDialog } from './still_dialog.tsx';

/// The open window, if there is one.
export function Dialogs(): ReactElement | null {
  const page = use_page();
  const { dialog } = use_store(page.shell);
  const close = (): void => page.shell.merge({ dialog: null });
  if (dialog === 'open') return <OpenDialog close={close} />;
  if (dialog === 'save') return <SaveDialog close={close} />;
  if (dialog === 'models') return <ModelsDialog close={close} />;
  if (dialog === 'palette') return <PaletteDialog close={close} />;
  if (dialog === 'export') return <ExportDialog close={close} />;
  if (dialog === 'still') return <StillDialog close={close} />;
  if (dialog === 'record') return <RecordDialog close={close} />;
  if (dialog === 'chance') return <ChanceDialog close={close} />;
  return dialog === 'shortcuts' ? <ShortcutsDialog close={close} /> : null;
}

function ShortcutsDialog({ close }: { close: () => void }): ReactElement {
  return (
    <Dialog title="Shortcuts" width="wide" close={close}>
      <div className="shortcuts" role="group" aria-label="All keys" tabIndex={0}>
        {kShortcuts.map((group) => (
          <section key={group.title}>
            <h3>{group.title}</h3>
            <dl>
              {group.keys.map(({ keys, text }) => (
                <div key={keys}>
                  <dt>
                    <kbd>{keys}</kbd>
                  </dt>
                  <dd>{text}</dd>
                </div>
              ))}
            </dl>
          </section>
        ))}
      </div>
    </Dialog>
  );
}
