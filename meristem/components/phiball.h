// SPDX-License-Identifier: Apache-2.0
// Children on a zone of a sphere. Each child is rotated from the previous one by the golden angle and placed lower by
// the area that it takes.
//
// Based on: the report on rule-based objects in xfrog, after J. N. Ridley: Packing efficiency in sunflower heads
// (1982).
#pragma once

#include "meristem/graph/component.h"

namespace meristem {

/// The distribution of the children of a phiball.
struct Phiball : ComponentBase {
  PartCount number = 50;
  std::optional<double> radius;  ///< radius of the sphere, metres; 0.1 if neither radius nor area is set
  std::optional<double> area;    ///< area of a child of size 1, square metres; determines the radius
  double theta1 = 0;             ///< begin of the zone, radians from the pole
  double theta2 = kPi;           ///< end of the zone, radians from the pole
  PerChild size = 1.0;           ///< scale of a child; its area is proportional to the square
  double roll = 0;               ///< rotation about the heading, radians
  bool pole = false;             ///< true: the pole of the sphere is at the frame's origin; false: its centre
};

ComponentType phiball_component();

}  // namespace meristem
