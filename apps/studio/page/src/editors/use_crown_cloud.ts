// SPDX-License-Identifier: Apache-2.0
import { useEffect, useMemo } from 'react';

import { use_store } from '../base/store.ts';
import { use_document, use_page } from '../page/use_page.ts';
import { path_of, steps_of, value_at } from '../values/path.ts';
import { azimuths_of, CrownCloud, turned_points } from './crown_cloud.ts';
import type { Point } from './shape.ts';

const kNone: readonly Point[] = [];

/// Returns the attraction points behind the outline at a path, updated after each growth. Returns an empty list if
/// `path` is null, or if no component fills that crown with points.
export function use_crown_cloud(path: string | null): readonly Point[] {
  const page = use_page();
  const { tree } = use_document();
  const { grown } = use_store(page.growth);
  const crown_cloud = page.tool(CrownCloud);
  const told = use_store(crown_cloud.told);
  const steps = path === null ? [] : steps_of(path);
  const component = steps[0] === 'components' && steps[2] === 'crown' && typeof steps[1] === 'string' ? steps[1] : null;
  useEffect(() => {
    if (component !== null && grown) crown_cloud.follow(component, grown);
  }, [crown_cloud, component, grown]);
  const at = steps.lastIndexOf('profiles');
  const azimuth = at < 0 ? null : Number(steps[at + 1]);
  const others = at < 0 ? '' : azimuths_of(value_at(tree, path_of(steps.slice(0, at + 1)))).join(' ');
  return useMemo(() => {
    if (!told || told.component !== component) return kNone;
    return turned_points(told.positions, azimuth, others === '' ? [] : others.split(' ').map(Number));
  }, [told, component, azimuth, others]);
}
