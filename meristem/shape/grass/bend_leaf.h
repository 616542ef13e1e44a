// SPDX-License-Identifier: Apache-2.0
// Turns of a leaf's midrib, and changes of its width, at places that the caller chooses.
#pragma once

#include <optional>
#include <vector>

#include "meristem/shape/grass/grass_leaf.h"

namespace meristem {

/// A change of the midrib's direction between two positions.
struct LocalTurn {
  double from = 0.5;  ///< position along the midrib where the turn begins, 0 to 1
  double to = 0.6;    ///< position along the midrib where the turn ends, at least `from`; equal to `from`: a kink
  double angle = 0;   ///< radians; turns everything beyond; positive: away from the stem, down
};

/// Returns the leaf with all these turns. Each turn is spread evenly between its positions, and the pieces of the leaf
/// keep their lengths. Throws std::invalid_argument for positions out of range.
GrassLeaf turned(const GrassLeaf& leaf, const std::vector<LocalTurn>& turns);

/// A change of the width between two positions: most in the middle between them, and none at both.
struct LocalWidth {
  double from = 0.4;  ///< position along the midrib where the change begins, 0 to 1
  double to = 0.6;    ///< position along the midrib where the change ends, above `from`
  double factor = 1;  ///< width in the middle, compared with the width before; at least 0
};

/// Returns the leaf with all these changes of its width. Their factors multiply, to at most 100. The midrib stays.
/// Throws std::invalid_argument for positions or factors out of range.
GrassLeaf widened(const GrassLeaf& leaf, const std::vector<LocalWidth>& widths);

/// Returns the leaf turned as a whole about its collar, so that it leaves the stem at `angle` radians.
GrassLeaf inclined(const GrassLeaf& leaf, double angle);

/// Returns the angle at which a leaf leaves the stem, radians.
double inclination(const GrassLeaf& leaf);

}  // namespace meristem
