// SPDX-License-Identifier: Apache-2.0
// A choice of whole plants: shipped ones with their pictures, and documents below the server's folder.
import type { ReactElement } from 'react';
import { useState } from 'react';

import { Icon } from '../controls/icon.tsx';
import { use_document } from '../page/use_page.ts';
import { Files } from './file_list.tsx';
import { folder_of, path_from } from './file_path.ts';
import { use_models } from './models.ts';

interface PlantChoicesProps {
  is_wanted: (text: string) => boolean;
  take: (file: string) => void; // receives the path as the document writes it
}

export function PlantChoices({ is_wanted, take }: PlantChoicesProps): ReactElement {
  const models = use_models();
  const { path } = use_document();
  const [folder, set_folder] = useState('');
  return (
    <>
      <div className="models palette">
        {models
          .filter((one) => is_wanted(`${one.name} ${one.title} ${one.description}`))
          .map((one) => (
            <ChoiceCard
              key={one.name}
              name={one.name}
              picture={one.picture ? `pictures/${one.name}.jpg` : null}
              title={one.title}
              text={one.description}
              press={() => take(one.name)}
            />
          ))}
      </div>
      <h3>Documents of this folder</h3>
      <Files
        folder={folder}
        enter={set_folder}
        take={(file) => take(path_from(folder_of(path ?? ''), file))}
        endings={['.json']}
        empty="No plant documents in this folder."
      />
    </>
  );
}

interface ChoiceCardProps {
  name: string;
  picture: string | null;
  title: string;
  text: string;
  press: () => void;
}

export function ChoiceCard({ name, picture, title, text, press }: ChoiceCardProps): ReactElement {
  const [is_missing, set_missing] = useState(false);
  return (
    <button type="button" className="model" data-add={name} data-tip={text} onClick={press}>
      {picture !== null && !is_missing ? (
        <img src={picture} alt="" loading="lazy" onError={() => set_missing(true)} />
      ) : (
        <span className="no-picture">
          <Icon name="leaf" />
        </span>
      )}
      <span className="model-title">{title}</span>
      <span className="model-description">{text}</span>
    </button>
  );
}
