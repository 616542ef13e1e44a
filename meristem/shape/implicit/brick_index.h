// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "meristem/shape/implicit/brick_grid.h"

namespace meristem {

/// A brick's position in a BrickGrid.
struct BrickNumber {
  std::uint32_t chunk = 0xffffffffU;
  std::uint32_t brick = 0;

  bool exists() const { return chunk != 0xffffffffU; }
};

/// Finds bricks by their coordinates, in constant time.
class BrickIndex {
 public:
  explicit BrickIndex(const BrickGrid& grid);

  /// Not existing where there is none.
  BrickNumber find(glm::ivec3 at) const;

 private:
  struct Slot {
    glm::ivec3 at{-1};
    BrickNumber number;
  };
  std::size_t slot_of(glm::ivec3 at) const;

  std::vector<Slot> slots_;  // a power of two, at most half of them taken
};

}  // namespace meristem
