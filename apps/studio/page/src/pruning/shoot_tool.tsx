// SPDX-License-Identifier: Apache-2.0
// The tool over the view for a chosen shoot: cut, bend, tie or mark it after the shown iteration. It appears if
// operations can act on the shoot.
import type { KeyboardEvent, ReactElement } from 'react';
import { useLayoutEffect, useRef } from 'react';

import { use_store } from '../base/store.ts';
import { Button, IconButton, Segments } from '../controls/button.tsx';
import { NumberLine } from '../controls/number_line.tsx';
import { TextField } from '../controls/text_field.tsx';
import type { FoundShoot } from '../page/instance_choice.ts';
import { InstanceChoice } from '../page/instance_choice.ts';
import { use_page } from '../page/use_page.ts';
import { Pruning } from './pruning.ts';
import type { ActionChoice, ShootAction } from './shoot_cut.ts';
import { kept_metamers, why_not } from './shoot_cut.ts';
import { ShootWalkBar } from './shoot_walk_bar.tsx';

const kActions: [ShootAction, string][] = [
  ['cut', 'Cut'],
  ['bend', 'Bend'],
  ['tie', 'Tie'],
  ['mark', 'Mark'],
];

export function ShootTool(): ReactElement | null {
  const page = use_page();
  const shoot = InstanceChoice.shoot_of(use_store(page.tool(InstanceChoice).found));
  return shoot && <HeldShoot shoot={shoot} />;
}

function HeldShoot({ shoot }: { shoot: FoundShoot }): ReactElement {
  const page = use_page();
  const pruning = page.tool(Pruning);
  const choice = use_store(pruning.choice);
  const root = useRef<HTMLElement>(null);
  useLayoutEffect(() => {
    const tool = root.current;
    // The keyboard focus must not be lost with the tool.
    return () => {
      if (tool?.contains(document.activeElement)) tool.parentElement?.querySelector('canvas')?.focus();
    };
  }, []);
  const close = (): void => {
    page.tool(InstanceChoice).forget();
    page.view?.unmark();
  };
  const key = (event: KeyboardEvent): void => {
    if (event.key === 'Escape' && !event.defaultPrevented) close();
  };
  const fault = why_not(shoot, choice);
  const act = (): void => {
    if (fault === '') void pruning.act(shoot);
  };
  return (
    <section ref={root} className="shoot-tool" aria-label="The chosen shoot" onKeyDown={key}>
      <header>
        <h3>{shoot.shoot}</h3>
        <span className="quiet">
          {pruning.trees_beside(shoot) > 1 && `tree ${shoot.tree}, `}metamer {shoot.metamer} of{' '}
          {shoot.metamers.at(-1) ?? 0}, year {shoot.iteration}
        </span>
        <span className="stretch" />
        <IconButton is_small icon="close" label="Let the shoot go" press={close} />
      </header>
      <ShootWalkBar shoot={shoot} act={act} />
      <Segments
        label="What is done to the shoot"
        value={choice.action}
        choices={kActions}
        choose={(action) => pruning.choice.merge({ action })}
      />
      <ActionFields shoot={shoot} choice={choice} change={(part) => pruning.choice.merge(part)} />
      <div className="shoot-act">
        <Segments
          label="Season of the operation"
          value={choice.season}
          choices={[
            ['winter', 'Winter'],
            ['summer', 'Summer'],
          ]}
          choose={(season) => pruning.choice.merge({ season })}
        />
        <span className="stretch" />
        <Button kind="main" is_off={fault !== ''} press={act}>
          {said_of(shoot, choice)}
        </Button>
      </div>
      {fault !== '' && <p className="fault-line">{fault}</p>}
    </section>
  );
}

function said_of(shoot: FoundShoot, choice: ActionChoice): string {
  const kept = kept_metamers(shoot, choice);
  if (choice.action === 'cut') return kept === 0 ? 'Cut off' : `Cut above ${kept}`;
  return { bend: 'Bend', tie: 'Tie to the ground', mark: 'Mark' }[choice.action];
}

interface ActionFieldsProps {
  shoot: FoundShoot;
  choice: ActionChoice;
  change: (part: Partial<ActionChoice>) => void;
}

/// Fields for the numbers of the chosen act.
function ActionFields({ shoot, choice, change }: ActionFieldsProps): ReactElement {
  if (choice.action === 'cut') {
    const places: [ActionChoice['cut_at'], string][] = [
      ['here', 'Here'],
      ['base', 'At its base'],
      ['count', 'Above'],
    ];
    return (
      <div className="shoot-fields">
        <Segments
          label="Where the shoot is cut"
          value={choice.cut_at}
          choices={places}
          choose={(cut_at) => change({ cut_at })}
        />
        {choice.cut_at === 'count' && (
          <NumberLine
            look="shoot-field"
            label="Metamers that stay"
            value={choice.count}
            step={1}
            low={0}
            high={shoot.metamers.at(-1) ?? 0}
            set={(count) => change({ count })}
          />
        )}
      </div>
    );
  }
  if (choice.action === 'bend') {
    return (
      <div className="shoot-fields">
        <NumberLine
          look="shoot-field"
          label="Inclination"
          unit="°"
          value={choice.inclination}
          step={5}
          low={-90}
          high={90}
          set={(inclination) => change({ inclination })}
        />
        <NumberLine
          look="shoot-field"
          label="Metamers bent"
          value={choice.bent}
          step={1}
          low={1}
          high={1000}
          set={(bent) => change({ bent })}
        />
      </div>
    );
  }
  if (choice.action === 'tie') {
    return (
      <div className="shoot-fields">
        <NumberLine
          look="shoot-field"
          label="String"
          unit="m"
          value={choice.string}
          step={0.05}
          low={0}
          high={1000}
          set={(string) => change({ string })}
        />
      </div>
    );
  }
  return (
    <div className="shoot-fields">
      <label className="shoot-field">
        <span>State</span>
        <TextField
          label="State of the mark"
          value={choice.state}
          commit={(state) => change({ state: state.trim() === '' ? 'marked' : state.trim() })}
        />
      </label>
    </div>
  );
}
