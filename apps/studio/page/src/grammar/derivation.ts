// SPDX-License-Identifier: Apache-2.0
// The derivation of a grammar, step by step. It is requested from the server while a panel shows it, together with the
// plant of that step.
import { Newest } from '../base/newest.ts';
import { Store } from '../base/store.ts';
import { InstanceChoice } from '../page/instance_choice.ts';
import type { Page } from '../page/page.ts';
import type { Derivation } from '../server/protocol.ts';
import { Refusal } from '../server/protocol.ts';
import type { Tables } from '../tables/tables.ts';
import { is_object } from '../values/json.ts';
import { member_of, path_below } from '../values/path.ts';

export interface DerivationState {
  component: string; // component whose grammar is shown; "" for none
  instance: string | null; // key of the chosen instance; null: chosen by its number
  number: number; // number of the instance among all instances of the component
  step: number | null; // null: as many steps as the component has
  is_drawn: boolean; // true: rules of interpretation are applied
  first: number; // first module of the page
  told: Derivation | null; // the last answer
  is_working: boolean;
  fault: string;
}

const kNothing: DerivationState = {
  component: '',
  instance: null,
  number: 0,
  step: null,
  is_drawn: false,
  first: 0,
  told: null,
  is_working: false,
  fault: '',
};
const kModules = 4000; // modules per page
const kPause = 120; // ms after the last change of the text

export class DerivationModel {
  readonly state = new Store<DerivationState>(kNothing);
  /// Index of the module at the pointer or the cursor, and the place where it is pointed at.
  readonly pointed = new Store<{ module: number; by: 'word' | 'view' } | null>(null);
  private readonly newest_ = new Newest();
  private timer_ = 0;
  private seen_hash_ = '';
  private readonly looks_ = new Set<() => void>();

  constructor(private readonly page_: Page) {}

  /// Resets the derivation for another document. An open panel then shows the component with the present name.
  forget(): void {
    this.newest_.drop();
    this.pointed.set(null);
    this.state.set({ ...kNothing, component: this.looks_.size > 0 ? this.state.get().component : '' });
    this.seen_hash_ = '';
    if (this.looks_.size > 0) this.ask_later();
  }

  /// Keeps the derivation up to date while a panel shows it. Returns a function that ends this.
  look(component: string): () => void {
    this.seen_hash_ = '';
    const before = this.state.get();
    this.state.set(before.component === component ? { ...before, step: null } : { ...kNothing, component });
    const { document, dragged } = this.page_;
    const { found } = this.page_.tool(InstanceChoice);
    const stops = [
      document.state.subscribe(() => this.ask_later()),
      dragged.subscribe(() => this.follow_drags()),
      found.subscribe(() => this.follow_choice()),
    ];
    this.take_choice();
    const leave = (): void => {
      for (const stop of stops) stop();
      this.looks_.delete(leave);
      clearTimeout(this.timer_);
      this.show_step(null);
      this.pointed.set(null);
      this.state.merge({ told: null });
    };
    this.looks_.add(leave);
    this.ask_later();
    return leave;
  }

  /// Shows the word and the plant of a step. Null: as many steps as the component has.
  show_step(step: number | null): void {
    if (step === this.state.get().step) return;
    this.state.merge({ step, first: 0 });
    if (step === null) this.page_.stop_drag();
    else this.page_.drag({ [this.path_of_steps]: step });
    this.ask();
  }

  /// Copies the shown step into the document.
  keep_step(): void {
    const { step } = this.state.get();
    if (step === null) return;
    this.state.merge({ step: null });
    this.page_.set_value(this.path_of_steps, step, 'Set steps');
  }

  /// Shows another instance of the component, by its number.
  show_instance(number: number): void {
    this.state.merge({ instance: null, number: Math.max(0, number), first: 0 });
    this.ask();
  }

  show_drawn(is_drawn: boolean): void {
    this.state.merge({ is_drawn, first: 0 });
    this.ask();
  }

  turn_page(first: number): void {
    this.state.merge({ first: Math.max(0, first) });
    this.ask();
  }

  get page_size(): number {
    return kModules;
  }

  private get path_of_steps(): string {
    return path_below(path_below('components', this.state.get().component), 'steps');
  }

  /// The plant of another step is shown by a drag. When that drag ends, the step ends with it.
  private follow_drags(): void {
    if (this.state.get().step === null || this.path_of_steps in this.page_.dragged.get()) return;
    this.state.merge({ step: null, first: 0 });
    this.ask();
  }

  /// Takes the instance that was clicked in the view. Returns true if it is another one than before.
  private take_choice(): boolean {
    const found = this.page_.tool(InstanceChoice).found.get();
    const { component, instance } = this.state.get();
    if (found === null || found.component !== component || found.key === instance) return false;
    this.state.merge({ instance: found.key, first: 0 });
    return true;
  }

  private follow_choice(): void {
    if (this.take_choice()) this.ask();
  }

  private ask_later(): void {
    const { hash, good } = this.page_.document.state.get();
    if (!good || hash === this.seen_hash_) return;
    clearTimeout(this.timer_);
    this.timer_ = window.setTimeout(() => {
      this.seen_hash_ = hash;
      this.ask();
    }, kPause);
  }

  private ask(): void {
    const { component, instance, number: wanted, step, is_drawn, first } = this.state.get();
    if (component === '') return;
    const counts = this.newest_.begin();
    this.state.merge({ is_working: true });
    this.page_.connection
      .request('grammar', {
        component,
        ...(instance === null ? { number: wanted } : { instance }),
        step,
        drawn: is_drawn,
        first,
        count: kModules,
      })
      .then(({ derivation }) =>
        this.take(counts, { told: derivation, fault: '', number: derivation.instance?.number ?? 0 }),
      )
      .catch((fault: unknown) => this.take(counts, { fault: fault instanceof Refusal ? fault.message : '' }));
  }

  private take(counts: () => boolean, part: Partial<DerivationState>): void {
    if (counts() && this.looks_.size > 0) this.state.merge({ ...part, is_working: false });
  }
}

export interface GrammarPlace {
  component: string;
  path: string; // path of the row with the text
  is_file: boolean;
}

/// Returns the components whose tables have a row of lines, with the path of the text.
export function grammars_of(document: unknown, tables: Tables): GrammarPlace[] {
  const components = is_object(document as never) ? member_of(document as never, 'components') : undefined;
  if (!is_object(components)) return [];
  return Object.entries(components).flatMap(([component, said]) => {
    const table = tables.tables[tables.components[String(member_of(said, 'type'))]?.table ?? ''];
    const row = table?.rows.find((one) => one.kind === 'lines');
    if (!row) return [];
    const is_file = member_of(said, row.name) === undefined;
    return [{ component, path: path_below(path_below('components', component), row.name), is_file }];
  });
}
