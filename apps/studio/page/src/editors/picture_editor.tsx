// SPDX-License-Identifier: Apache-2.0
// A large editor for a row that names a picture: the picture with its size, and the pictures below the server's folder.
import type { ReactElement } from 'react';
import { Button } from '../controls/button.tsx';
import { Icon } from '../controls/icon.tsx';
import { TextField } from '../controls/text_field.tsx';
import { use_document } from '../page/use_page.ts';
import type { RowEditorProps } from '../rows/row_kinds.ts';
import { FileChooser, ShippedFiles } from './file_chooser.tsx';
import { use_thumbnail } from './thumbnail.tsx';

const kPixels = 512; // pixels along the longer side of the shown picture

export function PictureEditor({ label, value, row, actions, is_faulty }: RowEditorProps): ReactElement {
  const { model } = use_document();
  const file = typeof value === 'string' ? value : '';
  return (
    <div className="picture-editor">
      <Preview file={file} />
      <div className="picture-choice">
        <div className="picture-line">
          <TextField
            label={label}
            value={file}
            commit={actions.commit}
            is_code
            is_faulty={is_faulty}
            description={row.doc}
            placeholder="path of a picture"
          />
          {value !== undefined && !row.required && (
            <Button kind="quiet" press={actions.unset}>
              Remove
            </Button>
          )}
        </div>
        {model === null ? (
          <FileChooser row={row} file={file} take={actions.commit} />
        ) : (
          <ShippedFiles close={() => undefined} />
        )}
      </div>
    </div>
  );
}

function Preview({ file }: { file: string }): ReactElement {
  const shown = use_thumbnail(file, kPixels);
  if (!shown) {
    return (
      <div className="picture-preview none">
        <Icon name="document" />
        <p className="quiet">{file === '' ? 'No picture is named.' : 'Here is no picture that can be read.'}</p>
      </div>
    );
  }
  return (
    <figure className="picture-preview">
      <img src={`data:image/png;base64,${shown.picture}`} alt={`${file}, as it is`} />
      <figcaption className="quiet">
        {shown.width} × {shown.height} pixels
      </figcaption>
    </figure>
  );
}
