// SPDX-License-Identifier: Apache-2.0
// What becomes of attraction points step by step, for those who look at a growth afterwards. Points are told apart by
// their positions alone, so that the cloud needs no numbers for them: points that share a position share their fate.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "meristem/base/vec.h"
#include "meristem/grow/growth_trace.h"

namespace meristem {

/// The points of one tree at any step of a growth that is over: first those that were removed, then those that took
/// part, each in the order in which the tree brought them.
class PointHistory {
 public:
  static constexpr int kNever = 0x7fffffff;
  struct Point {
    Vec3 position{0};      ///< before growth, and for points that stay for ever
    int used_in = kNever;  ///< step; kNever where it was not used up
    bool is_removed = false;
    std::vector<Vec3> path{};  ///< where it was in the steps from 1 on, for points that move; up to its last one
  };

  std::vector<Point> points;

  /// As they are after a step, moved by `origin`.
  std::vector<TracedPlace> at(int step, Vec3 origin) const;
  std::uint64_t bytes() const;
};

class CloudRecord {
 public:
  /// A point that takes part in growth, in the order in which the cloud has them, or one that was removed before.
  void bring(std::uint32_t tree, Vec3 position, bool is_removed) { brought_.push_back({tree, position, is_removed}); }
  /// A step begins; the first one counts as 1.
  void begin_step() { ++step_; }
  /// Where all points are that were not used up before the step before this one, where points move.
  void place(std::vector<Vec3> positions) { places_.push_back(std::move(positions)); }
  /// The nodes of the step before this one have used up the point at a position.
  void use_up(Vec3 position) { used_.push_back({position, step_ - 1}); }
  /// Bytes that it holds.
  std::uint64_t bytes() const;

  /// What has become of the points of each of `trees` trees. Throws Cancelled.
  std::vector<PointHistory> histories(std::size_t trees, const Progress& progress) const;

 private:
  struct Brought {
    std::uint32_t tree = 0;
    Vec3 position{0};
    bool is_removed = false;
  };
  struct Used {
    Vec3 position{0};
    int step = 0;
  };

  std::vector<Brought> brought_;
  std::vector<Used> used_;                 // by rising step
  std::vector<std::vector<Vec3>> places_;  // of the steps from 1 on, where points move
  int step_ = 0;
};

}  // namespace meristem
