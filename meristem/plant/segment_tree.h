// SPDX-License-Identifier: Apache-2.0
// Finds the segment of a plant's skeletons whose surface is nearest to a position.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "meristem/base/progress.h"
#include "meristem/base/vec.h"
#include "meristem/plant/skeleton.h"

namespace meristem {

/// A cone between two nodes, closed by a half ball at each end.
struct RoundSegment {
  Vec3 begin{0};             ///< metres
  Vec3 end{0};               ///< metres
  float begin_radius = 0;    ///< metres
  float end_radius = 0;      ///< metres
  std::uint32_t number = 0;  ///< number assigned by the caller

  /// Returns the distance in metres from a position to the surface. It is positive inside and outside.
  float distance(Vec3 position) const;
};

/// Marks a missing segment number.
inline constexpr std::uint32_t kNoSegment = 0xffffffffU;

/// Appends the segments of a skeleton to a list. The number of a segment is `first_axis` plus its axis. The first
/// segment of a lateral axis has the radius of the lateral's first node along its whole length.
void append_segments(const Skeleton& skeleton, std::uint32_t first_axis, std::vector<RoundSegment>& segments);

/// A hierarchy of boxes around segments.
class SegmentTree {
 public:
  /// Throws std::invalid_argument for coordinates that are not finite. Throws Cancelled. Cost: n log n.
  SegmentTree(std::vector<RoundSegment> segments, const Progress& progress);
  ~SegmentTree();
  SegmentTree(SegmentTree&&) noexcept;

  /// Returns the number of the segment whose surface is nearest to a position (tie: the smallest number). Returns
  /// kNoSegment if there are no segments. Thread-safe.
  std::uint32_t nearest(Vec3 position) const;

 private:
  struct Boxes;
  std::unique_ptr<const Boxes> boxes_;
};

}  // namespace meristem
