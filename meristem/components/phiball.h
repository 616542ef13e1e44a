// SPDX-License-Identifier: Apache-2.0
// Children on a zone of a sphere, each turned from the one before by the golden angle and set lower by the area that
// it takes.
//
// Based on: the report on rule-based objects in xfrog, after J. N. Ridley: Packing efficiency in sunflower heads
// (1982).
#pragma once

#include "meristem/graph/component.h"

namespace meristem {

/// Where the children of a phiball stand.
struct Phiball : ComponentBase {
  Count number = 50;
  std::optional<double> radius;  ///< of the sphere, metres; 0.1 where neither is given
  std::optional<double> area;    ///< square metres that a child of size 1 takes: gives the radius
  double theta1 = 0;             ///< radians from the pole, at which the zone begins
  double theta2 = kPi;           ///< and at which it ends
  PerChild size = 1.0;           ///< scale of a child; it takes an area of its square
  double roll = 0;               ///< radians about the heading
  bool pole = false;             ///< the pole of the sphere, and not its middle, stands on the frame
};

ComponentType phiball_component();

}  // namespace meristem
