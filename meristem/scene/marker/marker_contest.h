// SPDX-License-Identifier: Apache-2.0
// Lists which looks may see each brick of markers in one round, and finds the nearest look of each marker.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "meristem/scene/marker/marker_look.h"

namespace meristem {

/// The looks of a round, and the looks at each brick.
struct LookedAt {
  std::vector<Look> looks;
  std::vector<std::uint32_t> bricks;
  std::vector<std::uint32_t> begins;   ///< begin of each brick's part of `lookers`, and the end
  std::vector<std::uint32_t> lookers;  ///< indices into `looks`

  std::span<const std::uint32_t> lookers_at(std::size_t brick) const {
    return {lookers.data() + begins[brick], lookers.data() + begins[brick + 1]};
  }
};

/// Collects the looks by brick and creates missing bricks. Throws Cancelled.
LookedAt looked_at(MarkerBricks& bricks, std::vector<LookAround> around, const Progress& progress);

/// The markers of one brick with the nearest look of each marker so far. Ties go to the seeker with the lower number.
class BrickContest {
 public:
  /// Starts a new contest with these available markers.
  void begin(const MarkerBricks::Pattern& pattern, std::uint64_t markers);
  /// Sets which markers of the brick the next looks may see.
  void show(const MarkerBricks::Pattern& pattern, std::uint64_t markers);
  /// Lets a look compete for the markers. `position` is the position of the look in voxels from the brick's corner.
  /// `layer` is the brick's first layer of voxels. `looker` is the number that for_each_owner() passes on.
  void compete(const Look& look, Vec3 position, std::int32_t layer, std::uint32_t looker);

  /// Calls visit(nearest look, marker's number in the brick, squared distance) for each marker that some look sees.
  template <class Visit>
  void for_each_owner(Visit visit) const {
    for (std::uint32_t k = 0; k < count_; ++k) {
      if (owner_[k] != MarkerBricks::kNone) visit(owner_[k], marker_[k], nearest_[k]);
    }
  }

 private:
  static constexpr std::uint32_t kMax = MarkerBricks::kInBrick;
  static constexpr std::uint32_t kLanes = 4;

  std::uint32_t count_ = 0;
  std::array<std::uint32_t, MarkerBricks::kSide + 1> layers_;  // begin of the markers of each layer
  std::array<std::uint32_t, kMax> marker_;
  alignas(16) std::array<float, kMax> x_;
  alignas(16) std::array<float, kMax> y_;
  alignas(16) std::array<float, kMax> z_;
  alignas(16) std::array<float, kMax> nearest_;
  alignas(16) std::array<std::uint32_t, kMax> seeker_;
  alignas(16) std::array<std::uint32_t, kMax> owner_;
};

}  // namespace meristem
