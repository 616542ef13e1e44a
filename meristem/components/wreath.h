// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "meristem/graph/component.h"

namespace meristem {

/// Places for children on a ring.
struct Wreath : ComponentBase {
  int number = 8;
  double diameter = 0.1;     ///< metres
  PerChild angle = kPi / 2;  ///< radians between the ring's heading and a child's; a right angle: straight outward
  PerChild size = 1.0;       ///< scale of a child
  PerChild roll = 0.0;       ///< radians about the heading, on top of the even turn
  double arc = 2 * kPi;      ///< radians over which children are spread; a whole turn or more: all around
};

ComponentType wreath_component();

}  // namespace meristem
