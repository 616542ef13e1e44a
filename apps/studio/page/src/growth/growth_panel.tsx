// SPDX-License-Identifier: Apache-2.0
// The panel of growth: a slider over its steps, switches for overlays, and a legend of their colours.
import type { KeyboardEvent, ReactElement } from 'react';

import { use_store } from '../base/store.ts';
import { IconButton } from '../controls/button.tsx';
import { Slider } from '../controls/slider.tsx';
import { use_page } from '../page/use_page.ts';
import { GrowthLook } from './growth_look.ts';
import type { LegendKey } from './layers.ts';

export function GrowthButton(): ReactElement {
  const look = use_page().tool(GrowthLook);
  const { is_open } = use_store(look.state);
  return (
    <IconButton
      icon="growth"
      label="Steps of growth, and what the plant grew by"
      keys="S"
      is_on={is_open}
      press={() => look.toggle()}
    />
  );
}

export function GrowthPanel(): ReactElement | null {
  const look = use_page().tool(GrowthLook);
  const { is_open, legend } = use_store(look.state);
  if (!is_open) return null;
  return (
    <section className="growth-panel" aria-label="Growth">
      <Growing />
      <Steps />
      <Parts />
      <Legend keys={legend} />
    </section>
  );
}

/// The choice of the component whose steps are shown, if several have growing plants.
function Growing(): ReactElement | null {
  const look = use_page().tool(GrowthLook);
  const { of, growing } = use_store(look.state);
  const names = Object.keys(growing);
  if (names.length < 2) return null;
  const max = Math.max(...Object.values(growing));
  return (
    <label className="growth-of">
      <span className="quiet">Steps of</span>
      <select className="select" value={of ?? ''} onChange={(event) => look.look_at(event.target.value || null)}>
        <option value="">all plants, side by side ({max})</option>
        {names.map((name) => (
          <option key={name} value={name}>
            {name} ({growing[name]})
          </option>
        ))}
      </select>
    </label>
  );
}

function Steps(): ReactElement {
  const look = use_page().tool(GrowthLook);
  const { step, steps } = use_store(look.state);
  if (steps === 0) return <p className="quiet">No plant of this document grows step by step.</p>;
  const last = steps ?? 0;
  const shown = Math.min(step ?? last, last);
  // Buttons stay enabled at both ends, so that the keyboard focus stays on them.
  const go = (to: number): void => look.show_step(to);
  const key = (event: KeyboardEvent): void => {
    const to = { PageUp: shown + 1, PageDown: shown - 1 }[event.key];
    if (to === undefined) return;
    event.preventDefault();
    go(to);
  };
  return (
    <div className="growth-steps" role="group" aria-label="Step of growth" onKeyDown={key} aria-busy={steps === null}>
      <IconButton is_small icon="first" label="Before growth" press={() => go(0)} />
      <IconButton is_small icon="left" label="A step back" keys="PageDown" press={() => go(shown - 1)} />
      <Slider
        label="Step of growth"
        value={shown}
        low={0}
        high={last}
        step={1}
        drag={go}
        commit={go}
        cancel={() => go(last)}
      />
      <IconButton is_small icon="right" label="A step on" keys="PageUp" press={() => go(shown + 1)} />
      <IconButton is_small icon="last" label="After all steps" press={() => go(last)} />
      <output className="growth-step">{steps === null ? '…' : `${shown} of ${last}`}</output>
    </div>
  );
}

function Parts(): ReactElement {
  const look = use_page().tool(GrowthLook);
  const { parts } = use_store(look.state);
  return (
    <div className="growth-parts" role="group" aria-label="Shown over the plant">
      {look.known.map(({ name, title, doc }) => (
        <button
          key={name}
          type="button"
          className="chip"
          aria-pressed={parts.includes(name)}
          data-tip={doc}
          onClick={() => look.switch_part(name)}
        >
          {title}
        </button>
      ))}
    </div>
  );
}

function Legend({ keys }: { keys: readonly LegendKey[] }): ReactElement | null {
  if (keys.length === 0) return null;
  return (
    <ul className="growth-legend" aria-label="What the colours mean">
      {keys.map(({ colour, text }) => (
        <li key={text}>
          <span
            aria-hidden="true"
            style={{ background: `rgb(${colour.map((share) => Math.round(255 * share)).join(' ')})` }}
          />
          {text}
        </li>
      ))}
    </ul>
  );
}
