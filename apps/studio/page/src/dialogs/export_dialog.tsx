// SPDX-License-Identifier: Apache-2.0
// Exports files by the server, and shows the command line that makes the same files in a terminal.
import type { ReactElement } from 'react';
import { useState } from 'react';

import { use_store } from '../base/store.ts';
import { Button } from '../controls/button.tsx';
import { Dialog } from '../controls/dialog.tsx';
import { Icon } from '../controls/icon.tsx';
import { NumberLine } from '../controls/number_line.tsx';
import { size_text } from '../files/file_list.tsx';
import { use_document, use_page } from '../page/use_page.ts';
import type { ExportOptions, Format, MadeFile } from '../server/protocol.ts';
import { TimeModel } from '../time/time_model.ts';
import { ExportFooter } from './export_footer.tsx';
import { take_file } from './recording.ts';

type Instances = NonNullable<ExportOptions['instances']>;

const kInstances: readonly (readonly [Instances, string])[] = [
  ['automatic', 'As the size asks'],
  ['rows', 'Rows of places (EXT_mesh_gpu_instancing)'],
  ['nodes', 'A node each, which every program reads'],
] as const;

interface NumberOption {
  name: 'lod' | 'time' | 'width' | 'height' | 'samples';
  label: string;
  unit?: string;
  step: number;
  low: number;
  high: number;
  fallback: number;
}

const kLevel: NumberOption = { name: 'lod', label: 'Coarser levels', step: 1, low: 0, high: 8, fallback: 0 };
const kTime: NumberOption = { name: 'time', label: 'Time', unit: 's', step: 0.1, low: 0, high: 1e6, fallback: 0 };
const kPicture: NumberOption[] = [
  { name: 'width', label: 'Width', unit: 'px', step: 10, low: 16, high: 8192, fallback: 1200 },
  { name: 'height', label: 'Height', unit: 'px', step: 10, low: 16, high: 8192, fallback: 1200 },
  { name: 'samples', label: 'Samples', step: 4, low: 1, high: 1024, fallback: 64 },
];

function is_picture(ending: string): boolean {
  return /\.?(png|jpg)$/.test(ending);
}

function options_of(format: Format | undefined): NumberOption[] {
  if (!format) return [];
  const options = format.levels ? [kLevel] : [];
  return is_picture(format.ending) ? [...options, kTime, ...kPicture] : [...options, kTime];
}

export function ExportDialog({ close }: { close: () => void }): ReactElement {
  const page = use_page();
  const { hello } = use_store(page.server);
  const { working } = use_store(page.growth);
  const { good } = use_document();
  // Films are exported from the timeline.
  const formats = hello?.formats.filter((one) => !/\.(mp4|webm)$/.test(one.ending)) ?? [];
  const [ending, set_ending] = useState(formats[0]?.ending ?? '.glb');
  const [options, set_options] = useState<ExportOptions>(
    page.tool(TimeModel).time > 0 ? { time: page.tool(TimeModel).time } : {},
  );
  const [made, set_made] = useState<MadeFile | null>(null);
  const [is_busy, set_busy] = useState(false);
  const format = formats.find((one) => one.ending === ending);
  const [as_seen, set_as_seen] = useState(true);
  const camera = is_picture(ending) && as_seen ? page.view?.orbit.as_document : undefined;
  const request = { format: ending, name: null, options: camera ? { ...options, camera } : options };
  const make = (): void => {
    set_busy(true);
    set_made(null);
    page.connection
      .request('export', request)
      .then((answer) => {
        set_made(answer.file);
        take_file(answer.file);
      })
      .catch((fault: Error) => page.notify(fault.message, true))
      .finally(() => set_busy(false));
  };
  const footer = (
    <ExportFooter request={request}>
      <Button kind="main" icon="export" is_off={is_busy || !good} press={make}>
        {is_busy ? 'Exporting…' : 'Export'}
      </Button>
    </ExportFooter>
  );
  return (
    <Dialog title="Export" close={close} footer={footer}>
      <div className="formats" role="radiogroup" aria-label="Format">
        {formats.map((one) => (
          <label key={one.ending} className="format">
            <input type="radio" name="format" checked={one.ending === ending} onChange={() => set_ending(one.ending)} />
            <b>{one.ending}</b>
            <span className="quiet">{one.doc}</span>
          </label>
        ))}
      </div>
      {options_of(format).map(({ name, fallback, ...form }) => (
        <NumberLine
          key={name}
          {...form}
          value={options[name] ?? fallback}
          set={(value) => set_options({ ...options, [name]: value })}
        />
      ))}
      {format?.instances && (
        <div className="field-line">
          <label htmlFor="instances">Leaves and organs</label>
          <select
            id="instances"
            className="select"
            value={options.instances ?? 'automatic'}
            onChange={(event) => set_options({ ...options, instances: event.target.value as Instances })}
          >
            {kInstances.map(([name, text]) => (
              <option key={name} value={name}>
                {text}
              </option>
            ))}
          </select>
        </div>
      )}
      {is_picture(ending) && (
        <label className="check-line">
          <input type="checkbox" checked={as_seen} onChange={(event) => set_as_seen(event.target.checked)} />
          From where the view looks
        </label>
      )}
      {ending.endsWith('png') && (
        <label className="check-line">
          <input
            type="checkbox"
            checked={options.transparent ?? false}
            onChange={(event) => set_options({ ...options, transparent: event.target.checked })}
          />
          Transparent background
        </label>
      )}
      {is_busy && (
        <progress
          max={1}
          value={working?.job === 'export' ? working.share : undefined}
          aria-label="Progress of the export"
        />
      )}
      {made && <Made file={made} />}
    </Dialog>
  );
}

export function Made({ file }: { file: MadeFile }): ReactElement {
  return (
    <div className="made-file" role="status">
      <a href={file.address} download={file.name}>
        <Icon name="check" />
        {file.name}
      </a>
      <span className="quiet">{size_text(file.bytes)}</span>
      {file.holds.length > 0 && <p className="quiet">with {file.holds.join(', ')}</p>}
    </div>
  );
}
