// SPDX-License-Identifier: Apache-2.0
// A small version of a picture that a document names.
import type { ReactElement } from 'react';
import { useEffect, useState } from 'react';

import { Icon } from '../controls/icon.tsx';
import type { Page } from '../page/page.ts';
import { use_document, use_page } from '../page/use_page.ts';
import type { Thumbnail as MadeThumbnail } from '../server/protocol.ts';

const kMade = new Map<string, Promise<MadeThumbnail | null>>();
const kMaxKept = 500;

/// Requests each picture once while the document is open.
function thumbnail_of(page: Page, key: string, file: string, size: number): Promise<MadeThumbnail | null> {
  const known = kMade.get(key);
  if (known) return known;
  if (kMade.size >= kMaxKept) kMade.clear();
  const made = page.connection
    .request('picture', { file, size })
    .then((answer) => answer.thumbnail)
    .catch(() => {
      kMade.delete(key); // it may exist next time
      return null;
    });
  kMade.set(key, made);
  return made;
}

/// Returns the picture that a document names, at most `size` pixels long. Returns null until it is ready, and if it is
/// no picture.
export function use_thumbnail(file: string, size: number): MadeThumbnail | null {
  const page = use_page();
  const { path, model } = use_document();
  const [shown, show] = useState<MadeThumbnail | null>(null);
  useEffect(() => {
    let is_wanted = true;
    show(null);
    if (file !== '')
      void thumbnail_of(page, `${size}|${model ?? ''}|${path ?? ''}|${file}`, file, size).then(
        (made) => is_wanted && show(made),
      );
    return () => {
      is_wanted = false;
    };
  }, [page, path, model, file, size]);
  return shown;
}

/// `file` is the path in the document. A file that is no picture gets an icon.
export function Thumbnail({ file }: { file: string }): ReactElement {
  const shown = use_thumbnail(file, 96);
  if (!shown)
    return (
      <span className="thumbnail none">
        <Icon name="document" />
      </span>
    );
  return (
    <img
      className="thumbnail"
      src={`data:image/png;base64,${shown.picture}`}
      alt={`${file}, ${shown.width} by ${shown.height} pixels`}
      data-tip={`${file}\n${shown.width} × ${shown.height} pixels`}
    />
  );
}
