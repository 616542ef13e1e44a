// SPDX-License-Identifier: Apache-2.0
// The clicked instance: its number and its values, and the selection of instances for `omit` and `only`.
import type { ReactElement } from 'react';

import { use_store } from '../base/store.ts';
import { Button } from '../controls/button.tsx';
import { shown_number } from '../controls/number_field.tsx';
import { InstanceChoice } from '../page/instance_choice.ts';
import { use_document, use_page } from '../page/use_page.ts';
import type { FoundInstance } from '../server/protocol.ts';
import type { Json } from '../values/json.ts';
import { path_below, value_at } from '../values/path.ts';

export function InstancePanel({ path }: { path: string }): ReactElement | null {
  const page = use_page();
  const instance = use_store(page.tool(InstanceChoice).found);
  const selecting = use_store(page.tool(InstanceChoice).selecting);
  if (!instance || path !== path_below('components', instance.component)) return null;
  const { component, i, n } = instance;
  const begin = (row: 'omit' | 'only') => () =>
    page.tool(InstanceChoice).selecting.set({ component, row, numbers: [i] });
  return (
    <section className="instance" aria-label="The chosen instance">
      <h3>
        Instance {i} of {n}
        {instance.shoot !== null && <span className="badge">{instance.shoot}</span>}
      </h3>
      <Values instance={instance} path={path} />
      {selecting ? (
        <Selecting />
      ) : (
        <p className="instance-tools">
          <Button kind="quiet" tip="Click further instances in the view" press={begin('omit')}>
            Leave out…
          </Button>
          <Button kind="quiet" tip="Click further instances in the view" press={begin('only')}>
            Only this…
          </Button>
        </p>
      )}
    </section>
  );
}

function Values({ instance, path }: { instance: FoundInstance; path: string }): ReactElement | null {
  const rows: [string, string][] = [
    ...(instance.depth > 0 ? [['depth', String(instance.depth)] as [string, string]] : []),
    ...(instance.order > 0 ? [['order', String(instance.order)] as [string, string]] : []),
    ['u', shown_number(instance.u)],
    ...instance.values.map(({ path: of, value }): [string, string] => [
      of.slice(path.length + 1).replaceAll('_', ' '),
      shown_number(value),
    ]),
  ];
  return (
    <dl className="instance-values">
      {rows.map(([name, value]) => (
        <div key={name}>
          <dt>{name}</dt>
          <dd>{value}</dd>
        </div>
      ))}
    </dl>
  );
}

/// The selected numbers, until they are applied as one step.
function Selecting(): ReactElement | null {
  const page = use_page();
  const { tree } = use_document();
  const selecting = use_store(page.tool(InstanceChoice).selecting);
  if (!selecting) return null;
  const { component, row, numbers } = selecting;
  const path = path_below(path_below('components', component), row);
  const take = (): void => {
    page.tool(InstanceChoice).selecting.set(null);
    const said = value_at(tree, path);
    const before: Json[] = Array.isArray(said) ? said : said === undefined ? [] : [said];
    const more = numbers.filter((one) => !before.includes(one));
    page.set_value(
      path,
      [...before, ...more],
      row === 'omit' ? `Leave out ${more.join(', ')} of ${component}` : `Only ${numbers.join(', ')} of ${component}`,
    );
  };
  return (
    <div className="selecting" role="status">
      <p>
        {row === 'omit' ? 'To leave out' : 'The only ones'}: <b>{numbers.join(', ') || 'none yet'}</b>. Click further
        instances of {component} in the view.
      </p>
      <p className="instance-tools">
        <Button is_off={numbers.length === 0} press={take}>
          Take over
        </Button>
        <Button kind="quiet" press={() => page.tool(InstanceChoice).selecting.set(null)}>
          Cancel
        </Button>
      </p>
    </div>
  );
}
