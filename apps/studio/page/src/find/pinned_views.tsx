// SPDX-License-Identifier: Apache-2.0
// Pinned states beside the present one. Each has its own view and connection, and the present view's camera.
import type { ReactElement } from 'react';
import { useEffect, useRef, useState } from 'react';

import { use_store } from '../base/store.ts';
import { Button, IconButton } from '../controls/button.tsx';
import { Connection } from '../server/connection.ts';
import { LatestSender } from '../server/latest_sender.ts';
import { read_packet } from '../server/packet.ts';
import type { Opened } from '../server/protocol.ts';
import type { Studio } from '../studio.ts';
import { use_document, use_studio } from '../page/use_page.ts';
import { budgets_of } from '../view/budgets.ts';
import { View } from '../view/view.ts';
import type { Pin } from './pins.ts';

export function PinnedViews(): ReactElement {
  const pins = use_store(use_studio().bench.pins.shown);
  return (
    <>
      {pins.map((pin) => (
        <PinnedView key={pin.id} pin={pin} />
      ))}
    </>
  );
}

/// Pins the present state of the text.
export function PinButton(): ReactElement {
  const studio = use_studio();
  const pins = use_store(studio.bench.pins.shown);
  const pin = (): void => studio.bench.pins.add(studio.document.state.get());
  return <IconButton icon="pin" label={pins.length < 2 ? 'Pin this state beside the view' : 'Two states are pinned'} is_off={pins.length >= 2} press={pin} />;
}

function PinnedView({ pin }: { pin: Pin }): ReactElement {
  const studio = use_studio();
  const { text } = use_document();
  const canvas = useRef<HTMLCanvasElement>(null);
  const [note, set_note] = useState('Growing…');
  useEffect(() => (canvas.current ? show_pin(studio, pin, canvas.current, set_note) : undefined), [studio, pin]);
  return (
    <section className="pinned" data-pin={pin.name} aria-label={`Pinned state ${pin.name}`}>
      <canvas ref={canvas} tabIndex={0} role="application" aria-label={`The plant of the pinned state ${pin.name}, seen as the plant beside it`} />
      <div className="pinned-tools">
        <b>{pin.name}</b>
        <Button kind="quiet" is_off={text === pin.text} tip="Makes this the document again, as one step" press={() => void studio.document.replace(pin.text, `Take state ${pin.name}`)}>
          Take
        </Button>
        <IconButton is_small icon="close" label={`Let state ${pin.name} go`} press={() => studio.bench.pins.remove(pin.id)} />
      </div>
      {note !== '' && <p className="view-note">{note}</p>}
    </section>
  );
}

/// Grows a pin's text over its own connection and draws it. Returns a function that ends this.
function show_pin(studio: Studio, pin: Pin, canvas: HTMLCanvasElement, say: (note: string) => void): () => void {
  const main = studio.view;
  if (!main) {
    say('This browser draws no second view');
    return () => undefined;
  }
  const view = new View(canvas, {
    drawn: () => main.follow(view),
    restored: () => connection.tell('all'),
  });
  const dress = (): void => {
    const { drawing, hidden, shows_ground } = studio.view_state.get();
    view.show(drawing, hidden, '');
    view.paint(studio.shell.get().is_dark, shows_ground);
  };
  const open = async (): Promise<void> => {
    connection.tell('view', { ...budgets_of(main), ...studio.bench.time.wish });
    const { text, path, model } = pin;
    const opened = await connection.request<Opened>('open', model !== null ? { text, model } : { text, path });
    if (!opened.good) say('This state has faults');
  };
  const connection = new Connection(studio.address, {
    on_news: (news) => {
      if (news.is === 'hello') void open().catch((fault: Error) => say(fault.message));
      if (news.is === 'failed') say(news.message);
    },
    on_packet: (bytes) => {
      const packet = read_packet(bytes);
      packet.head.fit = false; // it has the camera of the main view
      view.apply(packet);
      view.follow(main);
      dress();
      say('');
      void view.drawn().then(() => connection.tell('shown', { packet: packet.head.packet }));
    },
    on_lost: () => say('The server is gone'),
  });
  // A pin shows the document at the time of the main view.
  const times = new LatestSender(() => connection.request('view', studio.bench.time.wish));
  let time = studio.bench.time.time;
  const follow_time = (): void => {
    if (time === studio.bench.time.time) return;
    time = studio.bench.time.time;
    times.ask();
  };
  const stops = [studio.bench.time.state.subscribe(follow_time), studio.view_facts.subscribe(() => view.follow(main)), studio.view_state.subscribe(dress), studio.shell.subscribe(dress)];
  view.follow(main);
  connection.connect();
  return () => {
    for (const stop of stops) stop();
    connection.close();
    view.destroy();
  };
}
