// SPDX-License-Identifier: Apache-2.0
// Records the history of attraction points step by step. Points are identified by their positions, so that the cloud
// needs no numbers for them. Points with equal positions have equal histories.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "meristem/base/vec.h"
#include "meristem/grow/growth_trace.h"

namespace meristem {

/// The points of one tree at any step of a finished growth: first the removed points, then the points that took part.
/// Both are in the order in which the tree brought them.
class PointHistory {
 public:
  static constexpr int kNever = 0x7fffffff;
  struct Point {
    Vec3 position{0};      ///< initial position; constant for points at rest
    int used_in = kNever;  ///< step in which it was used up, or kNever
    bool is_removed = false;
    std::vector<Vec3> path{};  ///< positions in steps 1, 2, ... up to its last step; only for moving points
  };

  std::vector<Point> points;

  /// Returns the places after a step, moved by `origin`.
  std::vector<TracedPlace> at(int step, Vec3 origin) const;
  std::uint64_t bytes() const;
};

class CloudRecord {
 public:
  /// Records a point that takes part in growth, in the order of the cloud, or a point that was removed before growth.
  void bring(std::uint32_t tree, Vec3 position, bool is_removed) { brought_.push_back({tree, position, is_removed}); }
  /// Begins the next step; the first call begins step 1.
  void begin_step() { ++step_; }
  /// For moving points: records the positions of all points that were not used up before the previous step.
  void place(std::vector<Vec3> positions) { places_.push_back(std::move(positions)); }
  /// Records that nodes of the previous step have used up the point at a position.
  void use_up(Vec3 position) { used_.push_back({position, step_ - 1}); }
  /// Returns the memory in bytes.
  std::uint64_t bytes() const;

  /// Returns the history of the points of each of `trees` trees. Throws Cancelled.
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
  std::vector<std::vector<Vec3>> places_;  // for steps 1, 2, ...; only if points move
  int step_ = 0;
};

}  // namespace meristem
