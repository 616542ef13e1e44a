// SPDX-License-Identifier: Apache-2.0
// Who looks at which bricks of markers in one round, and who of them is the nearest to each marker.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "meristem/scene/marker/marker_look.h"

namespace meristem {

/// The looks of a round, and for each brick that is looked at, who does.
struct LookedAt {
  std::vector<Look> looks;
  std::vector<std::uint32_t> bricks;
  std::vector<std::uint32_t> begins;   ///< of each brick's in `lookers`, and an end
  std::vector<std::uint32_t> lookers;  ///< indices into `looks`

  std::span<const std::uint32_t> lookers_at(std::size_t brick) const {
    return {lookers.data() + begins[brick], lookers.data() + begins[brick + 1]};
  }
};

/// Makes the bricks that are not there yet. Throws Cancelled.
LookedAt looked_at(MarkerBricks& bricks, std::vector<LookAround> around, const Progress& progress);

/// The markers of one brick, and the nearest looker to each so far. Among equally near lookers the one whose seeker has
/// the lower number counts.
class BrickContest {
 public:
  /// Begins anew, with the markers that are to be had.
  void begin(const MarkerBricks::Pattern& pattern, std::uint64_t markers);
  /// Shows these markers of the brick to the next lookers.
  void show(const MarkerBricks::Pattern& pattern, std::uint64_t markers);
  /// `position`: the looker's in voxels from the brick's corner; `layer`: the brick's first layer of voxels; `looker`:
  /// a number that for_each_owner gives back.
  void compete(const Look& look, Vec3 position, std::int32_t layer, std::uint32_t looker);

  /// For each marker that somebody sees, visit(the nearest looker, marker's number in the brick, squared distance).
  template <class Visit>
  void for_each_owner(Visit visit) const {
    for (std::uint32_t k = 0; k < count_; ++k) {
      if (owner_[k] != MarkerBricks::kNone) visit(owner_[k], marker_[k], nearest_[k]);
    }
  }

 private:
  static constexpr std::uint32_t kMost = MarkerBricks::kInBrick;
  static constexpr std::uint32_t kLanes = 4;

  std::uint32_t count_ = 0;
  std::array<std::uint32_t, MarkerBricks::kSide + 1> layers_;  // where the markers of each begin
  std::array<std::uint32_t, kMost> marker_;
  alignas(16) std::array<float, kMost> x_;
  alignas(16) std::array<float, kMost> y_;
  alignas(16) std::array<float, kMost> z_;
  alignas(16) std::array<float, kMost> nearest_;
  alignas(16) std::array<std::uint32_t, kMost> seeker_;
  alignas(16) std::array<std::uint32_t, kMost> owner_;
};

}  // namespace meristem
