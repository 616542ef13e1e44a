// SPDX-License-Identifier: Apache-2.0
// Hash table of bricks by coordinates, with open addressing and linear probing.
#include "meristem/shape/implicit/brick_index.h"

#include <bit>

namespace meristem {

BrickIndex::BrickIndex(const BrickGrid& grid) {
  std::size_t count = 0;
  for (const BrickChunk& chunk : grid.chunks) count += chunk.at.size();
  slots_.resize(std::bit_ceil(2 * count + 2));
  for (std::uint32_t chunk = 0; chunk < grid.chunks.size(); ++chunk) {
    for (std::uint32_t brick = 0; brick < grid.chunks[chunk].at.size(); ++brick) {
      const glm::ivec3 at = grid.chunks[chunk].at[brick];
      slots_[slot_of(at)] = {at, {chunk, brick}};
    }
  }
}

BrickNumber BrickIndex::find(glm::ivec3 at) const { return slots_[slot_of(at)].number; }

/// Returns the slot in which `at` is, or would be, stored.
std::size_t BrickIndex::slot_of(glm::ivec3 at) const {
  std::uint64_t key = (static_cast<std::uint64_t>(at.x) << 42) ^ (static_cast<std::uint64_t>(at.y) << 21) ^
                      static_cast<std::uint64_t>(at.z);
  // Spreads neighbouring keys over the whole table (the finishing step of splitmix64).
  key = (key ^ key >> 30) * 0xbf58476d1ce4e5b9U;
  key = (key ^ key >> 27) * 0x94d049bb133111ebU;
  std::size_t slot = (key ^ key >> 31) & (slots_.size() - 1);
  while (slots_[slot].number.exists() && slots_[slot].at != at) slot = (slot + 1) & (slots_.size() - 1);
  return slot;
}

}  // namespace meristem
