// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "meristem/graph/component.h"

namespace meristem {

/// Places for children in a star: the leaflets of a palmate leaf, the petals of a blossom, the needles of a tuft.
struct Hydra : ComponentBase {
  int number = 5;
  double angle = kPi / 2;  ///< radians between the star's heading and its children's
  double size = 0;         ///< metres from the middle to where they stand
  double roll = 0;         ///< radians by which the star is turned about its heading
  double arc = 2 * kPi;    ///< radians of the full turn over which they are spread
};

ComponentType hydra_component();

}  // namespace meristem
