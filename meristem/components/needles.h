// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "meristem/graph/component.h"
#include "meristem/shape/leaf/needles.h"

namespace meristem {

/// The needles of a shoot or a tuft. Instances share shapes: proportions and varying angles are rounded, and each
/// instance is one of a few variants.
struct Needles : ComponentBase {
  NeedleShoot shoot;
  int variants = 4;
};

ComponentType needles_component();

}  // namespace meristem
