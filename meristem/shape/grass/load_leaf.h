// SPDX-License-Identifier: Apache-2.0
// Forces that bend a leaf: its own weight, wind, and pulls such as growth toward light.
#pragma once

#include <vector>

#include <glm/vec2.hpp>

#include "meristem/shape/grass/grass_leaf.h"

namespace meristem {

/// A leaf as an elastic strip that is fixed at its collar. The stiffness at a position is the stiffness of the base,
/// times the relative width, times the cube of the relative thickness.
struct LeafStrip {
  /// Stiffness of the base: bending stiffness per metre of width, divided by weight per square metre times the cubed
  /// length. Larger values bend less. A leaf that hardly carries itself has 0.1, an upright leaf 1 or more.
  double stiffness = 0.3;
  double tip_thickness = 0.3;  ///< thickness at the tip relative to the base; it falls evenly
};

/// Loads on a leaf, in units of its own weight per square metre, in the plane of the leaf: x away from the stem, y
/// along it.
struct LeafLoads {
  glm::dvec2 pull{0};  ///< acts equally on every part, like weight and light
  /// Force of wind that meets the blade at right angles. Along a blade, the wind has no force. In between, the force
  /// grows with the square of the sine.
  glm::dvec2 wind{0};
  /// Direction of gravity. The given form already includes the leaf's weight, so its weight changes nothing if
  /// `gravity` equals `measured_gravity`.
  glm::dvec2 gravity{0, -1};
  glm::dvec2 measured_gravity{0, -1};  ///< direction of gravity when the form was measured
};

/// Returns the leaf's form under loads. Pieces keep their lengths, and the collar stays fixed. Turns of any size are
/// exact for the chain of its pieces, whose joints are springs. Loads are raised in steps from 0. If the leaf has
/// several equilibria, the result is the first one on this path, and it is always stable. A leaf that would flutter
/// gets the form under the mean of the wind's forces. Throws std::invalid_argument for numbers out of range, or if the
/// leaf finds no equilibrium. The cost is linear in pieces, some hundred passes, and several times more in wind.
GrassLeaf loaded(const GrassLeaf& leaf, const LeafStrip& strip, const LeafLoads& loads);

/// Returns the factor on `loads.pull` and `loads.wind` with which the midrib at `place` turns by `angle` radians
/// (positive: down) from its given form, with unchanged gravity. Returns 0 for an angle of 0. Throws
/// std::invalid_argument like loaded(), and for a `place` that is not above 0 and at most 1. Also throws if no factor
/// up to 1000 is sufficient, or if the leaf snaps past the angle.
double load_for_turn(const GrassLeaf& leaf, const LeafStrip& strip, const LeafLoads& loads, double place, double angle);

}  // namespace meristem
