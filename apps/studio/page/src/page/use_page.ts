// SPDX-License-Identifier: Apache-2.0
import { createContext, useContext } from 'react';

import { use_store } from '../base/store.ts';
import type { DocumentState } from '../document/document_state.ts';
import type { Studio } from '../studio.ts';

export const StudioContext = createContext<Studio | null>(null);

export function use_studio(): Studio {
  const studio = useContext(StudioContext);
  if (!studio) throw new Error('a panel outside of the studio');
  return studio;
}

export function use_document(): DocumentState {
  return use_store(use_studio().document.state);
}
