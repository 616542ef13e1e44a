// SPDX-License-Identifier: Apache-2.0
// Steps from shoot to shoot along the tree, and along the chosen shoot, by keys or buttons. The result is read aloud by
// screen readers.
import type { KeyboardEvent, ReactElement } from 'react';
import { useEffect, useRef } from 'react';

import { use_store } from '../base/store.ts';
import { IconButton } from '../controls/button.tsx';
import type { FoundShoot } from '../page/instance_choice.ts';
import { use_page } from '../page/use_page.ts';
import { Pruning } from './pruning.ts';
import type { ShootAction } from './shoot_cut.ts';
import { measures_of } from './shoot_text.ts';
import type { ShootWalk } from './shoot_walk.ts';

const kWays: Record<string, (walk: ShootWalk) => void> = {
  ArrowLeft: (walk) => void walk.go('parent'),
  ArrowRight: (walk) => void walk.go('child'),
  ArrowUp: (walk) => walk.along(1),
  ArrowDown: (walk) => walk.along(-1),
  PageUp: (walk) => void walk.go('previous'),
  PageDown: (walk) => void walk.go('next'),
  Home: (walk) => walk.along(-Infinity),
  End: (walk) => walk.along(Infinity),
};
const kActionKeys: Record<string, ShootAction> = { c: 'cut', b: 'bend', t: 'tie', m: 'mark' };

interface ShootWalkBarProps {
  shoot: FoundShoot;
  act: () => void; // carries out the tool's act
}

export function ShootWalkBar({ shoot, act }: ShootWalkBarProps): ReactElement {
  const page = use_page();
  const { walk, choice } = page.tool(Pruning);
  const note = use_store(walk.note);
  const wants_keyboard = use_store(walk.wants_keyboard);
  const bar = useRef<HTMLDivElement>(null);
  useEffect(() => {
    if (!wants_keyboard) return;
    bar.current?.focus();
    walk.wants_keyboard.set(false);
  }, [walk, wants_keyboard]);
  const key = (event: KeyboardEvent): void => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const way = kWays[event.key];
    const action = kActionKeys[event.key];
    const is_on_bar = event.target === event.currentTarget; // its buttons handle Enter themselves
    if (way) way(walk);
    else if (action) choice.merge({ action });
    else if (event.key === 'Enter' && is_on_bar) act();
    else return;
    event.preventDefault();
    event.stopPropagation();
  };
  const last = shoot.metamers.at(-1) ?? 0;
  return (
    <>
      <div
        ref={bar}
        className="shoot-walk"
        role="application"
        tabIndex={0}
        aria-label="Along the tree. Left and Right: to the bearing shoot, to a borne one. Up and Down: along the shoot. Page Up and Page Down: to its neighbours. C, B, T, M: cut, bend, tie, mark. Enter does it."
        onKeyDown={key}
      >
        <span className="quiet">Along the tree</span>
        <IconButton
          is_small
          icon="left"
          label="To the shoot that bears it"
          keys="Left"
          press={() => void walk.go('parent')}
        />
        <IconButton
          is_small
          icon="right"
          label="To a shoot that it bears"
          keys="Right"
          press={() => void walk.go('child')}
        />
        <IconButton is_small icon="up" label="Towards the tip" keys="Up" press={() => walk.along(1)} />
        <IconButton is_small icon="down" label="Towards the base" keys="Down" press={() => walk.along(-1)} />
        <IconButton
          is_small
          icon="first"
          label="The neighbour before it"
          keys="PageUp"
          press={() => void walk.go('previous')}
        />
        <IconButton
          is_small
          icon="last"
          label="The neighbour after it"
          keys="PageDown"
          press={() => void walk.go('next')}
        />
      </div>
      <p className="shoot-said quiet" role="status">
        {note !== '' ? (
          note
        ) : (
          <>
            <span className="spoken">
              {shoot.shoot}, {page.tool(Pruning).trees_beside(shoot) > 1 && `tree ${shoot.tree}, `}metamer{' '}
              {shoot.metamer} of {last}.{' '}
            </span>
            {measures_of(shoot)}
          </>
        )}
      </p>
    </>
  );
}
