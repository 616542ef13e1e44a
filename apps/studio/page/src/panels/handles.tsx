// SPDX-License-Identifier: Apache-2.0
// The handles: the document's variables that its author intended for users.
import type { ReactElement } from 'react';

import { use_store } from '../base/store.ts';
import { free_name } from '../board/board_edits.ts';
import { Button, IconButton } from '../controls/button.tsx';
import { Faults } from '../controls/faults.tsx';
import { NumberField } from '../controls/number_field.tsx';
import { Slider } from '../controls/slider.tsx';
import { TextField } from '../controls/text_field.tsx';
import { step_of } from '../find/handle_step.ts';
import { Strip } from '../find/strip.tsx';
import { variable_states } from '../find/strip_states.ts';
import type { Page } from '../page/page.ts';
import { use_document, use_page } from '../page/use_page.ts';
import { use_faults } from '../rows/row_actions.ts';
import type { Variable } from '../server/protocol.ts';
import { KeyButton } from '../time/key_button.tsx';
import { use_keyed } from '../time/use_keyed.ts';
import { drag_values, set_values } from '../time/values_now.ts';
import { rounded } from '../values/arithmetic.ts';
import { is_object } from '../values/json.ts';
import { member_of } from '../values/path.ts';

export function Handles(): ReactElement {
  const page = use_page();
  const { variables } = use_document();
  const handles = variables.filter((one) => !one.private);
  return (
    <section className="panel handles" aria-labelledby="handles-title">
      <div className="panel-head">
        <h2 id="handles-title">Handles</h2>
        <span className="stretch" />
        <IconButton is_small icon="plus" label="Add a handle" press={() => void add_handle(page)} />
        {handles.length > 0 && (
          <IconButton
            is_small
            icon="grid"
            label="Nine by chance"
            press={() => page.shell.merge({ dialog: 'chance' })}
          />
        )}
        {handles.length > 0 && (
          <Button
            kind="quiet"
            icon="sparkle"
            tip="Random values within the ranges of all handles that are not locked"
            press={() => surprise(page, handles)}
          >
            Surprise me
          </Button>
        )}
      </div>
      {handles.length === 0 && (
        <p className="empty">This document has no handles: numbers with a name, which all expressions may use.</p>
      )}
      {handles.map((one) => (
        <Handle key={one.name} variable={one} />
      ))}
    </section>
  );
}

/// Adds a new handle and chooses it, so that the inspector shows its members.
async function add_handle(page: Page): Promise<void> {
  const { tree } = page.document.state.get();
  const said = member_of(tree?.value, 'variables');
  const name = free_name('handle', new Set(is_object(said) ? Object.keys(said) : []));
  await page.edit([{ set: `variables.${name}`, value: { value: 1, min: 0, max: 2 } }], `Add the handle ${name}`, {
    choose: `variables.${name}`,
  });
}

function surprise(page: Page, handles: Variable[]): void {
  const locks = page.locks.get();
  const free = handles.filter((one) => !locks.has(one.name) && one.expression === null);
  if (free.length === 0) return page.notify('All handles are locked');
  const edits = free.map((one) => ({
    set: one.name,
    value: rounded(one.min + Math.random() * (one.max - one.min), step_of(one)),
  }));
  void page.edit(edits, 'Surprise me');
}

function Handle({ variable }: { variable: Variable }): ReactElement {
  const page = use_page();
  const { name, unit, doc, expression } = variable;
  const dragged = use_store(page.dragged)[name];
  const locks = use_store(page.locks);
  const first = use_store(page.first_values)[name];
  const faults = use_faults(`variables.${name}`, true);
  const label = name.replaceAll('_', ' ');
  const is_locked = locks.has(name);
  const has_strip = use_store(page.strip) === name;
  const states = variable_states(variable, step_of(variable));
  const keyed = use_keyed(`variables.${name}`);
  const now = expression ?? variable.value;
  const toggle_lock = (): void => {
    const next = new Set(locks);
    if (!next.delete(name)) next.add(name);
    page.locks.set(next);
  };
  return (
    <div className="handle" data-handle={name}>
      <div className="handle-head">
        <KeyButton
          label={label}
          path={`variables.${name}`}
          keyed={keyed}
          value={() => keyed?.value ?? variable.value}
        />
        <span className="handle-name">{label}</span>
        <IconButton
          is_small
          icon="edit"
          label={`Edit the handle ${label}`}
          press={() => page.choose(`variables.${name}`)}
        />
        {states.length > 1 && (
          <IconButton
            is_small
            icon="strip"
            label={`Plants over ${label}`}
            is_on={has_strip}
            press={() => page.strip.set(has_strip ? null : name)}
          />
        )}
        <IconButton
          is_small
          icon="reset"
          label={`Reset ${label}`}
          is_off={first === undefined || first === now}
          press={() => page.set_value(name, first ?? 0, `Reset ${label}`)}
        />
        <IconButton
          is_small
          icon={is_locked ? 'lock' : 'unlock'}
          label={`Lock ${label}`}
          is_on={is_locked}
          press={toggle_lock}
        />
      </div>
      {expression !== null && keyed === null && typeof dragged !== 'number' ? (
        <TextField
          label={label}
          value={expression}
          is_code
          commit={(text) => page.set_value(name, text, `Set ${label}`)}
        />
      ) : (
        <HandleNumber
          variable={variable}
          label={label}
          shown={
            typeof dragged === 'number' ? dragged : typeof keyed?.value === 'number' ? keyed.value : variable.value
          }
          unit={unit}
        />
      )}
      {has_strip && (
        <Strip
          label={label}
          path={name}
          value={expression === null ? variable.value : expression}
          states={states}
          take={(value) => set_values(page, { [name]: value }, `Set ${label}`)}
        />
      )}
      {doc && <p className="handle-doc">{doc}</p>}
      <Faults faults={faults} />
    </div>
  );
}

interface HandleNumberProps {
  variable: Variable;
  label: string;
  shown: number;
  unit: string;
}

function HandleNumber({ variable, label, shown, unit }: HandleNumberProps): ReactElement {
  const page = use_page();
  const { name, min, max, doc } = variable;
  const step = step_of(variable);
  const acts = {
    drag: (value: number) => drag_values(page, { [name]: value }),
    commit: (value: number) => set_values(page, { [name]: value }, `Set ${label}`),
    cancel: () => page.stop_drag(),
  };
  return (
    <div className="number-pair">
      <Slider
        {...acts}
        label={`${label}, slider`}
        value={shown}
        low={Math.min(min, shown)}
        high={Math.max(max, shown)}
        step={step}
      />
      <NumberField
        {...acts}
        label={label}
        value={shown}
        step={step}
        unit={unit}
        description={doc}
        limit={(one) => one}
        express={(text) => page.set_value(name, text, `Set ${label}`)}
      />
    </div>
  );
}
