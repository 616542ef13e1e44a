// SPDX-License-Identifier: Apache-2.0
// Shade that leaves and buds cast on what stands behind them, kept in voxels where there is any. A shader darkens a
// pyramid that opens away from the light: layer q, q voxels on, is a square of half-width q and gets a * b^-q. Sums are
// whole numbers, so the order of shaders does not matter and taking one away leaves what was there before it came.
// Time goes with the voxels touched, memory with those that are shaded. Not a simulation of rays: obstacles shade by
// themselves.
//
// Based on: W. Palubicki et al.: Self-organizing tree models for image synthesis (2009), section 4.1, shadow
// propagation. There the light comes from the zenith; here the pyramid leans as the light does.
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

struct ShadowParameters {
  double voxel = 0.1;       ///< metres per side; raised, shade is coarser and reaches farther
  double amount = 0.2;      ///< a: shade in the shader's own voxel; 0 casts none
  double base = 2;          ///< b, at least 1; raised, shade fades sooner with the distance
  int depth = 3;            ///< layers below the shader's own, 0 to 64; time and memory grow with its cube
  Vec3 toward_light = kUp;  ///< unit vector; the layers lie across its greatest component (of equal ones y, then x)
  int reach = 2;            ///< radius, in voxels, of what brighter_way looks at; 1 to 4

  bool operator==(const ShadowParameters&) const = default;
};

/// What casts shade.
struct Shader {
  Vec3 position{0};
  double weight = 1;  ///< as often it casts its shade; below 0 it takes back what was cast
};

class ShadowGrid {
 private:
  static constexpr int kSide = 8;  // voxels of a brick
  using Voxel = std::array<std::int64_t, 3>;
  using BrickCell = std::array<std::int32_t, 3>;
  /// The whole numbers are in 2^-32 of a shade, and wrap.
  struct Brick {
    std::array<std::uint64_t, std::size_t{kSide} * kSide * kSide> shade{};
    std::uint64_t sum = 0;
  };

 public:
  /// Bricks that were asked for before and whose neighbours all fit. For one thread, as long as nothing is cast.
  class Recent {
   public:
    Recent() { places_.fill({std::numeric_limits<std::int32_t>::min(), 0, 0}); }

   private:
    friend class ShadowGrid;
    std::array<BrickCell, 8> places_;
    std::array<const Brick*, 8> bricks_{};
  };

  /// Throws std::invalid_argument for a form out of range.
  explicit ShadowGrid(const ShadowParameters& form);

  /// Adds what a shader at `position` casts, `weight` times over; remove() of the same position and weight takes it
  /// back exactly. Weights are kept to 2^-32 of a shade. Throws std::invalid_argument for positions that are not finite
  /// or more than 10^10 voxels away, and for weights that are not finite or cast over 10^6 shades.
  void add(Vec3 position, double weight = 1);
  void remove(Vec3 position, double weight = 1) { add(position, -weight); }
  /// Adds what many shaders cast, on all threads. Throws TooMuchMemory before it takes more than `most_bytes`, and
  /// Cancelled; then some of the shaders are cast.
  void cast(std::span<const Shader> shaders, const Progress& progress,
            std::uint64_t most_bytes = std::numeric_limits<std::uint64_t>::max());
  struct TooMuchMemory {};
  /// Whether a position is not too far away to cast and to ask.
  bool reaches(Vec3 position) const;

  /// The sum of what was cast on the position's voxel. From many threads at once, as brighter_way.
  double shade(Vec3 position) const;
  /// Writes the shade at each of `places` to `found`, which is as long; many positions far apart are asked sooner
  /// together than one by one.
  void shade(std::span<const Vec3> places, std::span<double> found, Recent& recent) const;
  /// The way out of the shade: minus the mean of the unit vectors to the voxels around, weighted by their shade. The
  /// more one-sided the shade, the longer, up to 1; zero where there is none or as much on every side.
  Vec3 brighter_way(Vec3 position, Recent& recent) const;
  Vec3 brighter_way(Vec3 position) const;

  const ShadowParameters& form() const { return form_; }
  bool empty() const { return brick_count() == 0; }
  std::size_t bytes() const;  ///< heap memory of shaded space

 private:
  /// Bricks by their positions. A small table leads to them, so that looking one up costs one look into memory.
  class Bricks {
   public:
    std::size_t size() const { return bricks_.size() - free_.size(); }
    /// Null where there is none.
    const Brick* find(const BrickCell& position) const {
      return table_.empty() ? nullptr : entry_at(entry_of(position));
    }
    Brick* find(const BrickCell& position) {
      return const_cast<Brick*>(static_cast<const Bricks*>(this)->find(position));  // NOLINT: it is ours to change
    }
    /// The one that is there, or a new one without shade; it stays where it is.
    Brick& add(const BrickCell& position);
    /// Lets go of a brick without shade that is there.
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

    std::vector<Entry> table_;  // linear probing, at most half in use; as many as a power of two, or none
    std::deque<Brick> bricks_;
    std::vector<std::uint32_t> free_;  // unused bricks, for bricks that come next
  };
  static constexpr std::size_t kBrickBytes = sizeof(Brick) + 64;  // with what leads to it
  /// Voxels from `low` to `high`, both included; counted from a shader's own, or from a brick's first.
  struct Block {
    std::array<int, 3> low{};
    std::array<int, 3> high{};
  };
  struct Layer {
    Block block;
    double shade = 0;
  };
  /// An offset whose opposite is left out.
  struct Neighbour {
    std::array<int, 3> offset;
    DVec3 toward;
  };

  /// Bricks are kept by their z, so that threads can work on them side by side.
  static constexpr int kSlabs = 16;
  /// Shaders of one brick, one after another in those that are cast together.
  struct Group {
    BrickCell brick;
    std::uint32_t begin;
    std::uint32_t end;
  };
  /// What a group casts on the bricks that are `z` from its own.
  struct Fall {
    std::uint32_t group;
    int z;
  };
  struct Together;  // shaders that are cast together
  class SlabCaster;

  static bool is_same(const BrickCell& a, const BrickCell& b) {
    return ((a[0] ^ b[0]) | (a[1] ^ b[1]) | (a[2] ^ b[2])) == 0;  // the comparison of arrays is a call
  }
  static int slab_of(const BrickCell& position) { return position[2] & (kSlabs - 1); }
  static BrickCell brick_of(const Voxel& voxel);
  void cast_together(std::span<const Shader> shaders, const Progress& progress, std::uint64_t most_bricks);
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
