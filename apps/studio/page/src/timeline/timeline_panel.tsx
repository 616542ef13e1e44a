// SPDX-License-Identifier: Apache-2.0
// The timeline below the view: tracks with their keys, clocks as blocks, and the shown time.
import type { ReactElement } from 'react';

import { use_store } from '../base/store.ts';
import { Button, IconButton } from '../controls/button.tsx';
import { NumberField } from '../controls/number_field.tsx';
import { use_document, use_page } from '../page/use_page.ts';
import { animation_of } from '../time/keys.ts';
import { TimeModel } from '../time/time_model.ts';
import { member_of } from '../values/path.ts';
import { ClockRows } from './clock_rows.tsx';
import { Ruler } from './ruler.tsx';
import { TrackEditor } from './track_editor.tsx';
import { TrackRow } from './track_row.tsx';

export function TimelinePanel(): ReactElement | null {
  const page = use_page();
  const { is_open } = use_store(page.tool(TimeModel).state);
  return is_open ? <Timeline /> : null;
}

function Timeline(): ReactElement {
  const page = use_page();
  const model = page.tool(TimeModel);
  const { time, track } = use_store(model.state);
  const { tree } = use_document();
  const { tracks, animation } = model;
  const edited = tracks.find((one) => one.name === track) ?? null;
  const has_animation = animation_of(tree?.value) !== null;
  return (
    <section className="timeline" aria-label="Timeline">
      <TimelineHead />
      <div className="timeline-scroll">
        <div className="timeline-lanes">
          <Ruler />
          {tracks.map((one) => (
            <TrackRow key={one.name} track={one} />
          ))}
          <ClockRows />
          <span
            className="timeline-now"
            aria-hidden="true"
            style={{ left: `calc(var(--names) + (100% - var(--names) - var(--end)) * ${time / animation.length})` }}
          />
        </div>
      </div>
      {tracks.length === 0 && (
        <p className="empty">
          {has_animation ? 'No parameter has keys yet.' : 'Nothing of this document changes over time yet.'} The diamond
          before a row of the inspector puts a key where the time stands.
        </p>
      )}
      {edited && <TrackEditor key={edited.name} track={edited} />}
    </section>
  );
}

function TimelineHead(): ReactElement {
  const page = use_page();
  const model = page.tool(TimeModel);
  const { time, is_playing } = use_store(model.state);
  const { tree } = use_document();
  const { length, fps } = model.animation;
  const unrolls = member_of(member_of(tree?.value, 'animation'), 'steps_per_second') !== undefined;
  const set = (name: 'length' | 'fps') => (value: number) => {
    const has_animation = animation_of(tree?.value) !== null;
    if (has_animation) page.set_value(`animation.${name}`, value, `Set ${name}`);
    else page.set_value('animation', { length, fps, [name]: value }, `Set ${name}`);
  };
  const scrub = (value: number): void => model.scrub(value);
  const record = (): void => {
    model.stop();
    page.shell.merge({ dialog: 'record' });
  };
  return (
    <header className="timeline-head" role="toolbar" aria-label="Time">
      <IconButton is_small icon="first" label="To the beginning" press={() => scrub(0)} />
      <IconButton
        icon={is_playing ? 'pause' : 'play'}
        label={is_playing ? 'Stop playing' : 'Play'}
        keys="Shift+K"
        is_on={is_playing}
        press={() => (is_playing ? model.stop() : model.play())}
      />
      <IconButton is_small icon="last" label="To the end" press={() => scrub(length)} />
      <NumberField
        label="Time"
        value={time}
        step={1 / fps}
        unit="s"
        limit={(one) => Math.min(length, Math.max(0, one))}
        drag={scrub}
        commit={scrub}
        cancel={() => undefined}
      />
      <span className="quiet">of</span>
      <NumberField
        label="Length"
        value={length}
        step={0.1}
        unit="s"
        limit={(one) => Math.min(1e6, Math.max(0.01, one))}
        drag={() => undefined}
        commit={set('length')}
        cancel={() => undefined}
      />
      <NumberField
        label="Frames per second"
        value={fps}
        step={1}
        unit="per s"
        limit={(one) => Math.min(1000, Math.max(1, Math.round(one)))}
        drag={() => undefined}
        commit={set('fps')}
        cancel={() => undefined}
      />
      <Button
        kind="quiet"
        tip="What the document says of its time: also how fast plants grow"
        press={() => page.choose('animation')}
      >
        {unrolls ? 'Grows over time' : 'Growth…'}
      </Button>
      <span className="stretch" />
      <Button icon="film" press={record}>
        Record…
      </Button>
      <IconButton is_small icon="close" label="Close the timeline" press={() => model.toggle()} />
    </header>
  );
}

/// Opens and closes the timeline.
export function TimeButton(): ReactElement {
  const page = use_page();
  const { is_open } = use_store(page.tool(TimeModel).state);
  return (
    <IconButton icon="clock" label="Timeline" keys="K" is_on={is_open} press={() => page.tool(TimeModel).toggle()} />
  );
}
