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
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "meristem/base/vec.h"

namespace meristem {

struct ShadowForm {
  double voxel = 0.1;       ///< metres a side; raised, shade is coarser and reaches farther
  double amount = 0.2;      ///< a: shade in the shader's own voxel; 0 casts none
  double base = 2;          ///< b, at least 1; raised, shade fades sooner with the distance
  int depth = 3;            ///< layers below the shader's own, 0 to 64; time and memory grow with its cube
  Vec3 toward_light = kUp;  ///< unit vector; the layers lie across its greatest component (of equal ones y, then x)
  int reach = 2;            ///< radius, in voxels, of what brighter_way looks at; 1 to 4

  bool operator==(const ShadowForm&) const = default;
};

class ShadowGrid {
 public:
  /// Throws std::invalid_argument for a form out of range.
  explicit ShadowGrid(const ShadowForm& form);

  /// Adds what a shader at `place` casts, `weight` times over; remove() of the same place and weight takes it back
  /// exactly. Weights are kept to 2^-32 of a shade. Throws std::invalid_argument for places that are not finite or more
  /// than 10^10 voxels away, and for weights that are not finite or cast over 10^6 shades.
  void add(Vec3 place, double weight = 1) { change(place, weight, 1); }
  void remove(Vec3 place, double weight = 1) { change(place, weight, -1); }
  /// Whether a place is not too far away to cast and to ask.
  bool reaches(Vec3 place) const;

  /// The sum of what was cast on the place's voxel. From many threads at once, as brighter_way.
  double shade(Vec3 place) const;
  /// The way out of the shade: minus the mean of the unit vectors to the voxels around, weighted by their shade. The
  /// more one-sided the shade, the longer, up to 1; zero where there is none or as much on every side.
  Vec3 brighter_way(Vec3 place) const;

  const ShadowForm& form() const { return form_; }
  bool empty() const { return bricks_.empty(); }
  std::size_t bytes() const;  ///< of shaded space

 private:
  static constexpr int kSide = 8;  // voxels of a brick
  using Voxel = std::array<std::int64_t, 3>;
  using BrickPlace = std::array<std::int32_t, 3>;
  /// The whole numbers are in 2^-32 of a shade, and wrap.
  struct Brick {
    std::array<std::uint64_t, std::size_t{kSide} * kSide * kSide> shade{};
    std::uint64_t sum = 0;
  };
  struct Hash {
    std::size_t operator()(const BrickPlace& place) const;
  };
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

  void change(Vec3 place, double weight, int sign);
  void change_brick(const BrickPlace& place, const Voxel& shader, const std::uint64_t* amounts);
  static void change_block(Brick& brick, const Block& block, std::uint64_t amount);
  Voxel voxel_at(Vec3 place) const;

  ShadowForm form_;
  std::vector<Layer> layers_;
  Block bounds_;  // of the layers
  std::vector<Neighbour> neighbours_;
  std::unordered_map<BrickPlace, Brick, Hash> bricks_;
};

}  // namespace meristem
