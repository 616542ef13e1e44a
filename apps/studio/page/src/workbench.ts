// SPDX-License-Identifier: Apache-2.0
// Tools that are open beside the document: pinned states, a derivation, operations, grips, times, measures, a growth.
import { Recordings } from './dialogs/recording.ts';
import { CrownCloud } from './editors/crown_cloud.ts';
import { PinList } from './find/pins.ts';
import { Gizmo } from './gizmo/gizmo.ts';
import { DerivationModel } from './grammar/derivation.ts';
import { LeafCurvesModel } from './grass/leaf_curves.ts';
import { GrowthLook } from './growth/growth_look.ts';
import { MeasureModel } from './measures/measure_model.ts';
import type { Page } from './page/page.ts';
import { Pruning } from './pruning/pruning.ts';
import { TimeModel } from './time/time_model.ts';

export class Workbench {
  readonly pins: PinList;
  readonly derivation: DerivationModel;
  readonly pruning: Pruning;
  readonly gizmo: Gizmo;
  readonly leaf_curves: LeafCurvesModel;
  readonly crown_cloud: CrownCloud;
  readonly time: TimeModel;
  readonly measures: MeasureModel;
  readonly recordings: Recordings;
  readonly growth_look: GrowthLook;

  /// `add` makes a tool known to the page and returns it.
  constructor(page: Page, add: <T extends object>(tool: T) => T) {
    this.pins = add(new PinList());
    this.derivation = add(new DerivationModel(page));
    this.pruning = add(new Pruning(page));
    this.gizmo = add(new Gizmo(page));
    this.leaf_curves = add(new LeafCurvesModel(page));
    this.crown_cloud = add(new CrownCloud(page));
    this.time = add(new TimeModel(page));
    this.measures = add(new MeasureModel(page));
    this.recordings = add(new Recordings(page));
    this.growth_look = add(new GrowthLook(page));
  }

  /// Resets the tools for another document.
  clear(): void {
    this.pins.clear();
    this.derivation.forget();
    this.pruning.forget();
    this.gizmo.forget();
    this.leaf_curves.forget();
    this.crown_cloud.forget();
    this.growth_look.clear();
    this.measures.forget();
    this.recordings.forget();
  }
}
