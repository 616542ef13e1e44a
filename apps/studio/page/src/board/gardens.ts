// SPDX-License-Identifier: Apache-2.0
// Documents that are components of other documents. The user enters, changes and leaves them. Unsaved changes are kept
// by the browser, as whenever another document is opened.
import { Store } from '../base/store.ts';
import { folder_of } from '../files/file_path.ts';
import type { Page } from '../page/page.ts';
import { Keeper } from '../saving/keeper.ts';
import type { OpenRequest } from '../server/protocol.ts';
import { member_of } from '../values/path.ts';

export interface Entered {
  title: string;
  request: OpenRequest; // opens the document again
}

export class Gardens {
  /// The documents above the open one, from the outermost inwards.
  readonly trail = new Store<Entered[]>([]);

  constructor(private readonly page_: Page) {}

  /// Returns a request to open the document of a component. Returns null if the component has no document.
  document_of(id: string): OpenRequest | null {
    const { tree, path } = this.page_.document.state.get();
    const component = member_of(member_of(tree?.value, 'components'), id);
    const type = String(member_of(component, 'type') ?? '');
    const file = member_of(component, 'file');
    if (this.page_.tables.components[type]?.is_whole_plant !== true || typeof file !== 'string') return null;
    if (!/\.json$/i.test(file)) return { model: file };
    if (path === null) return { model: file.replace(/\.json$/i, '') };
    const home = folder_of(path);
    return { path: normal(home === '' ? file : `${home}/${file}`) };
  }

  async enter(id: string): Promise<void> {
    const request = this.document_of(id);
    if (!request) return;
    const { path, model, name, text, tree } = this.page_.document.state.get();
    const title = member_of(tree?.value, 'name');
    const own: OpenRequest = path !== null ? { path } : model !== null ? { model } : { text, path: null };
    const trail = [...this.trail.get(), { title: typeof title === 'string' ? title : name, request: own }];
    if (await this.page_.open(request)) {
      this.trail.set(trail);
      this.restore();
    }
  }

  /// Returns to a document of the trail, by its number.
  async leave(number: number): Promise<void> {
    const trail = this.trail.get();
    const entered = trail[number];
    if (!entered || !(await this.page_.open(entered.request))) return;
    this.trail.set(trail.slice(0, number));
    this.restore();
  }

  /// Restores changes that were unsaved when the document was left.
  private restore(): void {
    const { kept } = this.page_.shell.get();
    if (kept !== null && kept.before !== null) void this.page_.tool(Keeper).restore(kept.work);
  }
}

function normal(path: string): string {
  const names: string[] = [];
  for (const name of path.split('/')) {
    if (name === '..') names.pop();
    else if (name !== '.' && name !== '') names.push(name);
  }
  return names.join('/');
}
