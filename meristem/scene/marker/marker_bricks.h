// SPDX-License-Identifier: Apache-2.0
// Marker positions and the number of shoots near each marker. All space has one marker per voxel, at a random position
// in the voxel. Voxels are stored in bricks of 4 x 4 x 4, and bricks in blocks of 4 x 4 x 4. A brick is created when a
// shoot or a bud first comes near, so memory is proportional to the touched space. The markers of a brick follow one of
// 64 patterns that are drawn from the key. The brick's position and the key select the pattern.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <deque>
#include <stdexcept>
#include <unordered_map>
#include <vector>

#include "meristem/base/random.h"
#include "meristem/base/vec.h"

namespace meristem {

/// Markers in sparse bricks of voxels. Not thread-safe, except for reading.
class MarkerBricks {
 public:
  static constexpr std::int32_t kSide = 4;       ///< voxels per side of a brick, bricks per side of a block
  static constexpr std::uint32_t kInBrick = 64;  ///< markers of a brick, or bricks of a block: index x + 4 y + 16 z
  static constexpr std::uint32_t kNone = ~0U;    ///< no brick, or no block
  static constexpr std::uint64_t kAll = ~0ULL;   ///< all markers of a brick, or all bricks of a block
  static constexpr int kMaxReach = 32;           ///< voxels
  /// Largest number of bricks along an axis within this reach.
  static constexpr std::size_t kMaxAlong = 2 * kMaxReach / kSide + 2;

  /// A position in units of 2^-16 voxels. The vector to a marker is then exact in floats.
  using FinePosition = std::array<std::int64_t, 3>;
  /// Coordinates of a voxel, brick or block. A brick is four voxels wide, a block four bricks.
  using Cell = std::array<std::int32_t, 3>;
  /// A box of cells.
  struct Range {
    Cell low;   ///< first cell, included
    Cell high;  ///< last cell, included
  };
  /// The positions of a brick's markers, in voxels from its low corner.
  struct Pattern {
    std::array<float, kInBrick> x;  ///< along x, in [0, 4)
    std::array<float, kInBrick> y;  ///< along y, in [0, 4)
    std::array<float, kInBrick> z;  ///< along z, in [0, 4)
  };
  /// Four by four by four voxels with one marker each.
  struct Brick {
    std::array<std::uint8_t, kInBrick> shoots{};  ///< number near each marker, modulo 256
    std::uint64_t free = kAll;                    ///< markers without a shoot nearby
    std::uint64_t within = kAll;                  ///< markers that some volume contains
    std::uint32_t slot = 0;                       ///< kInBrick * block + position in the block
    std::uint32_t claims = kNone;                 ///< for use by the owner of the bricks
    std::uint8_t pattern = 0;                     ///< index of the brick's pattern, below 64
  };
  /// Four by four by four bricks.
  struct Block {
    Cell position;                                ///< coordinates of the block
    std::uint64_t open = kAll;                    ///< bricks with available markers
    std::array<std::uint64_t, kInBrick> markers;  ///< available markers of each brick: free and within a volume
    std::array<std::uint32_t, kInBrick> bricks;   ///< index of each brick, or kNone
  };
  /// A cache of recently used blocks. All neighbours of a block fit.
  struct Recent {
    /// An empty cache.
    Recent() { keys.fill(kAll); }
    std::array<std::uint64_t, 64> keys;    ///< key of the block in each place, or kAll
    std::array<std::uint32_t, 64> blocks;  ///< index of the block in each place
  };

  /// Throws std::invalid_argument unless `spacing` (metres) is above 0 and `reach` is in [0, kMaxReach] spacings.
  MarkerBricks(double spacing, double reach, RandomKey key);

  /// Counts a shoot at every marker within reach. vacate() is the exact inverse, and throws std::invalid_argument if no
  /// shoot is left to remove.
  void occupy(Vec3 position);
  /// Uncounts a shoot that occupy() has counted at an equal position.
  void vacate(Vec3 position);

  /// Returns true if a position is finite and at most 4 million voxels away from the origin along each axis.
  bool reaches(Vec3 position) const {
    const double farthest = kFarthest / fine_a_metre_;
    return std::abs(position.x) < farthest && std::abs(position.y) < farthest && std::abs(position.z) < farthest;
  }
  /// Throws std::invalid_argument for positions that are too far away.
  FinePosition fine(Vec3 position) const;
  /// Returns the voxels that a box touches. `low` and `high` are its corners relative to `position`, in voxels.
  static Range voxels(const FinePosition& position, Vec3 low, Vec3 high);
  /// Returns the brick that contains a voxel, or the block that contains a brick.
  static Cell holder(const Cell& cell) { return {cell[0] >> 2, cell[1] >> 2, cell[2] >> 2}; }
  /// Returns the holders of all cells of a range.
  static Range holders(const Range& range) { return {holder(range.low), holder(range.high)}; }
  /// Returns the index of a cell among the 64 cells of its holder.
  static std::uint32_t number(const Cell& cell) {
    return static_cast<std::uint32_t>((cell[0] & 3) | (cell[1] & 3) << 2 | (cell[2] & 3) << 4);
  }
  /// Returns the cell with this index among the 64 cells of a holder.
  static Cell held(const Cell& holder, std::uint32_t number) {
    const auto part = [&](int k) { return kSide * holder[k] + static_cast<std::int32_t>(number >> 2 * k & 3); };
    return {part(0), part(1), part(2)};
  }
  /// Returns, as bits, which of the 64 cells of a holder are in a range. The range must overlap the holder.
  static std::uint64_t held(const Cell& holder, const Range& range);
  /// Returns the voxels from a brick's low corner to a position, exact up to 256.
  static Vec3 from_corner(const Cell& brick, const FinePosition& position);

  /// Returns kNone if the block does not exist.
  std::uint32_t find_block(const Cell& cell, Recent& recent) const {
    const std::uint32_t lane = number(cell);
    return recent.keys[lane] == packed(cell) ? recent.blocks[lane] : look_up(cell, recent);
  }
  std::uint32_t add_block(const Cell& cell);                        ///< returns the existing block, or a new one
  std::uint32_t add_brick(std::uint32_t slot);                      ///< returns the existing brick, or a new one
  const Block& block(std::uint32_t k) const { return blocks_[k]; }  ///< block with this index
  std::size_t block_count() const { return blocks_.size(); }        ///< number of blocks
  Brick& brick(std::uint32_t k) { return bricks_[k]; }              ///< brick with this index
  const Brick& brick(std::uint32_t k) const { return bricks_[k]; }
  std::size_t brick_count() const { return bricks_.size(); }             ///< number of bricks
  Cell place_of(const Brick& brick) const;                               ///< coordinates of a brick
  const Pattern& pattern(std::uint8_t k) const { return patterns_[k]; }  ///< pattern with this index
  /// Returns the pattern of a brick, which need not exist yet.
  std::uint8_t pattern_at(const Cell& brick) const;
  /// Sets the markers of a brick that some volume contains.
  void limit(Brick& brick, std::uint64_t within);

  double spacing() const { return spacing_; }  ///< side of a voxel, metres
  std::size_t bytes() const;                   ///< heap memory

 private:
  static constexpr int kVoxelBits = 16;             // bits of a fine position within its voxel
  static constexpr int kBrickBits = 18;             // bits of a fine position within its brick
  static constexpr float kFine = 65536;             // fine units per voxel
  static constexpr double kFarthest = 4e6 * 65536;  // beyond it, 32-bit positions cannot distinguish voxels

  /// 1 for each marker of a brick within reach, else 0.
  using Near = std::array<std::uint8_t, kInBrick>;
  struct Entry {
    std::uint64_t key = kAll;
    std::uint32_t block = kNone;
  };

  /// Packs a cell into three times 21 bits, which hold every brick in range.
  static std::uint64_t packed(const Cell& cell) {
    const auto part = [&](int k) { return std::uint64_t{static_cast<std::uint32_t>(cell[k] + (1 << 20))}; };
    return part(0) | part(1) << 21 | part(2) << 42;
  }
  std::uint32_t look_up(const Cell& cell, Recent& recent) const;
  void find_near(const Pattern& pattern, Vec3 shoot, Near& near) const;  // `shoot` is relative to the brick's corner
  template <class Visit>
  void for_each_near(Vec3 position, Visit visit);
  std::size_t entry_of(std::uint64_t key) const;
  void add(std::uint32_t brick, const Near& near);
  void take(std::uint32_t brick, const Near& near);
  void refresh(const Brick& brick);

  double spacing_;
  double fine_a_metre_;  // fine units per metre
  float reach_;          // voxels
  RandomKey key_;
  std::vector<Pattern> patterns_;
  std::vector<Block> blocks_;
  std::vector<Entry> table_;  // blocks by the hash of their position, linear probing
  std::deque<Brick> bricks_;
  std::unordered_map<std::uint64_t, std::uint32_t> carries_;  // multiples of 256 shoots, by kInBrick * brick + marker
  Recent recent_;
};

inline MarkerBricks::FinePosition MarkerBricks::fine(Vec3 position) const {
  const auto along = [&](float at) {
    const double units = at * fine_a_metre_ + 0.5;
    if (!(std::abs(units) <= kFarthest)) throw std::invalid_argument("a position is too far away for its markers");
    const auto whole = static_cast<std::int64_t>(units);
    return static_cast<double>(whole) > units ? whole - 1 : whole;
  };
  return {along(position.x), along(position.y), along(position.z)};
}

inline MarkerBricks::Range MarkerBricks::voxels(const FinePosition& position, Vec3 low, Vec3 high) {
  const auto voxel = [&](int k, float way, int more) {
    return static_cast<std::int32_t>((position[k] + static_cast<std::int64_t>(way * kFine) + more) >> kVoxelBits);
  };
  return {{voxel(0, low.x, -1), voxel(1, low.y, -1), voxel(2, low.z, -1)},
          {voxel(0, high.x, 1), voxel(1, high.y, 1), voxel(2, high.z, 1)}};
}

inline std::uint64_t MarkerBricks::held(const Cell& holder, const Range& range) {
  const auto first = [&](int k) { return std::max(range.low[k] - kSide * holder[k], 0); };
  const auto after_last = [&](int k) { return std::max(kSide - 1 - (range.high[k] - kSide * holder[k]), 0); };
  // A bit for each x; such a row for each y; such a layer for each z.
  const std::uint64_t row = 0xFU >> (first(0) + after_last(0)) << first(0);
  const std::uint64_t rows = 0x1111U >> 4 * (first(1) + after_last(1)) << 4 * first(1);
  const std::uint64_t layers = 0x0001000100010001U >> 16 * (first(2) + after_last(2)) << 16 * first(2);
  return row * rows * layers;
}

inline Vec3 MarkerBricks::from_corner(const Cell& brick, const FinePosition& position) {
  const auto along = [&](int k) {
    const std::int64_t way = position[k] - (std::int64_t{brick[k]} << kBrickBits);
    return static_cast<float>(static_cast<std::int32_t>(way)) * (1 / kFine);
  };
  return {along(0), along(1), along(2)};
}

}  // namespace meristem
