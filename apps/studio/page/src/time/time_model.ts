// SPDX-License-Identifier: Apache-2.0
// The time that the view shows, which the user scrubs or plays. While it moves, the server is asked only for few
// triangles and for the newest time. At rest it is asked for full detail.
import { Store } from '../base/store.ts';
import type { Page } from '../page/page.ts';
import { LatestSender } from '../server/latest_sender.ts';
import { document_names } from '../tables/tables.ts';
import type { Json } from '../values/json.ts';
import { budgets_of } from '../view/budgets.ts';
import type { AnimationFacts, Track } from './keys.ts';
import { animation_of, tidy_time, tracks_of } from './keys.ts';

export interface TimeState {
  time: number; // seconds of the document
  is_playing: boolean;
  is_open: boolean; // whether the timeline is visible
  track: string | null; // name of the track whose keys are edited
  key: number; // index of the chosen key
}

const kAtStart: TimeState = { time: 0, is_playing: false, is_open: false, track: null, key: 0 };
const kStill = 150; // ms after the last move until full detail is requested
const kLongestWait = 400; // ms to wait for a picture while playing

export class TimeModel {
  readonly state = new Store<TimeState>(kAtStart);
  readonly clocks = new Store<readonly string[]>([]); // components that begin clocks
  private readonly sender_ = new LatestSender(() => this.send());
  private moves_until_ = 0; // a timer; 0: the time does not move
  private known_: { document: Json | undefined; tracks: Track[] } = { document: undefined, tracks: [] };

  constructor(private readonly page_: Page) {}

  get time(): number {
    return this.state.get().time;
  }

  get document(): Json | undefined {
    return this.page_.document.state.get().tree?.value;
  }

  /// The document's animation, or a default one.
  get animation(): AnimationFacts {
    return animation_of(this.document) ?? { length: 10, fps: 25 };
  }

  /// Names at the top level of documents, which must not be confused with component names.
  get tops(): ReadonlySet<string> {
    return new Set(document_names(this.page_.tables));
  }

  /// Computed once per text.
  get tracks(): Track[] {
    const { document } = this;
    if (this.known_.document !== document) this.known_ = { document, tracks: tracks_of(document, this.tops) };
    return this.known_.tracks;
  }

  /// The members of the `view` request, except its budgets.
  get request(): { time: number } {
    return { time: this.time };
  }

  toggle(): void {
    const { is_open } = this.state.get();
    if (is_open) this.stop();
    this.state.merge({ is_open: !is_open });
  }

  scrub(time: number): void {
    const { length } = this.animation;
    const next = tidy_time(Math.min(length, time));
    if (next === this.time) return;
    this.state.merge({ time: next });
    this.move();
  }

  choose(track: string | null, key = 0): void {
    this.state.merge({ track, key });
  }

  play(): void {
    if (this.state.get().is_playing) return;
    const begin = this.time >= this.animation.length - 1e-3 ? 0 : this.time;
    this.state.merge({ is_playing: true });
    void this.run(begin);
  }

  stop(): void {
    if (!this.state.get().is_playing) return;
    this.state.merge({ is_playing: false });
    if (this.moves_until_ === 0) this.rest();
  }

  /// Resets the time for another document. Returns the previous state.
  leave(): TimeState {
    clearTimeout(this.moves_until_);
    this.moves_until_ = 0;
    this.page_.view?.move_time(false);
    const left = this.state.get();
    this.state.set({ ...kAtStart, is_open: left.is_open });
    if (left.time !== 0) this.page_.connection.tell('view', { time: 0 });
    return left;
  }

  /// Restores the previous time if the other document could not be opened.
  come_back(left: TimeState): void {
    this.state.set({ ...left, is_playing: false });
    if (left.time !== 0) this.rest();
  }

  /// Shows the present time again and again, as soon as each picture is ready. At the end it begins anew.
  private async run(begin: number): Promise<void> {
    const start = performance.now();
    while (this.state.get().is_playing) {
      const { length } = this.animation;
      const shown = this.next_picture();
      this.scrub((begin + (performance.now() - start) / 1000) % length);
      await shown;
    }
  }

  /// Resolves when the next packet is shown, or after a while without a packet.
  private next_picture(): Promise<void> {
    return new Promise((done) => {
      const known = this.page_.growth.get().shown;
      const end = (): void => {
        stop();
        clearTimeout(timer);
        requestAnimationFrame(() => done());
      };
      const stop = this.page_.growth.subscribe(() => {
        if (this.page_.growth.get().shown !== known) end();
      });
      const timer = setTimeout(end, kLongestWait);
    });
  }

  private move(): void {
    clearTimeout(this.moves_until_);
    this.moves_until_ = window.setTimeout(() => {
      this.moves_until_ = 0;
      if (!this.state.get().is_playing) this.rest();
    }, kStill);
    this.page_.view?.move_time(true);
    this.sender_.ask();
  }

  /// The time has stopped: requests full detail.
  private rest(): void {
    this.page_.view?.move_time(false);
    this.sender_.ask();
  }

  private send(): Promise<unknown> {
    const { view, connection } = this.page_;
    const budgets = view ? budgets_of(view) : null;
    const rest = budgets && {
      rest_triangles:
        this.moves_until_ !== 0 || this.state.get().is_playing ? budgets.drag_triangles : budgets.rest_triangles,
    };
    return connection.request('view', { time: this.time, ...rest });
  }
}
