// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "meristem/graph/component.h"
#include "meristem/shape/leaf/leaf_blade.h"

namespace meristem {

/// A leaf. Instances share shapes: proportions and angles that vary are rounded for the shape (below), lengths and
/// widths are exact.
struct Leaf : ComponentBase {
  LeafBlade blade;
};

ComponentType leaf_component();

}  // namespace meristem
