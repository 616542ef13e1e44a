// SPDX-License-Identifier: Apache-2.0
// Pinned states beside the present one. Each has its own view and connection, and the present view's camera.
import type { ReactElement } from 'react';
import { useEffect, useRef, useState } from 'react';

import { use_store } from '../base/store.ts';
import { Button, IconButton } from '../controls/button.tsx';
import type { Page } from '../page/page.ts';
import { use_document, use_page } from '../page/use_page.ts';
import { Connection } from '../server/connection.ts';
import { LatestSender } from '../server/latest_sender.ts';
import { read_packet } from '../server/packet.ts';
import { TimeModel } from '../time/time_model.ts';
import { budgets_of } from '../view/budgets.ts';
import { View } from '../view/view.ts';
import type { Pin } from './pins.ts';
import { PinList } from './pins.ts';

export function PinnedViews(): ReactElement {
  const pins = use_store(use_page().tool(PinList).shown);
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
  const page = use_page();
  const pins = use_store(page.tool(PinList).shown);
  const pin = (): void => page.tool(PinList).add(page.document.state.get());
  return (
    <IconButton
      icon="pin"
      label={pins.length < 2 ? 'Pin this state beside the view' : 'Two states are pinned'}
      is_off={pins.length >= 2}
      press={pin}
    />
  );
}

function PinnedView({ pin }: { pin: Pin }): ReactElement {
  const page = use_page();
  const { text } = use_document();
  const canvas = useRef<HTMLCanvasElement>(null);
  const [note, set_note] = useState('Growing…');
  useEffect(() => (canvas.current ? show_pin(page, pin, canvas.current, set_note) : undefined), [page, pin]);
  return (
    <section className="pinned" data-pin={pin.name} aria-label={`Pinned state ${pin.name}`}>
      <canvas
        ref={canvas}
        tabIndex={0}
        role="application"
        aria-label={`The plant of the pinned state ${pin.name}, seen as the plant beside it`}
      />
      <div className="pinned-tools">
        <b>{pin.name}</b>
        <Button
          kind="quiet"
          is_off={text === pin.text}
          tip="Makes this the document again, as one step"
          press={() => void page.document.replace(pin.text, `Take state ${pin.name}`)}
        >
          Take
        </Button>
        <IconButton
          is_small
          icon="close"
          label={`Let state ${pin.name} go`}
          press={() => page.tool(PinList).remove(pin.id)}
        />
      </div>
      {note !== '' && <p className="view-note">{note}</p>}
    </section>
  );
}

/// Grows a pin's text over its own connection and draws it. Returns a function that ends this.
function show_pin(page: Page, pin: Pin, canvas: HTMLCanvasElement, say: (note: string) => void): () => void {
  const main = page.view;
  if (!main) {
    say('This browser draws no second view');
    return () => undefined;
  }
  const view = new View(canvas, {
    drawn: () => main.follow(view),
    restored: () => connection.tell('all'),
  });
  const dress = (): void => {
    const { drawing, hidden, shows_ground } = page.view_state.get();
    view.show(drawing, hidden, '');
    view.paint(page.shell.get().is_dark, shows_ground);
  };
  const open = async (): Promise<void> => {
    connection.tell('view', { ...budgets_of(main), ...page.tool(TimeModel).request });
    const { text, path, model } = pin;
    const opened = await connection.request('open', model !== null ? { text, model } : { text, path });
    if (!opened.good) say('This state has faults');
  };
  const connection = new Connection(page.address, {
    on_message: (message) => {
      if (message.is === 'hello') void open().catch((fault: Error) => say(fault.message));
      if (message.is === 'failed') say(message.message);
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
  const times = new LatestSender(() => connection.request('view', page.tool(TimeModel).request));
  let time = page.tool(TimeModel).time;
  const follow_time = (): void => {
    if (time === page.tool(TimeModel).time) return;
    time = page.tool(TimeModel).time;
    times.ask();
  };
  const stops = [
    page.tool(TimeModel).state.subscribe(follow_time),
    page.view_facts.subscribe(() => view.follow(main)),
    page.view_state.subscribe(dress),
    page.shell.subscribe(dress),
  ];
  view.follow(main);
  connection.connect();
  return () => {
    for (const stop of stops) stop();
    connection.close();
    view.destroy();
  };
}
