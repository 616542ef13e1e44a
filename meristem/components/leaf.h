// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "meristem/graph/component.h"
#include "meristem/shape/leaf/leaf_blade.h"

namespace meristem {

/// A leaf. Instances share shapes: varying proportions and angles are rounded, but lengths and widths are exact.
struct Leaf : ComponentBase {
  LeafBlade blade;
};

ComponentType leaf_component();

}  // namespace meristem
