// SPDX-License-Identifier: Apache-2.0
// A picture by the path tracer, from the view's camera and at its time. It is shown here when it is ready.
import type { ReactElement } from 'react';
import { useState } from 'react';

import { use_store } from '../base/store.ts';
import { Button, Segments } from '../controls/button.tsx';
import { Dialog } from '../controls/dialog.tsx';
import { use_document, use_page } from '../page/use_page.ts';
import type { ExportOptions } from '../server/protocol.ts';
import { TimeModel } from '../time/time_model.ts';
import { Made } from './export_dialog.tsx';
import { ExportFooter } from './export_footer.tsx';
import { Recordings } from './recording.ts';

const kSizes = [
  ['640', '640'],
  ['1280', '1,280'],
  ['1920', '1,920'],
  ['3840', '3,840'],
] as const;
const kSamples = [
  ['8', 'Quick'],
  ['32', 'Good'],
  ['128', 'Fine'],
  ['512', 'Finest'],
] as const;

export function StillDialog({ close }: { close: () => void }): ReactElement {
  const page = use_page();
  const still = page.tool(Recordings).still;
  const { working } = use_store(page.growth);
  const { good } = use_document();
  const made = use_store(still.made);
  const is_busy = use_store(still.is_busy);
  const [width, set_width] = useState<(typeof kSizes)[number][0]>('1280');
  const [samples, set_samples] = useState<(typeof kSamples)[number][0]>('32');
  const [transparent, set_transparent] = useState(false);
  const { view } = page;
  const height = Math.max(16, Math.round(Number(width) / (view?.orbit.camera.aspect ?? 4 / 3)));
  const { time } = page.tool(TimeModel);
  const options: ExportOptions = {
    width: Number(width),
    height,
    samples: Number(samples),
    ...(transparent ? { transparent } : {}),
    ...(time > 0 ? { time } : {}),
    ...(view ? { camera: view.orbit.as_document } : {}),
  };
  const request = { format: '.png', name: null, options };
  const footer = (
    <ExportFooter request={request}>
      {is_busy && <Button press={() => still.cancel()}>Cancel</Button>}
      <Button kind="main" icon="camera" is_off={is_busy || !good} press={() => still.make(request)}>
        {is_busy ? 'Rendering…' : 'Render'}
      </Button>
    </ExportFooter>
  );
  return (
    <Dialog title="Still" width="wide" close={close} footer={footer}>
      <div className="still-options">
        <span>Width, pixels</span>
        <Segments label="Width in pixels" value={width} choices={kSizes} choose={set_width} />
        <span>Light paths</span>
        <Segments label="Light paths per pixel" value={samples} choices={kSamples} choose={set_samples} />
        <label className="check-line">
          <input type="checkbox" checked={transparent} onChange={(event) => set_transparent(event.target.checked)} />
          Without sky and ground
        </label>
      </div>
      <div className="still-frame" style={{ aspectRatio: `${width} / ${height}` }} aria-busy={is_busy}>
        {made ? (
          <img src={made.address} alt="The plant, rendered" />
        ) : (
          !is_busy && (
            <p className="quiet">
              {width} × {height} pixels, seen as the view is, in the light of the document’s scene.
            </p>
          )
        )}
        {is_busy && (
          <p className="record-progress" role="status">
            <progress
              max={1}
              value={working?.job === 'export' ? working.share : undefined}
              aria-label="Progress of the still"
            />
            <span className="quiet">{working?.job === 'export' ? working.stage : 'waits'}</span>
          </p>
        )}
      </div>
      {made && <Made file={made} />}
    </Dialog>
  );
}
