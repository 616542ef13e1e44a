// SPDX-License-Identifier: Apache-2.0
// The row that names the whole plant of a component: a shipped one, or a document below the server's folder.
import type { ReactElement } from 'react';
import { useState } from 'react';
import { IconButton } from '../controls/button.tsx';
import { Dialog } from '../controls/dialog.tsx';
import { Icon } from '../controls/icon.tsx';
import { TextField } from '../controls/text_field.tsx';
import { use_models } from '../files/models.ts';
import { PlantChoices } from '../files/plant_choices.tsx';
import type { Row, Tables } from '../tables/tables.ts';
import type { JsonNode } from '../values/json.ts';
import { path_below, steps_of, value_at } from '../values/path.ts';
import type { RowEditorProps } from './row_kinds.ts';

/// Returns true if the row at a path names a whole plant.
export function names_plant(tables: Tables, tree: JsonNode | null, row: Row, path: string): boolean {
  if (row.name !== 'file') return false;
  const [head, id, name, ...rest] = steps_of(path);
  if (head !== 'components' || id === undefined || name !== 'file' || rest.length > 0) return false;
  const type = value_at(tree, path_below(path_below('components', id), 'type'));
  return typeof type === 'string' && tables.components[type]?.is_whole_plant === true;
}

export function PlantRow(props: RowEditorProps): ReactElement {
  const { label, value, row, actions } = props;
  const [is_open, set_open] = useState(false);
  const file = typeof value === 'string' ? value : '';
  return (
    <div className="file-row of-pictures">
      <PlantPicture file={file} />
      <TextField
        label={label}
        value={file}
        commit={actions.commit}
        is_code
        is_faulty={props.is_faulty}
        description={row.doc}
        placeholder="a shipped plant or a path"
      />
      <IconButton is_small icon="folder" label={`Choose a plant for ${label}`} press={() => set_open(true)} />
      {is_open && <PlantDialog {...props} close={() => set_open(false)} />}
    </div>
  );
}

function PlantDialog({ label, row, actions, close }: RowEditorProps & { close: () => void }): ReactElement {
  const [words, set_words] = useState('');
  const take = (file: string): void => {
    close();
    actions.commit(file);
  };
  return (
    <Dialog title={`A plant for ${label}`} width="wide" close={close}>
      <label className="search">
        <Icon name="search" />
        <input
          type="search"
          autoFocus
          aria-label="Find a plant"
          placeholder="Find a plant"
          value={words}
          onChange={(event) => set_words(event.target.value)}
        />
      </label>
      <p className="quiet">{row.doc}</p>
      <PlantChoices is_wanted={(text) => text.toLowerCase().includes(words.toLowerCase())} take={take} />
    </Dialog>
  );
}

/// The picture of a shipped plant, or an icon for the user's own documents.
function PlantPicture({ file }: { file: string }): ReactElement {
  const name = file.replace(/\.json$/i, '');
  const model = use_models().find((one) => one.name === name);
  if (model?.picture === true) return <img className="thumbnail" src={`pictures/${name}.jpg`} alt="" />;
  return (
    <span className="thumbnail none">
      <Icon name="document" />
    </span>
  );
}
