// SPDX-License-Identifier: Apache-2.0
// Stores the markers of all space in sparse bricks and counts the shoots near each marker. See marker_bricks.h.
#include "meristem/scene/marker/marker_bricks.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "meristem/base/require.h"

namespace meristem {

namespace {

constexpr std::size_t kPatterns = 64;

/// Packs bytes that are 0 or 1 into bits.
std::uint64_t bits(const std::array<std::uint8_t, MarkerBricks::kInBrick>& bytes) {
  std::uint64_t all = 0;
  for (std::size_t k = 0; k < 8; ++k) {
    std::uint64_t eight = 0;
    std::memcpy(&eight, bytes.data() + 8 * k, 8);
    // The multiplication collects the eight bits in the highest byte.
    all |= (eight * 0x0102040810204080U) >> 56 << (8 * k);
  }
  return all;
}
static_assert(std::endian::native == std::endian::little, "the first byte becomes the lowest bit");

/// The bricks of a range along one axis, relative to a position.
struct BricksAlong {
  std::array<float, MarkerBricks::kMaxAlong> from_corner;  // voxels from the low corner to the position
  std::array<float, MarkerBricks::kMaxAlong> gap;          // squared distance

  BricksAlong(const MarkerBricks::Range& bricks, const MarkerBricks::FinePosition& position, int axis) {
    constexpr float kHalf = 0.5F * MarkerBricks::kSide;
    for (std::int32_t k = bricks.low[axis]; k <= bricks.high[axis]; ++k) {
      const auto i = static_cast<std::size_t>(k - bricks.low[axis]);
      from_corner[i] = MarkerBricks::from_corner({k, k, k}, position)[axis];
      const float outside = std::max(std::abs(from_corner[i] - kHalf) - kHalf, 0.0F);
      gap[i] = outside * outside;
    }
  }
};

}  // namespace

MarkerBricks::MarkerBricks(double spacing, double reach, RandomKey key)
    : spacing_(spacing),
      fine_a_metre_(kFine / spacing),
      reach_(static_cast<float>(reach / spacing)),
      key_(key.child("bricks")),
      patterns_(kPatterns),
      table_(16) {
  require(spacing > 0 && std::isfinite(spacing), "MarkerParameters::spacing is not above 0");
  require(reach >= 0 && reach <= kMaxReach * spacing, "MarkerParameters::occupancy is out of range");
  const RandomKey jitter = key.child("patterns");
  for (std::size_t p = 0; p < kPatterns; ++p) {
    for (std::uint32_t k = 0; k < kInBrick; ++k) {
      const auto dice = static_cast<std::uint32_t>(0x1p24 * jitter.uniform(kInBrick * p + k));
      const auto at = [&](std::uint32_t axis, std::uint32_t voxel) {
        return static_cast<float>(voxel) + (static_cast<float>(dice >> 8 * axis & 255) + 0.5F) / 256;
      };
      patterns_[p].x[k] = at(0, k & 3);
      patterns_[p].y[k] = at(1, k >> 2 & 3);
      patterns_[p].z[k] = at(2, k >> 4);
    }
  }
}

/// Returns the index of a block's entry in the table, or of the free entry where it would be inserted.
std::size_t MarkerBricks::entry_of(std::uint64_t key) const {
  const std::uint64_t mixed = key * 0x9E3779B97F4A7C15U;
  std::size_t at = (mixed ^ mixed >> 32) & (table_.size() - 1);
  while (table_[at].key != key && table_[at].key != kAll) at = (at + 1) & (table_.size() - 1);
  return at;
}

std::uint32_t MarkerBricks::look_up(const Cell& cell, Recent& recent) const {
  const std::uint64_t key = packed(cell);
  const std::uint32_t block = table_[entry_of(key)].block;
  if (block != kNone) {
    recent.keys[number(cell)] = key;
    recent.blocks[number(cell)] = block;
  }
  return block;
}

std::uint32_t MarkerBricks::add_block(const Cell& cell) {
  const std::uint32_t found = find_block(cell, recent_);
  if (found != kNone) return found;
  Block& block = blocks_.emplace_back();
  block.position = cell;
  block.markers.fill(kAll);
  block.bricks.fill(kNone);

  // Insert it. If the table is half full, enlarge it and insert all blocks again.
  const auto added = static_cast<std::uint32_t>(blocks_.size() - 1);
  const bool is_full = 2 * blocks_.size() > table_.size();
  if (is_full) table_.assign(2 * table_.size(), {});
  for (std::uint32_t k = is_full ? 0 : added; k <= added; ++k) {
    const std::uint64_t key = packed(blocks_[k].position);
    table_[entry_of(key)] = {key, k};
  }
  return added;
}

std::uint32_t MarkerBricks::add_brick(std::uint32_t slot) {
  Block& block = blocks_[slot / kInBrick];
  std::uint32_t& brick = block.bricks[slot % kInBrick];
  if (brick != kNone) return brick;
  Brick& added = bricks_.emplace_back();
  added.slot = slot;
  added.pattern = pattern_at(held(block.position, slot % kInBrick));
  brick = static_cast<std::uint32_t>(bricks_.size() - 1);
  return brick;
}

std::uint8_t MarkerBricks::pattern_at(const Cell& brick) const {
  return static_cast<std::uint8_t>(kPatterns * key_.uniform(packed(brick)));
}

MarkerBricks::Cell MarkerBricks::place_of(const Brick& brick) const {
  return held(blocks_[brick.slot / kInBrick].position, brick.slot % kInBrick);
}

void MarkerBricks::find_near(const Pattern& pattern, Vec3 shoot, Near& near) const {
  const float square = reach_ * reach_;
  Near found;
  for (std::uint32_t k = 0; k < kInBrick; ++k) {
    const float x = pattern.x[k] - shoot.x;
    const float y = pattern.y[k] - shoot.y;
    const float z = pattern.z[k] - shoot.z;
    found[k] = (x * x + z * z) + y * y <= square ? 1 : 0;
  }
  near = found;
}

template <class Visit>
void MarkerBricks::for_each_near(Vec3 position, Visit visit) {
  const FinePosition shoot = fine(position);
  const Range bricks = holders(voxels(shoot, Vec3(-reach_), Vec3(reach_)));
  const Range blocks = holders(bricks);
  const BricksAlong along_x(bricks, shoot, 0);
  const BricksAlong along_y(bricks, shoot, 1);
  const BricksAlong along_z(bricks, shoot, 2);
  const float square = reach_ * reach_;
  for (std::int32_t z = blocks.low[2]; z <= blocks.high[2]; ++z) {
    for (std::int32_t y = blocks.low[1]; y <= blocks.high[1]; ++y) {
      for (std::int32_t x = blocks.low[0]; x <= blocks.high[0]; ++x) {
        const Cell at{x, y, z};
        const std::uint32_t block = add_block(at);
        for (std::uint64_t touched = held(at, bricks); touched != 0; touched &= touched - 1) {
          const auto k = static_cast<std::uint32_t>(std::countr_zero(touched));
          const Cell brick_place = held(at, k);
          const auto i = static_cast<std::size_t>(brick_place[0] - bricks.low[0]);
          const auto j = static_cast<std::size_t>(brick_place[1] - bricks.low[1]);
          const auto l = static_cast<std::size_t>(brick_place[2] - bricks.low[2]);
          if (along_x.gap[i] + along_y.gap[j] + along_z.gap[l] > square) continue;
          const std::uint32_t brick = add_brick(kInBrick * block + k);
          Near near;
          find_near(patterns_[bricks_[brick].pattern],
                    Vec3(along_x.from_corner[i], along_y.from_corner[j], along_z.from_corner[l]), near);
          visit(brick, near);
        }
      }
    }
  }
}

void MarkerBricks::occupy(Vec3 position) {
  for_each_near(position, [&](std::uint32_t brick, const Near& near) { add(brick, near); });
}

void MarkerBricks::vacate(Vec3 position) {
  std::uint64_t not_occupied = 0;
  for_each_near(position,
                [&](std::uint32_t brick, const Near& near) { not_occupied |= bricks_[brick].free & bits(near); });
  require(not_occupied == 0, "there is no shoot to take away");
  for_each_near(position, [&](std::uint32_t brick, const Near& near) { take(brick, near); });
}

void MarkerBricks::add(std::uint32_t brick, const Near& near) {
  Brick& at = bricks_[brick];
  std::uint8_t carried = 0;
  for (std::uint32_t k = 0; k < kInBrick; ++k) {
    at.shoots[k] = static_cast<std::uint8_t>(at.shoots[k] + near[k]);
    carried |= static_cast<std::uint8_t>(at.shoots[k] < near[k] ? 1 : 0);
  }
  at.free &= ~bits(near);
  refresh(at);
  if (carried == 0) return;
  for (std::uint32_t k = 0; k < kInBrick; ++k) {
    if (at.shoots[k] < near[k]) ++carries_[std::uint64_t{brick} * kInBrick + k];
  }
}

void MarkerBricks::take(std::uint32_t brick, const Near& near) {
  Brick& at = bricks_[brick];
  if (!carries_.empty()) {
    for (std::uint32_t k = 0; k < kInBrick; ++k) {
      if (at.shoots[k] >= near[k]) continue;
      const auto carry = carries_.find(std::uint64_t{brick} * kInBrick + k);
      if (--carry->second == 0) carries_.erase(carry);
    }
  }
  Near is_zero;
  for (std::uint32_t k = 0; k < kInBrick; ++k) {
    at.shoots[k] = static_cast<std::uint8_t>(at.shoots[k] - near[k]);
    is_zero[k] = at.shoots[k] == 0 ? 1 : 0;
  }
  at.free = bits(is_zero);
  if (!carries_.empty()) {
    for (std::uint32_t k = 0; k < kInBrick; ++k) {
      if (carries_.contains(std::uint64_t{brick} * kInBrick + k)) at.free &= ~(1ULL << k);
    }
  }
  refresh(at);
}

/// Updates the available markers of a brick in its block.
void MarkerBricks::refresh(const Brick& brick) {
  Block& block = blocks_[brick.slot / kInBrick];
  const std::uint32_t k = brick.slot % kInBrick;
  block.markers[k] = brick.free & brick.within;
  const std::uint64_t bit = 1ULL << k;
  block.open = block.markers[k] != 0 ? block.open | bit : block.open & ~bit;
}

void MarkerBricks::limit(Brick& brick, std::uint64_t within) {
  brick.within = within;
  refresh(brick);
}

std::size_t MarkerBricks::bytes() const {
  constexpr std::size_t kLinks = 3 * sizeof(void*);  // memory of links in the map and in the deque's chunks
  return patterns_.size() * sizeof(Pattern) + blocks_.capacity() * sizeof(Block) + table_.size() * sizeof(Entry) +
         bricks_.size() * (sizeof(Brick) + kLinks) +
         carries_.size() * (sizeof(decltype(carries_)::value_type) + kLinks);
}

}  // namespace meristem
