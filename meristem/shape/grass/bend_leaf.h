// SPDX-License-Identifier: Apache-2.0
// Turns of a leaf's midrib that the caller gives.
#pragma once

#include <optional>
#include <vector>

#include "meristem/shape/grass/grass_leaf.h"

namespace meristem {

/// A change of the midrib's direction between two positions.
struct LocalTurn {
  double from = 0.5;  ///< position along the midrib where the turn begins, 0 to 1
  double to = 0.6;    ///< position along the midrib where the turn ends, at least `from`; equal: a kink
  double angle = 0;   ///< radians: turn of all beyond; positive: away from the stem, down
};

/// The leaf with all these turns; each is spread evenly between its positions. Its pieces keep their lengths. Throws
/// std::invalid_argument for positions out of range.
GrassLeaf turned(const GrassLeaf& leaf, const std::vector<LocalTurn>& turns);

/// The leaf turned as a whole about its collar, until it leaves the stem at `angle` radians.
GrassLeaf inclined(const GrassLeaf& leaf, double angle);

/// Radians at which a leaf leaves the stem.
double inclination(const GrassLeaf& leaf);

}  // namespace meristem
