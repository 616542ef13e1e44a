// SPDX-License-Identifier: Apache-2.0
// A blade's outline drawn into the pixels of a texture.
#pragma once

#include <vector>

#include "meristem/shape/texture/texture_recipe.h"

namespace meristem {

/// The coverage and distances of pixels, row by row from top to bottom. Lengths are in heights of the texture on the
/// blade.
struct BladeMap {
  /// The extent of a row or column of pixels.
  struct Reach {
    float low = 0;
    float high = 1;
  };

  BladeMap(const TextureShape& shape, int pixels);

  std::vector<float> cover;   ///< share of each pixel within the outline
  std::vector<float> margin;  ///< distance of each pixel from the outline, 0 outside
  float widest = 0;           ///< maximum of these distances
  std::vector<Reach> rows;    ///< in u; rows that the outline misses have the values of the nearest row that it meets
  Reach midrib;               ///< where the line u = 1/2 enters and leaves the outline, in v
};

/// Returns where a line crosses a closed polygon, in order. The line is at `level` of coordinate `axis`, and the result
/// is the other coordinate.
std::vector<float> crossings(const std::vector<Vec2>& outline, int axis, float level);

}  // namespace meristem
