// SPDX-License-Identifier: Apache-2.0
// A row that names a file: its path, and a window for finding it below the server's folder.
import type { ReactElement } from 'react';
import { useState } from 'react';

import { IconButton } from '../controls/button.tsx';
import { Dialog } from '../controls/dialog.tsx';
import { TextField } from '../controls/text_field.tsx';
import { names_pictures } from '../files/file_endings.ts';
import { use_document } from '../page/use_page.ts';
import type { RowEditorProps } from '../rows/row_kinds.ts';
import type { Row } from '../tables/tables.ts';
import type { Json } from '../values/json.ts';
import { FileChooser, ShippedFiles } from './file_chooser.tsx';
import { PictureEditor } from './picture_editor.tsx';
import { Thumbnail } from './thumbnail.tsx';

export function FileRow(props: RowEditorProps): ReactElement {
  const { label, value, row, actions, size = 'row' } = props;
  const [is_open, set_open] = useState(false);
  const file = typeof value === 'string' ? value : '';
  if (size === 'large') return <PictureEditor {...props} />;
  return (
    <div className={`file-row${names_pictures(row) ? ' of-pictures' : ''}`}>
      {names_pictures(row) && <Thumbnail file={file} />}
      <TextField
        label={label}
        value={file}
        commit={actions.commit}
        is_code
        is_faulty={props.is_faulty}
        description={row.doc}
        placeholder="path of a file"
      />
      <IconButton is_small icon="folder" label={`Choose a file for ${label}`} press={() => set_open(true)} />
      {is_open && (
        <FileDialog label={label} row={row} value={value} take={actions.commit} close={() => set_open(false)} />
      )}
    </div>
  );
}

interface FileDialogProps {
  label: string;
  row: Row;
  value: Json | undefined; // the present file
  take: (file: string) => void; // receives the path as the document writes it
  close: () => void;
}

export function FileDialog({ label, row, value, take, close }: FileDialogProps): ReactElement {
  const { model } = use_document();
  const take_and_close = (file: string): void => {
    close();
    take(file);
  };
  return (
    <Dialog title={`A file for ${label}`} close={close}>
      {model !== null && <ShippedFiles close={close} />}
      {model === null && <p className="quiet">{row.doc}</p>}
      {model === null && <FileChooser row={row} file={typeof value === 'string' ? value : ''} take={take_and_close} />}
    </Dialog>
  );
}
