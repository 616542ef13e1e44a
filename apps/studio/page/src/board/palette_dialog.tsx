// SPDX-License-Identifier: Apache-2.0
// Parts that can be added below the chosen component: new components by type, parts of shipped plants, and whole
// plants.
import type { KeyboardEvent, ReactElement } from 'react';
import { useState } from 'react';

import { use_store } from '../base/store.ts';
import { Segments } from '../controls/button.tsx';
import { Dialog } from '../controls/dialog.tsx';
import { Icon } from '../controls/icon.tsx';
import { use_models } from '../files/models.ts';
import { ChoiceCard, PlantChoices } from '../files/plant_choices.tsx';
import { use_page } from '../page/use_page.ts';
import type { PartsAnswer } from '../server/protocol.ts';
import { Board } from './board.ts';
import { icon_of } from './component_icon.ts';
import type { LinkKind } from './plant_graph.ts';
import { graph_of, usual_kind } from './plant_graph.ts';

type Tab = 'types' | 'parts' | 'plants';

const kTabs = [
  ['types', 'Components'],
  ['parts', 'Parts of shipped plants'],
  ['plants', 'Whole plants'],
] as const;
const kKinds = [
  ['child', 'Child'],
  ['branch', 'Branch'],
  ['leaf', 'Leaf'],
  ['crown', 'Crown'],
] as const;

export function PaletteDialog({ close }: { close: () => void }): ReactElement {
  const page = use_page();
  const [tab, set_tab] = useState<Tab>('types');
  const [words, set_words] = useState('');
  const [kind, set_kind] = useState<LinkKind | null>(null); // null: the usual kind
  use_store(page.chosen);
  const { graph, chosen } = page.tool(Board).actions;
  const below =
    chosen !== null && graph.components.has(chosen)
      ? chosen
      : (graph.roots.find((root) => graph.components.get(root)?.is_camera && graph.components.get(root)?.is_written) ??
        null);
  const kind_for = (type: string): LinkKind =>
    kind ?? usual_kind(page.tables.components, graph.components.get(below ?? '')?.type ?? '', type);
  const title = below === null ? 'Add to the plant' : `Add below ${below}`;
  const is_wanted = (text: string): boolean => text.toLowerCase().includes(words.toLowerCase());
  return (
    <Dialog title={title} width="wide" close={close}>
      <label className="search">
        <Icon name="search" />
        <input
          type="search"
          autoFocus
          aria-label="Find what to add"
          placeholder="Find what to add"
          value={words}
          onChange={(event) => set_words(event.target.value)}
          onKeyDown={press_first}
        />
      </label>
      <div className="palette-tools">
        <Segments label="What to add" value={tab} choices={kTabs} choose={set_tab} />
        <span className="stretch" />
        <span className="quiet">Link</span>
        <Segments
          label="Kind of the link"
          value={kind ?? ('usual' as LinkKind)}
          choices={[['usual' as LinkKind, 'Usual'], ...kKinds]}
          choose={(one) => set_kind(one === ('usual' as LinkKind) ? null : one)}
        />
      </div>
      {tab === 'types' && (
        <Types
          words={words.toLowerCase()}
          is_wanted={is_wanted}
          kind_for={kind_for}
          below={below}
          close={close}
          show_plants={() => set_tab('plants')}
        />
      )}
      {tab === 'parts' && <Parts is_wanted={is_wanted} kind_for={kind_for} below={below} close={close} />}
      {tab === 'plants' && <Plants is_wanted={is_wanted} kind={kind ?? 'child'} below={below} close={close} />}
    </Dialog>
  );
}

/// Enter in the search field takes the first result.
function press_first(event: KeyboardEvent<HTMLInputElement>): void {
  if (event.key !== 'Enter') return;
  event.preventDefault();
  event.currentTarget.closest('.dialog-body')?.querySelector<HTMLElement>('.model')?.click();
}

interface TabProps {
  is_wanted: (text: string) => boolean;
  kind_for: (type: string) => LinkKind;
  below: string | null;
  close: () => void;
}

function Types({
  words,
  is_wanted,
  kind_for,
  below,
  close,
  show_plants,
}: TabProps & { words: string; show_plants: () => void }): ReactElement {
  const page = use_page();
  const { graph } = page.tool(Board).actions;
  const has_camera = [...graph.components.values()].some((one) => one.is_camera && one.is_written);
  const types = Object.entries(page.tables.components).filter(
    ([name, { doc, is_camera }]) => is_wanted(`${name} ${doc}`) && !(has_camera && is_camera === true),
  );
  // A match of the name ranks higher than a match in a sentence.
  const rank = (name: string): number =>
    name === words ? 0 : name.startsWith(words) ? 1 : name.includes(words) ? 2 : 3;
  if (words !== '') types.sort(([a], [b]) => rank(a) - rank(b));
  const add = (type: string) => (): void => {
    // The list of whole plants asks which plant is meant.
    if (page.tables.components[type]?.is_whole_plant === true) return show_plants();
    close();
    void page
      .tool(Board)
      .actions.add(type, page.tables.components[type]?.is_camera === true ? null : below, kind_for(type));
  };
  return (
    <div className="models palette">
      {types.map(([name, { doc }]) => (
        <ChoiceCard
          key={name}
          name={name}
          picture={`pictures/part-${name}.jpg`}
          title={name}
          text={doc}
          press={add(name)}
        />
      ))}
      {types.length === 0 && <p className="empty">No component is called so.</p>}
    </div>
  );
}

function Parts({ is_wanted, kind_for, below, close }: TabProps): ReactElement {
  const page = use_page();
  const models = use_models();
  const [model, set_model] = useState<({ name: string; title: string } & PartsAnswer) | null>(null);
  const open = (name: string, title: string) => (): void => {
    page.connection
      .request('parts', { model: name })
      .then((parts) => set_model({ name, title, ...parts }))
      .catch((fault: Error) => page.notify(fault.message, true));
  };
  if (!model) {
    return (
      <div className="models palette">
        {models
          .filter((one) => is_wanted(`${one.name} ${one.title}`))
          .map((one) => (
            <ChoiceCard
              key={one.name}
              name={one.name}
              picture={one.picture ? `pictures/${one.name}.jpg` : null}
              title={one.title}
              text={one.description}
              press={open(one.name, one.title)}
            />
          ))}
      </div>
    );
  }
  const graph = graph_of(model.tree, page.tables.components, model.implied);
  const add = (id: string, type: string) => (): void => {
    close();
    void page
      .tool(Board)
      .parts.part_of(graph, id, false, model.name)
      .then(
        (part) =>
          part && page.tool(Board).parts.paste(part, below, `Add ${id} of ${model.title}`, { [id]: kind_for(type) }),
      );
  };
  return (
    <>
      <p className="crumbs">
        <button type="button" onClick={() => set_model(null)}>
          Shipped plants
        </button>
        {' / '}
        {model.title}: a component comes with all that stands on it
      </p>
      <ul className="part-list">
        {[...graph.components.values()]
          .filter((one) => one.is_written && !one.is_camera)
          .map(({ id, type }) => (
            <li key={id}>
              <button type="button" className="file model-part" data-part={id} onClick={add(id, type)}>
                <Icon name={icon_of(page.tables.components, type)} />
                <span>{id}</span>
                <span className="quiet">{type}</span>
              </button>
            </li>
          ))}
      </ul>
    </>
  );
}

function Plants({ is_wanted, kind, below, close }: Omit<TabProps, 'kind_for'> & { kind: LinkKind }): ReactElement {
  const page = use_page();
  const add = (file: string): void => {
    close();
    const id = file.replace(/^.*\//, '').replace(/\.json$/, '');
    void page.tool(Board).actions.add_plant(id, file, below, kind);
  };
  return <PlantChoices is_wanted={is_wanted} take={add} />;
}
