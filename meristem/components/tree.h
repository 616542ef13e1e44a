// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "meristem/components/parts/stem_path.h"
#include "meristem/graph/component.h"
#include "meristem/plant/trim.h"

namespace meristem {

/// A stem along a curve that bends and wanders. What hangs on it by branch links stands along it, stems among that join
/// it as its branches.
struct Tree : ComponentBase {
  StemParameters stem;
  double deflection = 0;  ///< radians: bend away from each of its branches
  Placement branching;    ///< where they stand, as far as links do not say
  Surface surface;
  TrimMode trim = TrimMode::cut;  ///< what a body around its stems does to them
};

ComponentType tree_component();

}  // namespace meristem
