// SPDX-License-Identifier: Apache-2.0
// The bottom line: the shown share of the plant, the time of its growth, and running work.
import type { ReactElement } from 'react';

import { use_store } from '../base/store.ts';
import { IconButton } from '../controls/button.tsx';
import { Icon } from '../controls/icon.tsx';
import { use_document, use_page } from '../page/use_page.ts';
import type { Grown } from '../server/protocol.ts';

const count = (number: number): string => number.toLocaleString('en');
const counted = (number: number, what: string): string => `${count(number)} ${what}${number === 1 ? '' : 's'}`;

export function StatusLine(): ReactElement {
  const page = use_page();
  const { shown, grown } = use_store(page.growth);
  const { link, hello } = use_store(page.server);
  return (
    <footer className="status" aria-label="Status">
      <span
        className={`link ${link}`}
        data-tip={hello ? `Meristem ${hello.version}, files below ${hello.root}` : undefined}
      >
        <span className="dot" />
        {link === 'open' ? 'Connected' : link === 'lost' ? 'Connection lost' : 'Connecting'}
      </span>
      <FaultCount />
      {shown && (
        <span
          data-tip={
            shown.draft
              ? 'A coarser draft; more triangles follow'
              : shown.triangles < shown.of.triangles
                ? 'A coarser level for drawing; exports are whole'
                : 'All there is'
          }
        >
          <b>{count(shown.triangles)}</b> of {(shown.share ?? 1) < 1 ? 'about ' : ''}
          {count(shown.of.triangles)} triangles{shown.draft ? ' (draft)' : ''}
        </span>
      )}
      {shown && <span>{counted(shown.of.instances, 'instance')}</span>}
      {shown && <span>{counted(shown.of.nodes, 'node')}</span>}
      <span className="stretch" />
      {grown && <Stages grown={grown} />}
      <Work />
    </footer>
  );
}

function FaultCount(): ReactElement | null {
  const page = use_page();
  const { faults } = use_document();
  if (faults.length === 0) return null;
  const errors = faults.filter((one) => one.severity === 'error').length;
  const warnings = faults.length - errors;
  const text = [
    errors > 0 ? `${errors} ${errors === 1 ? 'fault' : 'faults'}` : '',
    warnings > 0 ? `${warnings} ${warnings === 1 ? 'warning' : 'warnings'}` : '',
  ]
    .filter(Boolean)
    .join(', ');
  return (
    <button
      type="button"
      className={`fault-count${errors > 0 ? ' error' : ''}`}
      data-tip={faults[0]?.message}
      onClick={() => page.shell.merge({ side: 'text' })}
    >
      <Icon name={errors > 0 ? 'fault' : 'warning'} />
      {text}
    </button>
  );
}

function Stages({ grown }: { grown: Grown }): ReactElement {
  const total = grown.stages.reduce((sum, one) => sum + one.ms, 0);
  const made = grown.reuse.reduce((sum, one) => sum + one.made, 0);
  const reused = grown.reuse.reduce((sum, one) => sum + one.reused, 0);
  const lines = [
    ...grown.stages.map((one) => `${one.name}: ${milliseconds(one.ms)}`),
    ...grown.reuse.map((one) => `${one.what}: ${count(one.made)} made, ${count(one.reused)} kept`),
  ];
  return (
    <span className="stages" tabIndex={0} data-tip={lines.join('\n')}>
      {milliseconds(total)}
      {reused > 0 && <span className="quiet"> · {Math.round((100 * reused) / (made + reused))} % kept</span>}
    </span>
  );
}

function milliseconds(ms: number): string {
  return ms >= 1000 ? `${(ms / 1000).toFixed(1)} s` : ms >= 10 ? `${Math.round(ms)} ms` : `${ms.toFixed(1)} ms`;
}

function Work(): ReactElement {
  const page = use_page();
  const { working, is_paused } = use_store(page.growth);
  const pause = (): void => {
    page.growth.merge({ is_paused: !is_paused });
    page.connection.tell('pause', { paused: !is_paused });
  };
  return (
    <span className="work-in-hand">
      {working && (
        <>
          <span className="quiet">{working.stage}</span>
          <progress max={1} value={working.share} aria-label="Progress" />
          <IconButton
            is_small
            icon="stop"
            label="Cancel"
            press={() => page.connection.tell('cancel', working.re === undefined ? {} : { re: working.re })}
          />
        </>
      )}
      {!working && is_paused && <span className="quiet">Growth is paused</span>}
      <IconButton
        is_small
        icon={is_paused ? 'play' : 'pause'}
        label={is_paused ? 'Go on growing' : 'Pause growing'}
        is_on={is_paused}
        press={pause}
      />
    </span>
  );
}
