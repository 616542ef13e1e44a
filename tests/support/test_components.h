// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "meristem/graph/component.h"

namespace meristem {

/// Small components with simple geometry for tests of the graph:
///
/// - `camera`: the root.
/// - `stick` (`length`, `width`, `sides`): a triangle of this height and width; children are at its top.
/// - `star` (`number`, `step`): no geometry; children are `step` metres apart along x.
/// - `ribs` (`number`): no geometry; branch children are along y, other children at its end. No branch children if
///   `number` is 0.
/// - `pole` (`height`, `nodes`): a straight vertical stem from its site, with radius 0.01 m.
/// - `sprout` (`height`, `alone`, `watches`): grows a straight vertical stem in two steps. Its height is divided by the
///   number of sprouts in its stand. If `watches` is true, it shows the growth of the component that it shows.
/// - `timer` (`delay`, `speed`): no geometry; begins a clock for its descendants.
/// - `space` (`down`): no geometry; sets the direction of gravity for its descendants. Unset: as in the scene.
const Registry& test_components();

}  // namespace meristem
