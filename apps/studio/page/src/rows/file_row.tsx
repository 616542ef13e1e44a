// SPDX-License-Identifier: Apache-2.0
// A row that names a file: its path, and a window to find it below the server's folder.
import type { ReactElement } from 'react';
import { useState } from 'react';

import { Button, IconButton } from '../controls/button.tsx';
import { Dialog } from '../controls/dialog.tsx';
import { Files } from '../dialogs/file_dialogs.tsx';
import { Thumbnail } from '../editors/thumbnail.tsx';
import type { Json } from '../document/json.ts';
import { use_document, use_studio } from '../studio_context.ts';
import type { Row } from '../tables/tables.ts';
import { folder_of, path_from } from './file_path.ts';
import { endings_in } from './file_endings.ts';
import type { RowEditorProps } from './row_editor.tsx';
import { TextField } from './text_field.tsx';

export function FileRow(props: RowEditorProps): ReactElement {
  const { label, value, row, actions } = props;
  const [is_open, set_open] = useState(false);
  const file = typeof value === 'string' ? value : '';
  return (
    <div className={`file-row${names_pictures(row) ? ' of-pictures' : ''}`}>
      {names_pictures(row) && <Thumbnail file={file} />}
      <TextField label={label} value={file} commit={actions.commit} is_code is_faulty={props.is_faulty} description={row.doc} placeholder="path of a file" />
      <IconButton is_small icon="folder" label={`Choose a file for ${label}`} press={() => set_open(true)} />
      {is_open && <FileDialog label={label} row={row} value={value} take={actions.commit} close={() => set_open(false)} />}
    </div>
  );
}

function names_pictures(row: Row): boolean {
  return endings_in(row.doc).includes('.png');
}

interface FileDialogProps {
  label: string;
  row: Row;
  value: Json | undefined;
  take: (file: string) => void;
  close: () => void;
}

export function FileDialog({ label, row, value, take: commit, close }: FileDialogProps): ReactElement {
  const studio = use_studio();
  const { path, model } = use_document();
  const home = folder_of(path ?? '');
  const [folder, set_folder] = useState(typeof value === 'string' && path !== null ? folder_of(path_from('', `${home}/${value}`)) : home);
  const endings = endings_in(row.doc);
  const [shows_all, set_shows_all] = useState(endings.length === 0);
  const title = `A file for ${label}`;
  // A shipped plant finds its files beside itself, where nothing of the user's is.
  if (model !== null) {
    const save = (): void => {
      close();
      studio.shell.merge({ dialog: 'save' });
    };
    return (
      <Dialog title={title} close={close} footer={<Button kind="main" press={save}>Save as…</Button>}>
        <p className="empty">A shipped plant reads files that are shipped with it. Save it under a name of its own first; then it reads files beside it.</p>
      </Dialog>
    );
  }
  const pictures = names_pictures(row) ? { picture_of: (file: string) => <Thumbnail file={path_from(home, file)} /> } : {};
  const take = (file: string): void => {
    close();
    commit(path_from(home, file));
  };
  return (
    <Dialog title={title} close={close}>
      <p className="quiet">{row.doc}</p>
      <Files folder={folder} enter={set_folder} take={take} endings={shows_all ? [] : endings} empty={shows_all ? 'No files in this folder.' : `No ${endings.join(', ')} files in this folder.`} {...pictures} />
      {endings.length > 0 && (
        <label className="check-line">
          <input type="checkbox" checked={shows_all} onChange={(event) => set_shows_all(event.target.checked)} />
          Show files of all endings
        </label>
      )}
    </Dialog>
  );
}
