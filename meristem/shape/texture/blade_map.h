// SPDX-License-Identifier: Apache-2.0
// A blade's outline drawn into the pixels of a texture.
#pragma once

#include <vector>

#include "meristem/shape/texture/texture_recipe.h"

namespace meristem {

/// Pixels stand row by row from top to bottom. Lengths are in heights of the texture as it lies on the blade.
struct BladeMap {
  /// How far a row of pixels, or a column, reaches.
  struct Reach {
    float low = 0;
    float high = 1;
  };

  BladeMap(const TextureShape& shape, int pixels);

  std::vector<float> cover;   ///< share of each pixel within the outline
  std::vector<float> margin;  ///< distance of each pixel from the outline, 0 outside
  float widest = 0;           ///< the greatest of these distances
  std::vector<Reach> rows;    ///< in u; rows that the outline misses are as the nearest that it does not
  Reach midrib;               ///< where the line u = 1/2 enters and leaves the outline, in v
};

/// Where a line crosses a closed polygon, in order: at height `level` of its points' coordinate `axis`, the other
/// coordinate.
std::vector<float> crossings(const std::vector<Vec2>& outline, int axis, float level);

}  // namespace meristem
