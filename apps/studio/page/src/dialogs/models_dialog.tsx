// SPDX-License-Identifier: Apache-2.0
import type { ReactElement } from 'react';
import { useState } from 'react';

import { Dialog } from '../controls/dialog.tsx';
import { Icon } from '../controls/icon.tsx';
import { use_models } from '../files/models.ts';
import { use_page } from '../page/use_page.ts';

/// A window with all shipped plants and their pictures.
export function ModelsDialog({ close }: { close: () => void }): ReactElement {
  const page = use_page();
  const models = use_models();
  const [words, set_words] = useState('');
  const open = (model: string) => (): void => {
    close();
    void page.open({ model });
  };
  const wanted = models.filter((one) =>
    `${one.name} ${one.title} ${one.description}`.toLowerCase().includes(words.toLowerCase()),
  );
  return (
    <Dialog title="Shipped plants" width="wide" close={close}>
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
      <div className="models">
        {wanted.map((one) => (
          <button
            key={one.name}
            type="button"
            className="model"
            data-model={one.name}
            data-tip={one.description}
            onClick={open(one.name)}
          >
            {one.picture ? (
              <img src={`pictures/${one.name}.jpg`} alt="" loading="lazy" />
            ) : (
              <span className="no-picture">
                <Icon name="leaf" />
              </span>
            )}
            <span className="model-title">{one.title}</span>
            <span className="model-description">{one.description}</span>
          </button>
        ))}
        {models.length > 0 && wanted.length === 0 && <p className="empty">No shipped plant is called so.</p>}
      </div>
    </Dialog>
  );
}
