// SPDX-License-Identifier: Apache-2.0
// Exports a film of the document, or a picture for each of its frames. The server draws them while the page stays
// usable.
import type { ReactElement } from 'react';
import { useState } from 'react';

import { use_store } from '../base/store.ts';
import { Button, Segments } from '../controls/button.tsx';
import { Dialog } from '../controls/dialog.tsx';
import { NumberLine } from '../controls/number_line.tsx';
import { use_document, use_page } from '../page/use_page.ts';
import type { ExportOptions } from '../server/protocol.ts';
import { TimeModel } from '../time/time_model.ts';
import { Made } from './export_dialog.tsx';
import { ExportFooter } from './export_footer.tsx';
import { Recordings } from './recording.ts';

const kSizes = [
  ['640x360', '640 × 360'],
  ['1280x720', '1280 × 720'],
  ['1920x1080', '1920 × 1080'],
] as const;
const kFilms: Record<string, string> = { '.mp4': 'MP4 film', '.webm': 'WebM film' };
type Size = (typeof kSizes)[number][0];

export function RecordDialog({ close }: { close: () => void }): ReactElement {
  const page = use_page();
  const { hello } = use_store(page.server);
  const { working } = use_store(page.growth);
  const { good } = use_document();
  const made = use_store(page.tool(Recordings).film.made);
  const is_busy = use_store(page.tool(Recordings).film.is_busy);
  const { length, fps } = page.tool(TimeModel).animation;
  const endings = ['.mp4', '.webm'].filter((one) => hello?.formats.some((format) => format.ending === one));
  const [ending, set_ending] = useState(endings[0] ?? '.png');
  const [from, set_from] = useState(0);
  const [to, set_to] = useState(length);
  const [rate, set_rate] = useState(fps);
  const [size, set_size] = useState<Size>('1280x720');
  const [samples, set_samples] = useState(16);
  const [as_seen, set_as_seen] = useState(true);
  const frames = Math.floor((to - from) * rate + 1e-6) + 1;
  const [width, height] = size.split('x').map(Number) as [number, number];
  const camera = as_seen ? page.view?.orbit.as_document : undefined;
  const options: ExportOptions = {
    width,
    height,
    samples,
    frames: { from, to, step: 1 / rate },
    ...(camera ? { camera } : {}),
  };
  const request = { format: ending, name: null, options };
  const footer = (
    <ExportFooter request={request}>
      {is_busy && <Button press={() => page.tool(Recordings).film.cancel()}>Cancel</Button>}
      <Button kind="main" icon="film" is_off={is_busy || !good} press={() => page.tool(Recordings).film.make(request)}>
        {is_busy ? 'Recording…' : `Record ${frames} frames`}
      </Button>
    </ExportFooter>
  );
  return (
    <Dialog title="Record" close={close} footer={footer}>
      <div className="field-line">
        <span>As</span>
        <Segments
          label="What is recorded"
          value={ending}
          choices={[
            ...endings.map((one) => [one, kFilms[one] ?? one] as const),
            ['.png', 'PNG each'],
            ['.jpg', 'JPEG each'],
          ]}
          choose={set_ending}
        />
      </div>
      {endings.length === 0 && (
        <p className="quiet">
          Films need the program ffmpeg beside the studio. Without it, all frames come as pictures in one archive.
        </p>
      )}
      <NumberLine label="From" unit="s" value={from} step={0.1} low={0} high={to} set={set_from} />
      <NumberLine label="To" unit="s" value={to} step={0.1} low={from} high={1e6} set={set_to} />
      <NumberLine
        label="Frames per second"
        value={rate}
        step={1}
        low={1}
        high={120}
        set={(one) => set_rate(Math.round(one))}
      />
      <div className="field-line">
        <span>Size, pixels</span>
        <Segments label="Size in pixels" value={size} choices={kSizes} choose={set_size} />
      </div>
      <NumberLine
        label="Samples"
        value={samples}
        step={4}
        low={1}
        high={1024}
        set={(one) => set_samples(Math.round(one))}
      />
      <label className="check-line">
        <input type="checkbox" checked={as_seen} onChange={(event) => set_as_seen(event.target.checked)} />
        From where the view looks
      </label>
      {is_busy && (
        <p className="record-progress" role="status">
          <progress
            max={1}
            value={working?.job === 'export' ? working.share : undefined}
            aria-label="Progress of the recording"
          />
          <span className="quiet">
            {working?.job === 'export' ? working.stage : 'waits'}; the window may be closed, the recording goes on
          </span>
        </p>
      )}
      {made && <Made file={made} />}
    </Dialog>
  );
}
