// SPDX-License-Identifier: Apache-2.0
// A picture that a document names, small.
import type { ReactElement } from 'react';
import { useEffect, useState } from 'react';

import { Icon } from '../controls/icon.tsx';
import type { Studio } from '../studio.ts';
import { use_document, use_studio } from '../studio_context.ts';

interface MadeThumbnail {
  picture: string; // base 64 of a PNG
  width: number; // of the whole picture
  height: number;
}

const kMade = new Map<string, Promise<MadeThumbnail | null>>();
const kMostKept = 500;

/// Each picture is asked for once while the document is open.
function thumbnail_of(studio: Studio, key: string, file: string): Promise<MadeThumbnail | null> {
  const known = kMade.get(key);
  if (known) return known;
  if (kMade.size >= kMostKept) kMade.clear();
  const made = studio.connection
    .request<{ thumbnail: MadeThumbnail }>('picture', { file, size: 96 })
    .then((answer) => answer.thumbnail)
    .catch(() => {
      kMade.delete(key); // it may be there the next time
      return null;
    });
  kMade.set(key, made);
  return made;
}

/// `file` as the document writes it. Where it is no picture there is an icon.
export function Thumbnail({ file }: { file: string }): ReactElement {
  const studio = use_studio();
  const { path, model } = use_document();
  const [shown, show] = useState<MadeThumbnail | null>(null);
  useEffect(() => {
    let is_wanted = true;
    show(null);
    if (file !== '') void thumbnail_of(studio, `${model ?? ''}|${path ?? ''}|${file}`, file).then((made) => is_wanted && show(made));
    return () => {
      is_wanted = false;
    };
  }, [studio, path, model, file]);
  if (!shown)
    return (
      <span className="thumbnail none">
        <Icon name="document" />
      </span>
    );
  return <img className="thumbnail" src={`data:image/png;base64,${shown.picture}`} alt={`${file}, ${shown.width} by ${shown.height} pixels`} data-tip={`${file}\n${shown.width} × ${shown.height} pixels`} />;
}
