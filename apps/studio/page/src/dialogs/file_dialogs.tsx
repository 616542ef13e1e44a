// SPDX-License-Identifier: Apache-2.0
// Files below the server's folder.
import type { FormEvent, ReactElement } from 'react';
import { useEffect, useState } from 'react';

import { Button } from '../controls/button.tsx';
import { Dialog } from '../controls/dialog.tsx';
import { Icon } from '../controls/icon.tsx';
import type { ListedFile } from '../server/file_protocol.ts';
import type { Page } from '../page/page.ts';
import { use_document, use_page } from '../page/use_page.ts';
import { save_document } from '../saving/saving.ts';

interface FilesProps {
  folder: string;
  enter: (folder: string) => void;
  take: (path: string) => void;
  endings: string[]; // other files are hidden; empty: all files are shown
  empty: string; // text for an empty list
  picture_of?: (path: string) => ReactElement; // replaces the icon of a file
}

function use_files(page: Page, folder: string): ListedFile[] | null {
  const [files, set_files] = useState<ListedFile[] | null>(null);
  useEffect(() => {
    set_files(null);
    page.connection
      .request<{ files: ListedFile[] }>('files', { folder })
      .then((answer) => set_files(answer.files))
      .catch((fault: Error) => {
        page.notify(fault.message, true);
        set_files([]);
      });
  }, [page, folder]);
  return files;
}

export function Files({ folder, enter, take, endings, empty, picture_of }: FilesProps): ReactElement {
  const page = use_page();
  const files = use_files(page, folder);
  const below = (name: string): string => (folder === '' ? name : `${folder}/${name}`);
  const is_wanted = (name: string): boolean => endings.length === 0 || endings.some((ending) => name.toLowerCase().endsWith(ending));
  const shown = files?.filter((one) => one.folder || is_wanted(one.name)) ?? [];
  return (
    <div className="files">
      <p className="crumbs">
        <button type="button" onClick={() => enter('')}>
          {page.server.get().hello?.root ?? 'folder'}
        </button>
        {folder.split('/').filter(Boolean).map((name, index, all) => (
          <span key={index}>
            {' / '}
            <button type="button" onClick={() => enter(all.slice(0, index + 1).join('/'))}>
              {name}
            </button>
          </span>
        ))}
      </p>
      <ul>
        {shown.map((one) => (
          <li key={one.name}>
            <button type="button" className="file" onClick={() => (one.folder ? enter(below(one.name)) : take(below(one.name)))}>
              {picture_of && !one.folder ? picture_of(below(one.name)) : <Icon name={one.folder ? 'folder' : 'document'} />}
              <span>{one.name}</span>
              {!one.folder && <span className="quiet">{size_text(one.bytes)}</span>}
            </button>
          </li>
        ))}
      </ul>
      {files !== null && shown.length === 0 && <p className="empty">{empty}</p>}
    </div>
  );
}

export function size_text(bytes: number): string {
  if (bytes < 1000) return `${bytes} B`;
  return bytes < 1e6 ? `${(bytes / 1000).toFixed(1)} kB` : `${(bytes / 1e6).toFixed(1)} MB`;
}

export function OpenDialog({ close }: { close: () => void }): ReactElement {
  const page = use_page();
  const [folder, set_folder] = useState('');
  const [fault, set_fault] = useState<string | null>(null);
  const open = (path: string): void => {
    set_fault(null);
    void page.try_open({ path }).then((why) => (why === null ? close() : set_fault(why)));
  };
  return (
    <Dialog title="Open a plant" close={close} footer={<Button press={() => page.shell.merge({ dialog: 'models' })}>Shipped plants…</Button>}>
      {fault !== null && (
        <p className="fault-line" role="alert">
          {fault}
        </p>
      )}
      <Files folder={folder} enter={set_folder} take={open} endings={['.json']} empty="No plant documents in this folder." />
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
    <Dialog title="Save as" close={close} footer={<Button kind="main" is_off={file.trim() === ''} press={() => save()}>Save</Button>}>
      <form className="field-line" onSubmit={save}>
        <label htmlFor="file-name">Name</label>
        <input id="file-name" className="text-field" autoFocus value={file} onChange={(event) => set_file(event.target.value)} />
      </form>
      <Files folder={folder} enter={set_folder} take={(chosen) => set_file(chosen.slice(chosen.lastIndexOf('/') + 1))} endings={['.json']} empty="No plant documents in this folder yet." />
    </Dialog>
  );
}
