// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "meristem/components/parts/stem_path.h"
#include "meristem/graph/component.h"
#include "meristem/plant/trim.h"

namespace meristem {

/// A stem along a curve that bends and wanders. Children of branch links are placed along it, and stems among them are
/// joined to it as branches.
struct Tree : ComponentBase {
  StemParameters stem;
  double deflection = 0;      ///< bend of the stem away from each of its branches, radians
  BranchPlacement branching;  ///< default positions of branches, for links without their own
  SurfaceOptions surface;
  TrimMode trim = TrimMode::cut;  ///< effect of a body around its stems
};

ComponentType tree_component();

}  // namespace meristem
