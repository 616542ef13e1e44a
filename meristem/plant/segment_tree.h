// SPDX-License-Identifier: Apache-2.0
// Which segment of a plant's skeletons has its surface nearest to a position.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "meristem/base/progress.h"
#include "meristem/base/vec.h"
#include "meristem/plant/skeleton.h"

namespace meristem {

/// A cone between two nodes, closed by half a ball at both ends.
struct RoundSegment {
  Vec3 begin{0};  ///< metres
  Vec3 end{0};
  float begin_radius = 0;  ///< metres
  float end_radius = 0;
  std::uint32_t number = 0;  ///< what the caller knows it by

  /// Metres from a position to its surface, from inside as from outside.
  float distance(Vec3 position) const;
};

/// In place of a segment's number.
inline constexpr std::uint32_t kNoSegment = 0xffffffffU;

/// The segments of a skeleton, numbered by `first_axis` plus their axis, appended to a list. The first segment of a
/// lateral axis is as thick as its own first node along its whole length.
void append_segments(const Skeleton& skeleton, std::uint32_t first_axis, std::vector<RoundSegment>& segments);

/// A hierarchy of boxes over segments.
class SegmentTree {
 public:
  /// Throws std::invalid_argument for coordinates that are not finite, Cancelled. Cost n log n.
  SegmentTree(std::vector<RoundSegment> segments, const Progress& progress);
  ~SegmentTree();
  SegmentTree(SegmentTree&&) noexcept;

  /// The number of the segment whose surface is nearest to a position (tie: the smallest number); kNoSegment without
  /// segments. May be called from many threads.
  std::uint32_t nearest(Vec3 position) const;

 private:
  struct Boxes;
  std::unique_ptr<const Boxes> boxes_;
};

}  // namespace meristem
