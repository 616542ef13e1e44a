// SPDX-License-Identifier: Apache-2.0
#include "meristem/scene/marker_bricks.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace meristem {

namespace {

constexpr double kFine = 65536;    // a voxel as a whole number
constexpr int kBrickBits = 18;     // of a fine place within its brick
constexpr double kFarthest = 4e6;  // voxels; past it 32-bit places do not tell voxels apart
constexpr std::size_t kPatterns = 64;
constexpr double kJitters = 256;  // places along each side of a voxel

void require(bool holds, const char* what) {
  if (!holds) throw std::invalid_argument(what);
}

/// Three times 21 bits, which hold every brick that is not too far away.
std::uint64_t packed(const MarkerBricks::BrickPlace& place) {
  const auto part = [&](int k) { return static_cast<std::uint64_t>(place[k] + (1 << 20)); };
  return part(0) | part(1) << 21 | part(2) << 42;
}

std::size_t hash(std::uint64_t place) {
  place *= 0x9E3779B97F4A7C15U;
  return static_cast<std::size_t>(place ^ place >> 32);
}

/// Eight bytes that are 0 or 1 as bits.
std::uint64_t bits(const std::uint8_t* bytes) {
  std::uint64_t word = 0;
  for (int k = 0; k < 8; ++k) word |= std::uint64_t{bytes[k]} << (8 * k);
  return (word * 0x0102040810204080U) >> 56;
}

std::uint64_t all_bits(const std::array<std::uint8_t, MarkerBricks::kInBrick>& bytes) {
  std::uint64_t all = 0;
  for (int k = 0; k < 8; ++k) all |= bits(bytes.data() + 8 * k) << (8 * k);
  return all;
}

/// The squared distance of a point from the cube [0, kSide]^3.
float square_from_cube(Vec3 point) {
  constexpr float kHalf = 0.5F * MarkerBricks::kSide;
  const Vec3 outside = glm::max(glm::abs(point - kHalf) - kHalf, Vec3(0));
  return squared_length(outside);
}

}  // namespace

MarkerBricks::MarkerBricks(double spacing, double reach, RandomKey key)
    : spacing_(spacing), reach_(static_cast<float>(reach / spacing)), key_(key.child("bricks")), table_(16, kNone) {
  require(spacing > 0 && std::isfinite(spacing), "MarkerForm::spacing is not above 0");
  require(reach >= 0 && reach <= kMostReach * spacing, "MarkerForm::occupancy is out of range");
  const RandomKey jitter = key.child("patterns");
  patterns_.resize(kPatterns);
  for (std::size_t p = 0; p < kPatterns; ++p) {
    for (std::uint32_t k = 0; k < kInBrick; ++k) {
      const auto at = [&](std::uint64_t axis, std::uint32_t voxel) {
        const double step = std::floor(kJitters * jitter.uniform(3 * (kInBrick * p + k) + axis));
        return static_cast<float>(voxel + (step + 0.5) / kJitters);
      };
      patterns_[p].x[k] = at(0, k & 3);
      patterns_[p].y[k] = at(1, k >> 2 & 3);
      patterns_[p].z[k] = at(2, k >> 4);
    }
  }
}

MarkerBricks::FinePlace MarkerBricks::fine(Vec3 place) const {
  FinePlace at;
  for (int k = 0; k < 3; ++k) {
    const double voxels = static_cast<double>(place[k]) / spacing_;
    require(std::abs(voxels) <= kFarthest, "a place is too far away for its markers");
    at[k] = static_cast<std::int64_t>(std::floor(voxels * kFine + 0.5));
  }
  return at;
}

MarkerBricks::BrickRange MarkerBricks::around(const FinePlace& place, float voxels) {
  const auto reach = static_cast<std::int64_t>(voxels * static_cast<float>(kFine)) + 1;
  BrickRange range;
  for (int k = 0; k < 3; ++k) {
    range.low[k] = static_cast<std::int32_t>((place[k] - reach) >> kBrickBits);
    range.high[k] = static_cast<std::int32_t>((place[k] + reach) >> kBrickBits);
  }
  return range;
}

Vec3 MarkerBricks::from_corner(const BrickPlace& brick, const FinePlace& place) {
  const auto along = [&](int k) {
    const std::int64_t way = place[k] - (std::int64_t{brick[k]} << kBrickBits);
    return static_cast<float>(static_cast<std::int32_t>(way)) * static_cast<float>(1 / kFine);
  };
  return {along(0), along(1), along(2)};
}

std::uint64_t MarkerBricks::bits_of(const BrickRange& range, const BrickPlace& block) {
  std::array<unsigned, 3> first;
  std::array<unsigned, 3> count;
  for (int k = 0; k < 3; ++k) {
    const int from = std::max(range.low[k] - kSide * block[k], 0);
    first[k] = static_cast<unsigned>(from);
    count[k] = static_cast<unsigned>(std::min(range.high[k] - kSide * block[k], kSide - 1) - from + 1);
  }
  // A bit for each x; for each y such a row; for each z such a layer.
  const std::uint64_t row = 0xFU >> (4 - count[0]) << first[0];
  const std::uint64_t rows = 0x1111U >> 4 * (4 - count[1]) << 4 * first[1];
  const std::uint64_t layers = 0x0001000100010001U >> 16 * (4 - count[2]) << 16 * first[2];
  return row * rows * layers;
}

MarkerBricks::BrickPlace MarkerBricks::brick_in(const BrickPlace& block, std::uint32_t k) {
  const auto part = [&](int axis) { return kSide * block[axis] + static_cast<std::int32_t>(k >> (2 * axis) & 3); };
  return {part(0), part(1), part(2)};
}

std::uint32_t MarkerBricks::find_block(const BrickPlace& place, Recent& recent) const {
  const std::uint64_t wanted = packed(place);
  const int lane = (place[0] & 1) | (place[1] & 1) << 1 | (place[2] & 1) << 2;
  if (recent.places[lane] == wanted) return recent.blocks[lane];
  std::size_t at = hash(wanted) & (table_.size() - 1);
  while (table_[at] != kNone && blocks_[table_[at]].place != place) at = (at + 1) & (table_.size() - 1);
  if (table_[at] != kNone) {
    recent.places[lane] = wanted;
    recent.blocks[lane] = table_[at];
  }
  return table_[at];
}

std::uint32_t MarkerBricks::add_block(const BrickPlace& place) {
  const std::uint32_t found = find_block(place, recent_);
  if (found != kNone) return found;
  Block& block = blocks_.emplace_back();
  block.place = place;
  block.bricks.fill(kNone);
  grow_table();
  return static_cast<std::uint32_t>(blocks_.size() - 1);
}

/// Enters the last block, and all others anew where the table is half full.
void MarkerBricks::grow_table() {
  auto first = static_cast<std::uint32_t>(blocks_.size() - 1);
  if (2 * blocks_.size() > table_.size()) {
    table_.assign(2 * table_.size(), kNone);
    first = 0;
  }
  for (std::uint32_t k = first; k < blocks_.size(); ++k) {
    std::size_t at = hash(packed(blocks_[k].place)) & (table_.size() - 1);
    while (table_[at] != kNone) at = (at + 1) & (table_.size() - 1);
    table_[at] = k;
  }
}

std::uint32_t MarkerBricks::add_brick(std::uint32_t slot) {
  Block& block = blocks_[slot / kInBrick];
  std::uint32_t& brick = block.bricks[slot % kInBrick];
  if (brick != kNone) return brick;
  Brick& added = bricks_.emplace_back();
  added.slot = slot;
  added.pattern = pattern_at(brick_in(block.place, slot % kInBrick));
  brick = static_cast<std::uint32_t>(bricks_.size() - 1);
  return brick;
}

std::uint8_t MarkerBricks::pattern_at(const BrickPlace& brick) const {
  return static_cast<std::uint8_t>(kPatterns * key_.uniform(packed(brick)));
}

MarkerBricks::BrickPlace MarkerBricks::place_of(const Brick& brick) const {
  return brick_in(blocks_[brick.slot / kInBrick].place, brick.slot % kInBrick);
}

void MarkerBricks::find_near(const Pattern& pattern, Vec3 shoot, Near& near) const {
  const float square = reach_ * reach_;
  for (std::uint32_t layer = 0; layer < kInBrick; layer += 16) {
    const auto low = static_cast<float>(layer / 16);
    if (low > shoot.z + reach_ || low + 1 < shoot.z - reach_) {
      std::fill_n(near.data() + layer, 16, std::uint8_t{0});
      continue;
    }
    for (std::uint32_t k = layer; k < layer + 16; ++k) {
      const Vec3 way(pattern.x[k] - shoot.x, pattern.y[k] - shoot.y, pattern.z[k] - shoot.z);
      near[k] = squared_length(way) <= square ? 1 : 0;
    }
  }
}

template <class Visit>
void MarkerBricks::for_each_near(Vec3 place, Visit visit) {
  const FinePlace shoot = fine(place);
  const BrickRange range = around(shoot, reach_);
  Near near;
  for (std::int32_t z = range.low[2]; z <= range.high[2]; ++z) {
    for (std::int32_t y = range.low[1]; y <= range.high[1]; ++y) {
      for (std::int32_t x = range.low[0]; x <= range.high[0]; ++x) {
        const Vec3 in_brick = from_corner({x, y, z}, shoot);
        if (square_from_cube(in_brick) > reach_ * reach_) continue;
        const std::uint32_t brick = brick_at({x, y, z});
        find_near(pattern_of(bricks_[brick]), in_brick, near);
        visit(brick, near);
      }
    }
  }
}

std::uint32_t MarkerBricks::brick_at(const BrickPlace& place) {
  const std::uint32_t block = add_block(block_of(place));
  const auto k = static_cast<std::uint32_t>((place[0] & 3) | (place[1] & 3) << 2 | (place[2] & 3) << 4);
  const std::uint32_t brick = blocks_[block].bricks[k];
  return brick != kNone ? brick : add_brick(kInBrick * block + k);
}

void MarkerBricks::occupy(Vec3 place) {
  for_each_near(place, [&](std::uint32_t brick, const Near& near) { add(brick, near); });
}

void MarkerBricks::vacate(Vec3 place) {
  bool is_occupied = true;
  for_each_near(place,
                [&](std::uint32_t brick, const Near& near) { is_occupied = is_occupied && may_take(brick, near); });
  require(is_occupied, "there is no shoot to take away");
  for_each_near(place, [&](std::uint32_t brick, const Near& near) { take(brick, near); });
}

void MarkerBricks::add(std::uint32_t brick, const Near& near) {
  Brick& at = bricks_[brick];
  bool is_carried = false;
  for (std::uint32_t k = 0; k < kInBrick; ++k) {
    at.shoots[k] = static_cast<std::uint8_t>(at.shoots[k] + near[k]);
    is_carried |= at.shoots[k] < near[k];
  }
  at.free &= ~all_bits(near);
  refresh(at);
  if (!is_carried) return;
  for (std::uint32_t k = 0; k < kInBrick; ++k) {
    if (near[k] != 0 && at.shoots[k] == 0) ++carries_[std::uint64_t{brick} * kInBrick + k];
  }
}

bool MarkerBricks::may_take(std::uint32_t brick, const Near& near) const {
  return (bricks_[brick].free & all_bits(near)) == 0;
}

void MarkerBricks::take(std::uint32_t brick, const Near& near) {
  Brick& at = bricks_[brick];
  std::array<std::uint8_t, kInBrick> is_free;
  for (std::uint32_t k = 0; k < kInBrick; ++k) {
    if (at.shoots[k] < near[k]) {
      const auto carry = carries_.find(std::uint64_t{brick} * kInBrick + k);
      if (--carry->second == 0) carries_.erase(carry);
    }
    at.shoots[k] = static_cast<std::uint8_t>(at.shoots[k] - near[k]);
    is_free[k] = at.shoots[k] == 0 ? 1 : 0;
  }
  at.free = all_bits(is_free);
  if (!carries_.empty()) {
    for (std::uint32_t k = 0; k < kInBrick; ++k) {
      if (carries_.contains(std::uint64_t{brick} * kInBrick + k)) at.free &= ~(1ULL << k);
    }
  }
  refresh(at);
}

void MarkerBricks::refresh(const Brick& brick) {
  const std::uint64_t bit = 1ULL << (brick.slot % kInBrick);
  std::uint64_t& open = blocks_[brick.slot / kInBrick].open;
  open = (brick.free & brick.within) != 0 ? open | bit : open & ~bit;
}

void MarkerBricks::limit(Brick& brick, std::uint64_t within) {
  brick.within = within;
  refresh(brick);
}

std::size_t MarkerBricks::bytes() const {
  constexpr std::size_t kLinks = 3 * sizeof(void*);  // of the map
  return patterns_.size() * sizeof(Pattern) + blocks_.capacity() * sizeof(Block) +
         table_.size() * sizeof(std::uint32_t) + bricks_.size() * sizeof(Brick) +
         carries_.size() * (sizeof(decltype(carries_)::value_type) + kLinks);
}

}  // namespace meristem
