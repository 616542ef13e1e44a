// SPDX-License-Identifier: Apache-2.0
// Where markers stand and how many shoots are near each: one marker in every voxel of all space, somewhere within it.
// Voxels are kept in bricks of 4 x 4 x 4 from the first time that a shoot or a bud comes near, bricks in blocks of
// 4 x 4 x 4, so that memory goes with what is touched. A brick's markers follow one of 64 patterns drawn from the key;
// which one is drawn from the key and the brick's place.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <unordered_map>
#include <vector>

#include "meristem/base/random.h"
#include "meristem/base/vec.h"

namespace meristem {

class MarkerBricks {
 public:
  static constexpr int kSide = 4;                // voxels of a brick, bricks of a block
  static constexpr std::uint32_t kInBrick = 64;  // markers, or bricks in a block: x + 4 y + 16 z
  static constexpr std::uint32_t kNone = ~0U;    // no brick, no block
  static constexpr std::uint64_t kAll = ~0ULL;   // markers of a brick, or bricks of a block
  static constexpr int kMostReach = 32;          // voxels

  /// A place in units of 2^-16 voxels: then its way to a marker is exact in floats.
  using FinePlace = std::array<std::int64_t, 3>;
  /// Which brick (or block) this is in a row along each axis.
  using BrickPlace = std::array<std::int32_t, 3>;
  struct BrickRange {
    BrickPlace low;   ///< the first
    BrickPlace high;  ///< the last
  };
  /// Where the markers of a brick stand: voxels from its low corner.
  struct Pattern {
    std::array<float, kInBrick> x;
    std::array<float, kInBrick> y;
    std::array<float, kInBrick> z;
  };
  struct Brick {
    std::array<std::uint8_t, kInBrick> shoots{};  ///< near each marker, modulo 256
    std::uint64_t free = kAll;                    ///< markers without a shoot near
    std::uint64_t within = kAll;                  ///< markers that a volume may hold
    std::uint32_t slot = 0;                       ///< kInBrick * block + place in it
    std::uint32_t claims = kNone;                 ///< for the owner of the bricks
    std::uint8_t pattern = 0;
  };
  struct Block {
    BrickPlace place;
    std::uint64_t open = kAll;  ///< bricks that may have a free marker within a volume
    std::array<std::uint32_t, kInBrick> bricks;
  };
  /// The blocks that were asked for last. Eight neighbours fit.
  struct Recent {
    Recent() { places.fill(kAll); }
    std::array<std::uint64_t, 8> places;
    std::array<std::uint32_t, 8> blocks;
  };

  /// Throws std::invalid_argument unless `spacing` (metres) is above 0 and `reach` in [0, kMostReach] spacings.
  MarkerBricks(double spacing, double reach, RandomKey key);

  /// Counts a shoot at every marker within reach; vacate() is the exact inverse, and throws std::invalid_argument if
  /// no shoot is left to take away.
  void occupy(Vec3 place);
  void vacate(Vec3 place);

  /// Throws std::invalid_argument for places that are not finite or farther than 4 million voxels from the origin.
  FinePlace fine(Vec3 place) const;
  /// The bricks that a ball of so many voxels touches.
  static BrickRange around(const FinePlace& place, float voxels);
  /// Voxels from a brick's low corner to a place, exact up to 256.
  static Vec3 from_corner(const BrickPlace& brick, const FinePlace& place);
  /// Those bricks of a block that lie in a range, as bits.
  static std::uint64_t bits_of(const BrickRange& range, const BrickPlace& block);
  /// The block that holds a brick.
  static BrickPlace block_of(const BrickPlace& brick) { return {brick[0] >> 2, brick[1] >> 2, brick[2] >> 2}; }
  static BrickPlace brick_in(const BrickPlace& block, std::uint32_t k);

  std::uint32_t find_block(const BrickPlace& place, Recent& recent) const;  ///< kNone where there is none
  std::uint32_t add_block(const BrickPlace& place);                         ///< the one that is there, or a new one
  std::uint32_t add_brick(std::uint32_t slot);                              ///< the one that is there, or a new one
  const Block& block(std::uint32_t k) const { return blocks_[k]; }
  Brick& brick(std::uint32_t k) { return bricks_[k]; }
  const Brick& brick(std::uint32_t k) const { return bricks_[k]; }
  std::size_t brick_count() const { return bricks_.size(); }
  BrickPlace place_of(const Brick& brick) const;
  const Pattern& pattern_of(const Brick& brick) const { return patterns_[brick.pattern]; }
  /// The pattern of a brick that need not be there yet.
  std::uint8_t pattern_at(const BrickPlace& brick) const;
  const Pattern& pattern(std::uint8_t k) const { return patterns_[k]; }
  /// Says which of a brick's markers a volume may hold.
  void limit(Brick& brick, std::uint64_t within);

  double spacing() const { return spacing_; }
  std::size_t bytes() const;

 private:
  /// For each marker of a brick 1 where it is within reach, else 0.
  using Near = std::array<std::uint8_t, kInBrick>;

  void find_near(const Pattern& pattern, Vec3 shoot, Near& near) const;
  template <class Visit>
  void for_each_near(Vec3 place, Visit visit);
  std::uint32_t brick_at(const BrickPlace& place);
  void add(std::uint32_t brick, const Near& near);
  void take(std::uint32_t brick, const Near& near);
  bool may_take(std::uint32_t brick, const Near& near) const;
  void refresh(const Brick& brick);
  void grow_table();

  double spacing_;
  float reach_;
  RandomKey key_;
  std::vector<Pattern> patterns_;
  std::vector<Block> blocks_;
  std::vector<std::uint32_t> table_;  // blocks by the hash of their place, linear probing
  std::deque<Brick> bricks_;
  std::unordered_map<std::uint64_t, std::uint32_t> carries_;  // 256s of shoots, by kInBrick * brick + marker
  Recent recent_;
};

}  // namespace meristem
