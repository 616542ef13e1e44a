// SPDX-License-Identifier: Apache-2.0
// The derivation of a grammar: its step, its number of modules by kind, and its word. The view shows the plant of the
// step.
import type { KeyboardEvent, ReactElement } from 'react';
import { useEffect, useRef } from 'react';

import { use_store } from '../base/store.ts';
import { Button, IconButton, Segments } from '../controls/button.tsx';
import { NumberField } from '../controls/number_field.tsx';
import { use_page } from '../page/use_page.ts';
import { DerivationModel } from './derivation.ts';
import { WordView } from './word_view.ts';

const kNumbers = new Intl.NumberFormat('en');

export function DerivationPart({ component }: { component: string }): ReactElement {
  const page = use_page();
  const model = page.tool(DerivationModel);
  const { told, step, is_drawn, is_working, fault } = use_store(model.state);
  useEffect(() => model.look(component), [model, component]);
  const steps = told?.steps ?? 0;
  const shown = step ?? steps;
  const go = (to: number): void => model.show_step(to === steps ? null : Math.max(0, to));
  const key = (event: KeyboardEvent): void => {
    const to = { PageUp: shown + 1, PageDown: shown - 1 }[event.key];
    if (to === undefined) return;
    event.preventDefault();
    go(to);
  };
  return (
    <div className="derivation" role="group" aria-label="Derivation" onKeyDown={key}>
      <div className="derivation-steps">
        <IconButton is_small icon="first" label="Axiom" is_off={shown === 0} press={() => go(0)} />
        <IconButton
          is_small
          icon="left"
          label="A step back"
          keys="PageDown"
          is_off={shown === 0}
          press={() => go(shown - 1)}
        />
        <NumberField
          label="Shown step"
          value={shown}
          step={1}
          limit={(one) => Math.max(0, Math.round(one))}
          drag={go}
          commit={go}
          cancel={() => go(steps)}
        />
        <IconButton is_small icon="right" label="A step on" keys="PageUp" press={() => go(shown + 1)} />
        <IconButton
          is_small
          icon="last"
          label="All steps of the document"
          is_off={step === null}
          press={() => go(steps)}
        />
        <span className="quiet">of {steps} steps</span>
        <span className="stretch" />
        {step !== null && (
          <Button kind="quiet" tip={`The document takes ${step} steps`} press={() => model.keep_step()}>
            Keep
          </Button>
        )}
        {told?.interpreted && (
          <Segments
            label="Which word"
            value={is_drawn ? 'drawn' : 'derived'}
            choices={[
              ['derived', 'Derived'],
              ['drawn', 'As drawn'],
            ]}
            choose={(which) => model.show_drawn(which === 'drawn')}
          />
        )}
      </div>
      <InstanceLine />
      {fault !== '' ? (
        <p className="fault-line" role="status">
          {fault}
        </p>
      ) : (
        <p className="derivation-counts" role="status" aria-busy={is_working}>
          <b>{kNumbers.format(told?.count ?? 0)}</b> modules
          {told?.counts.map(([symbol, count]) => (
            <span key={symbol} className="count">
              <code>{symbol}</code> {kNumbers.format(count)}
            </span>
          ))}
        </p>
      )}
      <Word />
    </div>
  );
}

/// The choice between several instances, to which the word and the marks in the view belong.
function InstanceLine(): ReactElement | null {
  const model = use_page().tool(DerivationModel);
  const { told } = use_store(model.state);
  const { number = 0, of = 1 } = told?.instance ?? {};
  if (of < 2) return null;
  return (
    <div className="derivation-instance">
      <IconButton
        is_small
        icon="left"
        label="Instance before"
        is_off={number === 0}
        press={() => model.show_instance(number - 1)}
      />
      <IconButton
        is_small
        icon="right"
        label="Instance behind"
        is_off={number + 1 >= of}
        press={() => model.show_instance(number + 1)}
      />
      <span className="quiet">
        Instance {kNumbers.format(number + 1)} of {kNumbers.format(of)}; a click in the view chooses another
      </span>
    </div>
  );
}

/// A page of the word, with the module under the pointer marked here and in the view.
function Word(): ReactElement {
  const model = use_page().tool(DerivationModel);
  const { told } = use_store(model.state);
  const pointed = use_store(model.pointed);
  const parent = useRef<HTMLDivElement>(null);
  const word = useRef<WordView | null>(null);
  const first = told?.first ?? 0;
  const begin = useRef(first);
  begin.current = first;
  useEffect(() => {
    if (!parent.current) return undefined;
    const made = new WordView(parent.current, (module) =>
      model.pointed.set(module === null ? null : { module: begin.current + module, by: 'word' }),
    );
    word.current = made;
    return () => made.destroy();
  }, [model]);
  useEffect(() => {
    word.current?.show(told?.modules ?? kNoModules);
  }, [told]);
  useEffect(() => {
    word.current?.mark(pointed === null ? null : pointed.module - first, pointed?.by === 'view');
  }, [pointed, first, told]);
  const count = told?.count ?? 0;
  const end = first + (told?.modules.length ?? 0);
  return (
    <>
      <div className="editor word" ref={parent} />
      {(first > 0 || end < count) && (
        <div className="word-pages">
          <IconButton
            is_small
            icon="left"
            label="Modules before"
            is_off={first === 0}
            press={() => model.turn_page(first - model.page_size)}
          />
          <span className="quiet">
            modules {kNumbers.format(first + 1)} to {kNumbers.format(end)} of {kNumbers.format(count)}
          </span>
          <IconButton
            is_small
            icon="right"
            label="Modules behind"
            is_off={end >= count}
            press={() => model.turn_page(end)}
          />
        </div>
      )}
    </>
  );
}

const kNoModules: readonly string[] = [];
