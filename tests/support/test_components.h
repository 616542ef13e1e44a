// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "meristem/graph/component.h"

namespace meristem {

/// Small components with plain geometry, for tests of the graph's mechanism:
///
/// - `camera`: the root.
/// - `stick` (`length`, `width`, `sides`): a triangle as wide and high as it says; children stand at its top.
/// - `star` (`number`, `step`): nothing; children stand `step` metres apart along x.
/// - `ribs` (`number`): nothing; branch children stand along y, others at its end. With number 0 no branch children.
/// - `pole` (`height`, `nodes`): a straight stem upward from its site, of radius 0.01 m.
/// - `space` (`down`): nothing; says which way gravity pulls for all below it, unset: as in the scene.
const Registry& test_components();

}  // namespace meristem
