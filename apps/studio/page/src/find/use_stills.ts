// SPDX-License-Identifier: Apache-2.0
// Small pictures of states of the document, made by the server, and made again when the document changes.
import { useEffect, useState } from 'react';
import type { Page } from '../page/page.ts';
import { use_document, use_page } from '../page/use_page.ts';
import type { ExportCamera, Still } from '../server/protocol.ts';
import type { Json } from '../values/json.ts';

export type StateValues = Record<string, Json>;

export interface Stills {
  stills: Still[]; // empty until they are ready
  is_working: boolean;
  fault: string;
}

interface StillSize {
  width: number;
  height: number;
}

const kPause = 80; // ms after the last change
const kUsualCamera: ExportCamera = { position: [3, 1.5, 4], target: [0, 1, 0], field_of_view: 32 };
const kNear = 0.6; // share of the distance from which everything is visible; nearer, the user looks at a part

/// Returns the camera of the view. A view close to a part shows this part; any other view shows the whole plant.
function camera_of(page: Page): { camera: ExportCamera; fit: boolean } {
  const { view } = page;
  if (!view) return { camera: kUsualCamera, fit: true };
  return { camera: view.orbit.as_document, fit: view.orbit.distance > kNear * view.fitting_distance };
}

export async function ask_for_stills(page: Page, states: readonly StateValues[], size: StillSize): Promise<Still[]> {
  const answer = await page.connection.request('stills', { states, ...size, ...camera_of(page) });
  return answer.stills ?? [];
}

/// Returns pictures of these states. The server makes only the pictures requested last by any part of the page. Without
/// states, there is no request.
export function use_stills(states: readonly StateValues[], size: StillSize): Stills {
  const page = use_page();
  const { hash, good } = use_document();
  const [made, set_made] = useState<Stills>({ stills: [], is_working: false, fault: '' });
  const key = JSON.stringify([states, size]);
  useEffect(() => {
    if (states.length === 0 || !good) return undefined;
    let is_wanted = true;
    set_made((before) => ({ ...before, is_working: true }));
    const take = (stills: Still[]): void => {
      if (is_wanted) set_made({ stills, is_working: false, fault: '' });
    };
    const fail = (fault: Error): void => {
      if (is_wanted) set_made((before) => ({ ...before, is_working: false, fault: fault.message }));
    };
    const timer = setTimeout(() => void ask_for_stills(page, states, size).then(take, fail), kPause);
    return () => {
      is_wanted = false;
      clearTimeout(timer);
    };
    // `key` represents states and size.
  }, [page, hash, good, key]);
  return made;
}
