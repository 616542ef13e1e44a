// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "meristem/graph/component.h"

namespace meristem {

/// Places for children in a star.
struct Hydra : ComponentBase {
  int number = 6;
  PerChild angle = kPi / 2;  ///< radians between the star's heading and a child's
  PerChild radius = 0.0;     ///< metres from the middle to where a child stands, along its heading
  PerChild size = 1.0;       ///< scale of a child
  PerChild roll = 0.0;       ///< radians about the heading, on top of the even turn
  double arc = 2 * kPi;      ///< radians over which children are spread; a whole turn or more: all around
};

ComponentType hydra_component();

}  // namespace meristem
