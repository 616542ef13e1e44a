// SPDX-License-Identifier: Apache-2.0
// The files below the server's folder, to choose from.
import type { ReactElement } from 'react';
import { useEffect, useState } from 'react';

import { Icon } from '../controls/icon.tsx';
import type { Page } from '../page/page.ts';
import { use_page } from '../page/use_page.ts';
import type { ListedFile } from '../server/protocol.ts';

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
      .request('files', { folder })
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
  const is_wanted = (name: string): boolean =>
    endings.length === 0 || endings.some((ending) => name.toLowerCase().endsWith(ending));
  const shown = files?.filter((one) => one.folder || is_wanted(one.name)) ?? [];
  return (
    <div className="files">
      <p className="crumbs">
        <button type="button" onClick={() => enter('')}>
          {page.server.get().hello?.root ?? 'folder'}
        </button>
        {folder
          .split('/')
          .filter(Boolean)
          .map((name, index, all) => (
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
            <button
              type="button"
              className="file"
              onClick={() => (one.folder ? enter(below(one.name)) : take(below(one.name)))}
            >
              {picture_of && !one.folder ? (
                picture_of(below(one.name))
              ) : (
                <Icon name={one.folder ? 'folder' : 'document'} />
              )}
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
