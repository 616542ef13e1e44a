// SPDX-License-Identifier: Apache-2.0
// How multipliers spread children about their heading.
#pragma once

#include <vector>

#include "meristem/graph/component.h"

namespace meristem {

/// Children in even steps about a heading.
struct Around {
  Count number = 6;
  PerChild angle = kPi / 2;  ///< radians between the heading and a child's: 0 along it, a right angle straight outward
  PerChild size = 1.0;       ///< scale of a child
  PerChild roll = 0.0;       ///< radians about the heading, on top of the even turn
  double arc = 2 * kPi;      ///< radians over which children are spread; a whole turn or more: all around
};

const ParameterTable& around_table();

/// One of them: how far it is turned about the heading and tilted away from it (radians), and its scale.
struct ChildAround {
  double turn = 0, angle = 0, size = 1;
};

/// One of a count with a fraction is drawn in between those that are there.
/// They begin at 0 and go all around, or lie to both sides of 0 with children at both ends of the arc. Throws
/// InputError where they are more than may be.
std::vector<ChildAround> children_around(const Around& around, Emitter& out);

/// What each component whose children stand around it has at least.
MinimumCounts minimum_around(const Around& around, const KnownMembers& known);

/// Axes that are turned about y by `turn` and tilted away from it by `angle` (radians): the upper face looks to y.
Mat3 tilted(double turn, double angle);

}  // namespace meristem
