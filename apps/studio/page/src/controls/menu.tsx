// SPDX-License-Identifier: Apache-2.0
// A button that opens a list of actions.
import type { KeyboardEvent, ReactElement } from 'react';
import { useEffect, useLayoutEffect, useRef, useState } from 'react';

import type { IconName } from './icon.tsx';
import { Icon } from './icon.tsx';

export interface MenuItem {
  text: string;
  is_on?: boolean; // true: the present choice
  act: () => void;
}

interface MenuProps {
  label: string;
  icon?: IconName;
  items: MenuItem[];
}

export function Menu({ label, icon = 'more', items }: MenuProps): ReactElement {
  const [is_open, set_open] = useState(false);
  const button = useRef<HTMLButtonElement>(null);
  const close = (): void => {
    set_open(false);
    button.current?.focus();
  };
  return (
    <>
      <button
        ref={button}
        type="button"
        className="icon-button small"
        aria-label={label}
        aria-haspopup="menu"
        aria-expanded={is_open}
        onClick={() => set_open(!is_open)}
      >
        <Icon name={icon} />
      </button>
      {is_open && <MenuList label={label} items={items} anchor={button.current} close={close} />}
    </>
  );
}

interface MenuListProps {
  label: string;
  items: MenuItem[];
  anchor: HTMLElement | null;
  close: () => void;
}

function MenuList({ label, items, anchor, close }: MenuListProps): ReactElement {
  const list = useRef<HTMLDivElement>(null);
  useLayoutEffect(() => {
    const [menu, at] = [list.current, anchor?.getBoundingClientRect()];
    if (!menu || !at) return;
    const { width, height } = menu.getBoundingClientRect();
    menu.style.left = `${Math.max(8, Math.min(at.right - width, window.innerWidth - width - 8))}px`;
    const has_room_below = at.bottom + height + 8 <= window.innerHeight;
    menu.style.top = `${has_room_below ? at.bottom + 4 : Math.max(8, at.top - height - 4)}px`;
    menu.querySelector<HTMLElement>('[role=menuitem]')?.focus();
  }, [anchor]);
  useEffect(() => {
    const leave = (event: PointerEvent): void => {
      if (!list.current?.contains(event.target as Node) && !anchor?.contains(event.target as Node)) close();
    };
    document.addEventListener('pointerdown', leave);
    return () => document.removeEventListener('pointerdown', leave);
  }, [anchor, close]);
  const press = (event: KeyboardEvent): void => {
    const move = { ArrowDown: 1, ArrowUp: -1 }[event.key];
    if (event.key === 'Escape' || event.key === 'Tab') close();
    else if (move === undefined) return;
    else step_focus(list.current, move);
    event.preventDefault();
    event.stopPropagation();
  };
  return (
    <div ref={list} className="menu" role="menu" aria-label={label} onKeyDown={press}>
      {items.map((item) => (
        <button
          key={item.text}
          type="button"
          role="menuitem"
          tabIndex={-1}
          className={item.is_on ? 'on' : ''}
          onClick={() => {
            close();
            item.act();
          }}
        >
          <Icon name={item.is_on ? 'check' : 'more'} />
          {item.text}
        </button>
      ))}
    </div>
  );
}

function step_focus(list: HTMLElement | null, move: number): void {
  const all = [...(list?.querySelectorAll<HTMLElement>('[role=menuitem]') ?? [])];
  const at = all.indexOf(document.activeElement as HTMLElement);
  all[(at + move + all.length) % all.length]?.focus();
}
