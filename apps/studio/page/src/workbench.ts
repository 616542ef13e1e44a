// SPDX-License-Identifier: Apache-2.0
// Tools that are open beside the document: a large editor, a strip of plants, pinned states, a derivation, a growth.
import { Store } from './base/store.ts';
import { CrownCloud } from './editors/crown_cloud.ts';
import { PinList } from './find/pins.ts';
import { DerivationModel } from './grammar/derivation.ts';
import { LeafCurvesModel } from './grass/leaf_curves.ts';
import { GrowthLook } from './growth/growth_look.ts';
import { MeasureModel } from './measures/measure_model.ts';
import { Pruning } from './pruning/pruning.ts';
import type { Studio } from './studio.ts';
import { Recording } from './dialogs/recording.ts';
import { TimeModel } from './time/time_model.ts';
import { Gizmo } from './gizmo/gizmo.ts';

export class Workbench {
  readonly enlarged = new Store<string | null>(null); // path of the row with the large editor
  readonly strip = new Store<string | null>(null); // path of the row whose strip of plants is shown
  readonly pins = new PinList();
  readonly derivation: DerivationModel;
  readonly pruning: Pruning;
  readonly gizmo: Gizmo;
  readonly leaf_curves: LeafCurvesModel;
  readonly crown_cloud: CrownCloud;

  readonly time: TimeModel;
  readonly measures: MeasureModel;
  readonly record: Recording;
  readonly still: Recording;
  readonly growth_look: GrowthLook;

  constructor(studio: Studio) {
    this.derivation = new DerivationModel(studio);
    this.pruning = new Pruning(studio);
    this.gizmo = new Gizmo(studio);
    this.leaf_curves = new LeafCurvesModel(studio);
    this.crown_cloud = new CrownCloud(studio);
    this.time = new TimeModel(studio);
    this.measures = new MeasureModel(studio);
    this.record = new Recording(studio, true);
    this.still = new Recording(studio, false);
    this.growth_look = new GrowthLook(studio);
  }

  /// Resets the tools for another document.
  clear(): void {
    this.enlarged.set(null);
    this.strip.set(null);
    this.pins.clear();
    this.derivation.forget();
    this.pruning.forget();
    this.gizmo.forget();
    this.leaf_curves.forget();
    this.crown_cloud.forget();
    this.growth_look.clear();
    this.measures.forget();
    this.still.made.set(null);
    this.record.made.set(null);
  }
}
