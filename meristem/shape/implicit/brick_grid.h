// SPDX-License-Identifier: Apache-2.0
// Values at the corners of a grid's cells. Only bricks of 8 x 8 x 8 corners near a surface are stored.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "meristem/base/vec.h"

namespace meristem {

inline constexpr int kBrickSide = 8;
inline constexpr int kBrickSize = kBrickSide * kBrickSide * kBrickSide;

/// Bricks that were made together.
struct BrickChunk {
  std::vector<glm::ivec3> at;  ///< in bricks from the grid's origin; not negative
  std::vector<float> values;   ///< kBrickSize per brick, x fastest; negative inside, no NaN

  std::span<const float> values_of(std::size_t brick) const {
    return std::span(values).subspan(brick * kBrickSize, kBrickSize);
  }
};

/// A grid of bricks. Corner (i, j, k) lies at origin + cell * (i, j, k). If the corners of a cell differ in sign, all
/// bricks that contain its corners exist. Cells with a missing corner have corners of one sign.
struct BrickGrid {
  DVec3 origin{0};
  double cell = 1;
  std::vector<BrickChunk> chunks;

  DVec3 position(glm::ivec3 corner) const { return origin + cell * DVec3(corner); }
};

}  // namespace meristem
