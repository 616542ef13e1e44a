// SPDX-License-Identifier: Apache-2.0
// A row that names a file: its path, and a window to find it below the server's folder. A row of a whole plant chooses
// among the shipped plants as well.
import type { ReactElement } from 'react';
import { useState } from 'react';

import { PlantChoices } from '../board/plant_choices.tsx';
import { IconButton } from '../controls/button.tsx';
import { Dialog } from '../controls/dialog.tsx';
import { Icon } from '../controls/icon.tsx';
import { PictureEditor } from '../editors/picture_editor.tsx';
import { Thumbnail } from '../editors/thumbnail.tsx';
import { steps_of, value_at } from '../document/path.ts';
import { use_document, use_studio } from '../studio_context.ts';
import { FileChooser, ShippedFiles } from './file_chooser.tsx';
import { names_pictures } from './file_endings.ts';
import type { RowEditorProps } from './row_editor.tsx';
import { TextField } from './text_field.tsx';

export function FileRow(props: RowEditorProps): ReactElement {
  const { label, value, row, actions, size = 'row' } = props;
  const [is_open, set_open] = useState(false);
  const file = typeof value === 'string' ? value : '';
  const names_plant = use_names_plant(props);
  if (size === 'large') return <PictureEditor {...props} />;
  const close = (): void => set_open(false);
  return (
    <div className={`file-row${names_pictures(row) || names_plant ? ' of-pictures' : ''}`}>
      {names_pictures(row) && <Thumbnail file={file} />}
      {names_plant && <PlantPicture key={file} file={file} />}
      <TextField label={label} value={file} commit={actions.commit} is_code is_faulty={props.is_faulty} description={row.doc} placeholder="path of a file" />
      <IconButton is_small icon="folder" label={`Choose a file for ${label}`} press={() => set_open(true)} />
      {is_open && (names_plant ? <PlantDialog {...props} close={close} /> : <FileDialog {...props} close={close} />)}
    </div>
  );
}

interface DialogProps extends RowEditorProps {
  close: () => void;
}

function FileDialog({ label, row, value, actions, close }: DialogProps): ReactElement {
  const { model } = use_document();
  const take = (file: string): void => {
    close();
    actions.commit(file);
  };
  return (
    <Dialog title={`A file for ${label}`} close={close}>
      {model !== null && <ShippedFiles close={close} />}
      {model === null && <p className="quiet">{row.doc}</p>}
      {model === null && <FileChooser row={row} file={typeof value === 'string' ? value : ''} take={take} />}
    </Dialog>
  );
}

/// Whether the row says which whole plant a component places.
function use_names_plant({ row, path }: RowEditorProps): boolean {
  const studio = use_studio();
  const { tree } = use_document();
  const [head, id] = steps_of(path);
  if (row.name !== 'file' || head !== 'components' || id === undefined) return false;
  const type = value_at(tree, path.slice(0, -'.file'.length) + '.type');
  return typeof type === 'string' && studio.tables.components[type]?.is_whole_plant === true;
}

function PlantDialog({ label, row, actions, close }: DialogProps): ReactElement {
  const take = (file: string): void => {
    close();
    actions.commit(file);
  };
  const [words, set_words] = useState('');
  return (
    <Dialog title={`A plant for ${label}`} width="wide" close={close}>
      <label className="search">
        <Icon name="search" />
        <input type="search" autoFocus aria-label="Find a plant" placeholder="Find a plant" value={words} onChange={(event) => set_words(event.target.value)} />
      </label>
      <p className="quiet">{row.doc}</p>
      <PlantChoices is_wanted={(text) => text.toLowerCase().includes(words.toLowerCase())} take={take} />
    </Dialog>
  );
}

/// The picture of a shipped plant; an icon for documents of the user's own.
function PlantPicture({ file }: { file: string }): ReactElement {
  const [is_missing, set_missing] = useState(false);
  if (file !== '' && !is_missing && !/\.json$/i.test(file)) return <img className="thumbnail" src={`pictures/${encodeURIComponent(file)}.jpg`} alt="" onError={() => set_missing(true)} />;
  return (
    <span className="thumbnail none">
      <Icon name="document" />
    </span>
  );
}
