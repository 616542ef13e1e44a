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
import type { Tools } from './page/tools.ts';
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

  constructor(page: Page, tools: Tools) {
    this.pins = tools.add(new PinList());
    this.derivation = tools.add(new DerivationModel(page));
    this.pruning = tools.add(new Pruning(page));
    this.gizmo = tools.add(new Gizmo(page));
    this.leaf_curves = tools.add(new LeafCurvesModel(page));
    this.crown_cloud = tools.add(new CrownCloud(page));
    this.time = tools.add(new TimeModel(page));
    this.measures = tools.add(new MeasureModel(page));
    this.recordings = tools.add(new Recordings(page));
    this.growth_look = tools.add(new GrowthLook(page));
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
