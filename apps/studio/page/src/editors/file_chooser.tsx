// SPDX-License-Identifier: Apache-2.0
// The files below the server's folder that a row can name: files of the formats that it reads, or all files.
import type { ReactElement } from 'react';
import { useState } from 'react';

import { Button } from '../controls/button.tsx';
import { endings_in, names_pictures } from '../files/file_endings.ts';
import { Files } from '../files/file_list.tsx';
import { folder_of, path_from } from '../files/file_path.ts';
import { use_document, use_page } from '../page/use_page.ts';
import type { Row } from '../tables/tables.ts';
import { Thumbnail } from './thumbnail.tsx';

interface FileChooserProps {
  row: Row;
  file: string; // the present file, as the document writes it
  take: (file: string) => void;
}

export function FileChooser({ row, file, take }: FileChooserProps): ReactElement {
  const { path } = use_document();
  const home = folder_of(path ?? '');
  const [folder, set_folder] = useState(
    file !== '' && path !== null ? folder_of(path_from('', `${home}/${file}`)) : home,
  );
  const endings = endings_in(row.doc);
  const [shows_all, set_shows_all] = useState(endings.length === 0);
  const pictures = names_pictures(row)
    ? { picture_of: (one: string) => <Thumbnail file={path_from(home, one)} /> }
    : {};
  const empty = shows_all ? 'No files in this folder.' : `No ${endings.join(', ')} files in this folder.`;
  return (
    <div className="file-chooser">
      <Files
        folder={folder}
        enter={set_folder}
        take={(one) => take(path_from(home, one))}
        endings={shows_all ? [] : endings}
        empty={empty}
        {...pictures}
      />
      {endings.length > 0 && (
        <label className="check-line">
          <input type="checkbox" checked={shows_all} onChange={(event) => set_shows_all(event.target.checked)} />
          Show files of all endings
        </label>
      )}
    </div>
  );
}

/// A shipped plant finds its files only beside itself, so the user's files cannot be chosen.
export function ShippedFiles({ close }: { close: () => void }): ReactElement {
  const page = use_page();
  const save = (): void => {
    close();
    page.shell.merge({ dialog: 'save' });
  };
  return (
    <div className="shipped-files">
      <p className="empty">
        A shipped plant reads files that are shipped with it. Save it under a name of its own first; then it reads files
        beside it.
      </p>
      <Button press={save}>Save as…</Button>
    </div>
  );
}
