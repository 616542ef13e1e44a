// SPDX-License-Identifier: Apache-2.0
// Forces that bend a leaf: its own weight, wind, and pulls such as that of light.
#pragma once

#include <vector>

#include <glm/vec2.hpp>

#include "meristem/shape/grass/grass_leaf.h"

namespace meristem {

/// A leaf as an elastic strip that is held at its collar. Its stiffness at a position is the stiffness of its base
/// times its width over the largest, times the cube of its thickness over that at the base.
struct LeafStrip {
  /// Stiffness of the base: bending stiffness per metre of width, over weight per square metre times the cubed length.
  /// Raised, the leaf yields less; a leaf that hardly carries itself has 0.1, an upright one 1 and more.
  double stiffness = 0.3;
  double tip_thickness = 0.3;  ///< thickness at the tip over the thickness at the base; it falls evenly
};

/// What acts on a leaf, in units of its own weight per square metre, by the leaf's plane: x away from the stem, y along
/// it.
struct LeafLoads {
  glm::dvec2 pull{0};  ///< on every part alike, as weight and light do
  /// Force of wind where it meets the blade squarely; a blade that lies along the wind feels nothing, in between the
  /// force goes with the square of the sine.
  glm::dvec2 wind{0};
  /// Which way gravity acts. The leaf is what it is under its weight; where `gravity` and `measured_gravity` are equal
  /// its own weight changes nothing.
  glm::dvec2 gravity{0, -1};
  glm::dvec2 measured_gravity{0, -1};  ///< when the leaf had the form given
};

/// The leaf's form under loads, with pieces as long as before and held at its collar as before. Turns of any size are
/// exact for the chain of its pieces, whose joints are springs. Loads are raised in steps from none, so where a leaf
/// could stand in several ways it takes the one that it comes to first, and none that is not stable. One that would
/// flutter has the form that the mean of the wind's forces gives it. Throws
/// std::invalid_argument for numbers out of range, or a leaf that does not come to rest.
/// Cost: linear in pieces, some hundred passes; several times that in wind.
GrassLeaf loaded(const GrassLeaf& leaf, const LeafStrip& strip, const LeafLoads& loads);

/// The factor on `loads.pull` and `loads.wind` under which the midrib at `place` turns by `angle` radians (positive:
/// down) from its given form, with gravity as it was. Throws std::invalid_argument where no factor up to 1000 does
/// that.
double load_for_turn(const GrassLeaf& leaf, const LeafStrip& strip, const LeafLoads& loads, double place, double angle);

}  // namespace meristem
