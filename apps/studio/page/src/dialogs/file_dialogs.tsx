// SPDX-License-Identifier: Apache-2.0
// Windows for opening and saving files below the server's folder.
import type { FormEvent, ReactElement } from 'react';
import { useState } from 'react';

import { Button } from '../controls/button.tsx';
import { Dialog } from '../controls/dialog.tsx';
import { Files } from '../files/file_list.tsx';
import { use_document, use_page } from '../page/use_page.ts';
import { save_document } from '../saving/saving.ts';

export function OpenDialog({ close }: { close: () => void }): ReactElement {
  const page = use_page();
  const [folder, set_folder] = useState('');
  const [fault, set_fault] = useState<string | null>(null);
  const open = (path: string): void => {
    set_fault(null);
    void page.try_open({ path }).then((why) => (why === null ? close() : set_fault(why)));
  };
  return (
    <Dialog
      title="Open a plant"
      close={close}
      footer={<Button press={() => page.shell.merge({ dialog: 'models' })}>Shipped plants…</Button>}
    >
      {fault !== null && (
        <p className="fault-line" role="alert">
          {fault}
        </p>
      )}
      <Files
        folder={folder}
        enter={set_folder}
        take={open}
        endings={['.json']}
        empty="No plant documents in this folder."
      />
    </Dialog>
  );
}

export function SaveDialog({ close }: { close: () => void }): ReactElement {
  const page = use_page();
  const { path, name } = use_document();
  const cut = path?.lastIndexOf('/') ?? -1;
  const [folder, set_folder] = useState(cut > 0 && path ? path.slice(0, cut) : '');
  const [file, set_file] = useState(path?.slice(cut + 1) ?? `${name || 'plant'}.json`);
  const save = (event?: FormEvent): void => {
    event?.preventDefault();
    const wanted = /\.json$/i.test(file) ? file : `${file}.json`;
    void save_document(page, folder === '' ? wanted : `${folder}/${wanted}`, false).then((saved) => {
      if (saved || page.shell.get().conflict) close();
    });
  };
  return (
    <Dialog
      title="Save as"
      close={close}
      footer={
        <Button kind="main" is_off={file.trim() === ''} press={() => save()}>
          Save
        </Button>
      }
    >
      <form className="field-line" onSubmit={save}>
        <label htmlFor="file-name">Name</label>
        <input
          id="file-name"
          className="text-field"
          autoFocus
          value={file}
          onChange={(event) => set_file(event.target.value)}
        />
      </form>
      <Files
        folder={folder}
        enter={set_folder}
        take={(chosen) => set_file(chosen.slice(chosen.lastIndexOf('/') + 1))}
        endings={['.json']}
        empty="No plant documents in this folder yet."
      />
    </Dialog>
  );
}
