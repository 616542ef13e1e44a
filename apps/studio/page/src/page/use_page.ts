// SPDX-License-Identifier: Apache-2.0
// The page in the context of React, as panels find it.
import { createContext, useContext } from 'react';

import { use_store } from '../base/store.ts';
import type { DocumentState } from '../document/document_state.ts';
import type { Page } from './page.ts';

export const PageContext = createContext<Page | null>(null);

export function use_page(): Page {
  const page = useContext(PageContext);
  if (!page) throw new Error('a panel outside of the page');
  return page;
}

export function use_document(): DocumentState {
  return use_store(use_page().document.state);
}
