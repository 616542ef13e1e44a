// SPDX-License-Identifier: Apache-2.0
// The bar at the top: document, undo, seed, export, theme.
import type { ReactElement } from 'react';

import { prefer } from '../base/preferences.ts';
import { use_store } from '../base/store.ts';
import { Button, IconButton } from '../controls/button.tsx';
import { Icon } from '../controls/icon.tsx';
import { NumberField } from '../controls/number_field.tsx';
import { copy_command } from '../dialogs/copy_command.ts';
import type { Page } from '../page/page.ts';
import type { Theme } from '../page/page_state.ts';
import { use_document, use_page } from '../page/use_page.ts';
import { member_of } from '../values/path.ts';
import { save_here } from './shortcuts.ts';

/// The text of a new document.
const kNewPlant = `{
  "meristem": 1,
  "name": "New plant",
  "seed": 1,
  "components": {
    "view": {"type": "camera"}
  },
  "links": []
}
`;

export function TopBar(): ReactElement {
  const page = use_page();
  const { undo } = use_document();
  const ask = (dialog: 'open' | 'save' | 'models' | 'export' | 'shortcuts') => () => page.shell.merge({ dialog });
  return (
    <header className="top-bar">
      <DocumentTitle />
      <div className="tools" role="toolbar" aria-label="Document">
        <IconButton icon="plus" label="New plant" press={() => void page.open({ text: kNewPlant, path: null })} />
        <IconButton icon="models" label="Shipped plants" keys="Ctrl+M" press={ask('models')} />
        <IconButton icon="open" label="Open a file" keys="Ctrl+O" press={ask('open')} />
        <IconButton icon="save" label="Save" keys="Ctrl+S" press={() => save_here(page)} />
        <IconButton icon="save_as" label="Save as" keys="Ctrl+Shift+S" press={ask('save')} />
        <span className="gap" />
        <IconButton
          icon="undo"
          label={undo.done.length > 0 ? `Undo: ${undo.done.at(-1)?.label}` : 'Undo'}
          keys="Ctrl+Z"
          is_off={undo.done.length === 0}
          press={() => void page.undo()}
        />
        <IconButton
          icon="redo"
          label={undo.undone.length > 0 ? `Redo: ${undo.undone.at(-1)?.label}` : 'Redo'}
          keys="Ctrl+Shift+Z"
          is_off={undo.undone.length === 0}
          press={() => void page.redo()}
        />
      </div>
      <span className="stretch" />
      <Seed />
      <span className="gap" />
      <IconButton
        icon="command"
        label="Copy as command"
        press={() => void copy_command(page, { format: first_format(page), name: null, options: {} })}
      />
      <ThemeButton />
      <IconButton icon="help" label="Shortcuts" keys="?" press={ask('shortcuts')} />
      <Button kind="main" icon="export" press={ask('export')}>
        Export
      </Button>
    </header>
  );
}

function first_format(page: Page): string {
  return page.server.get().hello?.formats[0]?.ending ?? '.glb';
}

function DocumentTitle(): ReactElement {
  const { name, path, model, hash, base, tree } = use_document();
  const title = member_of(tree?.value, 'name');
  const shown = typeof title === 'string' && title !== '' ? title : name || 'Meristem';
  const is_changed = hash !== base;
  const from = path ?? (model !== null ? 'shipped plant' : 'not saved yet');
  return (
    <div className="document-title">
      <span className="mark">
        <Icon name="leaf" />
      </span>
      <div>
        <h1>
          <span data-tip={shown}>{shown}</span>
          {is_changed && (
            <span
              className="changed"
              role="img"
              aria-label="not saved"
              data-tip="Not saved yet; kept in this browser"
            />
          )}
        </h1>
        <p data-tip={path ?? undefined}>{from}</p>
      </div>
    </div>
  );
}

function Seed(): ReactElement {
  const page = use_page();
  const { tree } = use_document();
  const dragged = use_store(page.dragged);
  const said = dragged['seed'] ?? member_of(tree?.value, 'seed');
  const seed = typeof said === 'number' ? said : 1;
  const sow = (): void => page.set_value('seed', 1 + Math.floor(Math.random() * 9999), 'Roll the seed');
  return (
    <div className="seed" data-tip="Everything random comes from this number">
      <span className="quiet">Seed</span>
      <NumberField
        label="Seed"
        value={seed}
        step={1}
        limit={(one) => Math.min(Number.MAX_SAFE_INTEGER, Math.max(0, Math.round(one)))}
        drag={(one) => page.drag({ seed: one })}
        commit={(one) => page.set_value('seed', one, 'Set seed')}
        cancel={() => page.stop_drag()}
      />
      <IconButton icon="dice" label="Roll the seed" keys="R" press={sow} />
    </div>
  );
}

const kThemes: Record<Theme, { next: Theme; icon: 'auto' | 'sun' | 'moon'; text: string }> = {
  system: { next: 'light', icon: 'auto', text: 'Theme: as the system' },
  light: { next: 'dark', icon: 'sun', text: 'Theme: light' },
  dark: { next: 'system', icon: 'moon', text: 'Theme: dark' },
};

function set_theme(page: Page, theme: Theme): void {
  prefer('theme', theme);
  page.shell.merge({ theme });
}

function ThemeButton(): ReactElement {
  const page = use_page();
  const { theme } = use_store(page.shell);
  const { next, icon, text } = kThemes[theme];
  return <IconButton icon={icon} label={text} press={() => set_theme(page, next)} />;
}
