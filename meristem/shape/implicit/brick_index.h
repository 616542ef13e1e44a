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

  /// Returns a number that does not exist if there is no brick.
  BrickNumber find(glm::ivec3 at) const;

 private:
  struct Slot {
    glm::ivec3 at{-1};
    BrickNumber number;
  };
  std::size_t slot_of(glm::ivec3 at) const;

  std::vector<Slot> slots_;  // the size is a power of two, and at most half of the slots are used
};

}  // namespace meristem
