// SPDX-License-Identifier: Apache-2.0
// Distributes the children of multipliers around their heading.
#pragma once

#include <vector>

#include "meristem/graph/component.h"

namespace meristem {

/// Children at equal angles around a heading.
struct Around {
  PartCount number = 6;
  PerChild angle = kPi / 2;  ///< radians between the heading and a child's heading: 0 along it, pi / 2 straight outward
  PerChild size = 1.0;       ///< scale of a child
  PerChild roll = 0.0;       ///< rotation about the heading in addition to the equal steps, radians
  double arc = 2 * kPi;      ///< radians over which children are spread; 2 pi or more: a full circle
};

const ParameterTable& around_table();

/// One child: its rotation about the heading and its tilt away from it (radians), and its scale.
struct ChildAround {
  double turn = 0, angle = 0, size = 1;
};

/// Returns the children. For a fractional count, the last child appears between the others. Children on a full circle
/// begin at 0. On an arc they are symmetric about 0, with children at both ends. Throws InputError if there are more
/// than the limit.
std::vector<ChildAround> children_around(const ComponentMember<Around>& member, SiteSink& sites);

/// Returns the minimum number of children of a component whose children are placed around it.
MinimumCounts minimum_around(const ComponentMember<Around>& member, const KnownMembers& known);

/// Returns axes rotated about y by `turn` and tilted away from y by `angle` (radians). The upper face looks to y.
Mat3 tilted(double turn, double angle);

}  // namespace meristem
