// SPDX-License-Identifier: Apache-2.0
// Measures of the plant, requested from the server while a panel shows them and again after each change. Also measures
// over the values of a handle.
import { Newest } from '../base/newest.ts';
import { Store } from '../base/store.ts';
import type { Page } from '../page/page.ts';
import type { Job } from '../server/connection.ts';
import type { Answers, Grown, MeasureRow, SweepPoint } from '../server/protocol.ts';
import { Refusal } from '../server/protocol.ts';
import { TimeModel } from '../time/time_model.ts';
import type { Json } from '../values/json.ts';

export type Measured = Record<string, Json>;

export interface MeasureState {
  rows: readonly MeasureRow[];
  told: Measured | null; // the last answer
  with_light: boolean;
  is_working: boolean;
  fault: string;
}

export interface SweepState {
  variable: string; // variable whose values are measured; "" for none
  points: readonly SweepPoint[];
  is_working: boolean;
  fault: string;
}

const kNothing: MeasureState = { rows: [], told: null, with_light: false, is_working: false, fault: '' };
const kNoSweep: SweepState = { variable: '', points: [], is_working: false, fault: '' };
const kPause = 400; // ms after the last change
const kLayers = 10; // approximate number of layers over the height of a plant

export class MeasureModel {
  readonly state = new Store<MeasureState>(kNothing);
  readonly sweep = new Store<SweepState>(kNoSweep);
  private looks_ = 0;
  private timer_ = 0;
  private readonly newest_ = new Newest(); // for measures
  private readonly newest_sweep_ = new Newest();
  private sweeping_: Job<Answers['sweep']> | null = null;
  private seen_ = ''; // hash of the text that was measured last
  // The growth whose measurement was cancelled; it is measured again on request
  private called_off_: Grown | null = null;

  constructor(private readonly page_: Page) {}

  /// Resets the measures for another document.
  forget(): void {
    this.newest_.drop();
    this.newest_sweep_.drop();
    this.seen_ = '';
    this.sweep.set(kNoSweep);
    this.state.merge({ told: null, fault: '', is_working: false });
  }

  /// Keeps the measures up to date while a panel shows them. Returns a function that ends this.
  look(): () => void {
    this.looks_ += 1;
    this.called_off_ = null;
    if (this.state.get().rows.length === 0) void this.fetch_rows();
    const stop = this.page_.growth.subscribe(() => this.ask_later());
    this.ask_later();
    return () => {
      stop();
      this.looks_ -= 1;
      clearTimeout(this.timer_);
    };
  }

  set_light(with_light: boolean): void {
    this.called_off_ = null;
    this.state.merge({ with_light });
    this.ask_later();
  }

  /// Measures the plant at each of these values of a handle. All other values stay.
  async measure_over(variable: string, values: readonly number[]): Promise<void> {
    const counts = this.newest_sweep_.begin();
    this.sweep.set({ variable, points: [], is_working: true, fault: '' });
    this.sweeping_ = this.page_.connection.begin('sweep', {
      path: variable,
      values,
      light: this.state.get().with_light,
    });
    try {
      const { sweep } = await this.sweeping_.answer;
      if (counts()) this.sweep.merge({ points: sweep, is_working: false });
    } catch (fault) {
      if (counts())
        this.sweep.merge({
          is_working: false,
          fault: fault instanceof Refusal && !fault.facts.cancelled ? fault.message : '',
        });
    }
  }

  /// Stops only the sweep; all other jobs of the server continue.
  stop_sweep(): void {
    this.sweeping_?.cancel();
  }

  private async fetch_rows(): Promise<void> {
    const answer = await this.page_.connection.request('measure_rows').catch(() => null);
    if (answer) this.state.merge({ rows: answer.rows });
  }

  private ask_later(): void {
    const { grown } = this.page_.growth.get();
    const { with_light } = this.state.get();
    const wanted = `${grown?.hash ?? ''} ${this.page_.tool(TimeModel).time} ${with_light}`;
    if (this.looks_ === 0 || !grown || grown.dragged || wanted === this.seen_ || grown === this.called_off_) return;
    clearTimeout(this.timer_);
    this.timer_ = window.setTimeout(() => {
      this.seen_ = wanted;
      void this.ask();
    }, kPause);
  }

  private async ask(): Promise<void> {
    const counts = this.newest_.begin();
    this.state.merge({ is_working: true });
    const { with_light, told } = this.state.get();
    const height = typeof told?.['height'] === 'number' ? told['height'] : 0;
    const layers = with_light && height > 0 ? { layer_height: Number((height / kLayers).toPrecision(1)) } : {};
    try {
      const { measures } = await this.page_.connection.request('measures', {
        light: with_light,
        ...layers,
      });
      if (counts()) this.state.merge({ told: measures, is_working: false, fault: '' });
    } catch (fault) {
      if (!counts()) return;
      const is_cancelled = fault instanceof Refusal && fault.facts.cancelled === true;
      this.state.merge({ is_working: false, fault: fault instanceof Refusal && !is_cancelled ? fault.message : '' });
      if (!is_cancelled) return;
      // The next growth is measured, even if its text is equal.
      this.seen_ = '';
      this.called_off_ = this.page_.growth.get().grown;
    }
  }
}
