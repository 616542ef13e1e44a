// SPDX-License-Identifier: Apache-2.0
// Shade that leaves and buds cast on the space behind them, stored in sparse voxels. A shader darkens a pyramid that
// opens away from the light. Layer q, at a distance of q voxels, is a square of half-width q and gets the shade a *
// b^-q. Sums are whole numbers. The order of shaders therefore does not matter, and removing a shader restores the
// previous state exactly. Time is proportional to the touched voxels, memory to the shaded ones. Limit: this is no ray
// simulation, and obstacles cast their shade separately.
//
// Based on: W. Palubicki et al.: Self-organizing tree models for image synthesis (2009), section 4.1, shadow
// propagation. In the source the light comes from the zenith; here the pyramid leans with the light.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <limits>
#include <span>
#include <vector>

#include "meristem/base/progress.h"
#include "meristem/base/vec.h"

namespace meristem {

/// The form of the shade that one shader casts.
struct ShadowParameters {
  double voxel = 0.1;       ///< side of a voxel, metres; larger: coarser shade that reaches farther
  double amount = 0.2;      ///< a: shade in the shader's own voxel; 0: no shade
  double base = 2;          ///< b, at least 1; larger: shade fades faster with the distance
  int depth = 3;            ///< layers below the shader's own, 0 to 64; time and memory grow with the cube
  Vec3 toward_light = kUp;  ///< unit vector; layers are perpendicular to its largest component (ties: y, then x)
  int reach = 2;            ///< radius in voxels of the neighbourhood for brighter_way(), 1 to 4

  bool operator==(const ShadowParameters&) const = default;
};

/// A source of shade.
struct ShadeSource {
  Vec3 position{0};   ///< metres
  double weight = 1;  ///< factor on the shade; negative: removes shade cast earlier
};

/// The shade of all shaders that were cast.
class ShadowGrid {
 private:
  static constexpr int kSide = 8;  // voxels per side of a brick
  using Voxel = std::array<std::int64_t, 3>;
  using BrickCell = std::array<std::int32_t, 3>;
  /// Shade as whole numbers in units of 2^-32 of a shade. The numbers wrap around.
  struct Brick {
    std::array<std::uint64_t, std::size_t{kSide} * kSide * kSide> shade{};
    std::uint64_t sum = 0;
  };

 public:
  /// A cache of recently used bricks for one thread. It is valid as long as nothing is cast.
  class Recent {
   public:
    /// An empty cache.
    Recent() { places_.fill({std::numeric_limits<std::int32_t>::min(), 0, 0}); }

   private:
    friend class ShadowGrid;
    std::array<BrickCell, 8> places_;
    std::array<const Brick*, 8> bricks_{};
  };

  /// Throws std::invalid_argument for parameters out of range.
  explicit ShadowGrid(const ShadowParameters& form);

  /// Adds the shade of a shader at `position`, times `weight`. remove() with equal arguments restores the previous
  /// state exactly. Weights are rounded to 2^-32 of a shade. Throws std::invalid_argument for positions that are not
  /// finite or more than 10^10 voxels away. Throws it also for weights that are not finite or cast over 10^6 shades.
  void add(Vec3 position, double weight = 1);
  /// Removes the shade of a shader that add() or cast() has added.
  void remove(Vec3 position, double weight = 1) { add(position, -weight); }
  /// Adds the shade of many shaders, on all threads. Throws TooMuchMemory before exceeding `max_bytes`, and throws
  /// Cancelled. After an exception, some of the shaders have been cast.
  void cast(std::span<const ShadeSource> shaders, const Progress& progress,
            std::uint64_t max_bytes = std::numeric_limits<std::uint64_t>::max());
  /// Thrown before a call would exceed its limit of memory.
  struct TooMuchMemory {};
  /// Returns true if a position is close enough to cast shade and to be queried.
  bool reaches(Vec3 position) const;

  /// Returns the sum of shade in the voxel of `position`. Thread-safe, like brighter_way().
  double shade(Vec3 position) const;
  /// Writes the shade at each of `places` to `found`, which has the same length. For many distant positions, this is
  /// faster than single queries.
  void shade(std::span<const Vec3> places, std::span<double> found, Recent& recent) const;
  /// Returns the direction out of the shade: minus the mean of the unit vectors to the surrounding voxels, weighted by
  /// their shade. The length is up to 1 and grows with the asymmetry of the shade. Zero if there is no shade or if it
  /// is symmetric.
  Vec3 brighter_way(Vec3 position, Recent& recent) const;
  Vec3 brighter_way(Vec3 position) const;

  const ShadowParameters& form() const { return form_; }  ///< the parameters of the grid
  bool empty() const { return brick_count() == 0; }       ///< true if there is no shade
  std::size_t bytes() const;                              ///< heap memory of the shaded space

 private:
  /// Bricks by position. A small hash table keeps each lookup to one memory access.
  class Bricks {
   public:
    std::size_t size() const { return bricks_.size() - free_.size(); }
    /// Returns null if the brick does not exist.
    const Brick* find(const BrickCell& position) const {
      return table_.empty() ? nullptr : entry_at(entry_of(position));
    }
    Brick* find(const BrickCell& position) {
      // NOLINT: the object itself is not const.
      return const_cast<Brick*>(static_cast<const Bricks*>(this)->find(position));
    }
    /// Returns the existing brick, or a new one without shade. References to bricks stay valid.
    Brick& add(const BrickCell& position);
    /// Removes an existing brick that has no shade.
    void erase(const BrickCell& position);

   private:
    static constexpr std::uint32_t kNone = ~0U;
    struct Entry {
      BrickCell position{};
      std::uint32_t brick = kNone;
    };
    std::size_t home_of(const BrickCell& position) const;
    std::size_t entry_of(const BrickCell& position) const;
    const Brick* entry_at(std::size_t entry) const {
      return table_[entry].brick == kNone ? nullptr : &bricks_[table_[entry].brick];
    }

    // Open addressing with linear probing, at most half full; the size is 0 or a power of two.
    std::vector<Entry> table_;
    std::deque<Brick> bricks_;
    std::vector<std::uint32_t> free_;  // unused bricks that can be reused
  };
  static constexpr std::size_t kBrickBytes = sizeof(Brick) + 64;  // memory of a brick with its table entry
  /// Voxels from `low` to `high`, both included, relative to a shader's voxel or to the first voxel of a brick.
  struct Block {
    std::array<int, 3> low{};
    std::array<int, 3> high{};
  };
  struct Layer {
    Block block;
    double shade = 0;
  };
  /// A neighbour whose opposite is not in the list.
  struct Neighbour {
    std::array<int, 3> offset;
    DVec3 toward;
  };

  /// Bricks are divided by z into slabs that threads can process independently.
  static constexpr int kSlabs = 16;
  /// Shaders of one brick, contiguous in the list of shaders.
  struct Group {
    BrickCell brick;
    std::uint32_t begin;
    std::uint32_t end;
  };
  /// The shade of a group on the bricks with the offset `z` from its own brick.
  struct Fall {
    std::uint32_t group;
    int z;
  };
  struct Together;  // shaders that are cast together
  class SlabCaster;

  static bool is_same(const BrickCell& a, const BrickCell& b) {
    // Faster than comparing arrays, which is a function call.
    return ((a[0] ^ b[0]) | (a[1] ^ b[1]) | (a[2] ^ b[2])) == 0;
  }
  static int slab_of(const BrickCell& position) { return position[2] & (kSlabs - 1); }
  static BrickCell brick_of(const Voxel& voxel);
  void cast_together(std::span<const ShadeSource> shaders, const Progress& progress, std::uint64_t max_bricks);
  std::size_t brick_count() const;
  const Brick* find(const BrickCell& position) const;
  const Brick* find(const BrickCell& position, Recent& recent) const;
  static void change_block(Brick& brick, const Block& block, std::uint64_t amount);
  Voxel voxel_at(Vec3 position) const;

  ShadowParameters form_;
  std::vector<Layer> layers_;
  Block bounds_;  // bounds of the layers
  std::vector<Neighbour> neighbours_;
  std::array<Bricks, kSlabs> bricks_;
};

}  // namespace meristem
