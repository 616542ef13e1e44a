// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "meristem/base/frame.h"
#include "meristem/graph/table/site.h"
#include "meristem/plant/growth_in_time.h"
#include "meristem/plant/skeleton.h"
#include "meristem/plant/trim.h"

namespace meristem {

/// A position on the segment of a skeleton that ends in `node`, at the share `along` of it.
struct StemPosition {
  NodeIndex node = 0;  ///< the node that ends the segment
  float along = 1;     ///< share of the segment, 0 to 1
};

/// A stem shown as at an earlier step of its growth.
struct GrowingStem {
  GrowthSpans spans;                  ///< spans of the whole stem
  double step = 0;                    ///< step at which it stands
  double steps_per_second = 1;        ///< growth steps per second of the stem's clock
  double unfold = 0;                  ///< number of steps in which a child on the stem reaches its full size
  double pipe_exponent = 2;           ///< pipe exponent of the thickness of its wood
  std::vector<float> step_of_node{};  ///< steps of the nodes of the whole stem, as steps_of_nodes returns them

  /// Returns the share of its full size of a child whose site on the segment of a node of the whole stem was born at
  /// `birth`.
  float share_unfolded(NodeIndex node, double birth) const;
};

/// Maps positions on a whole stem to positions on its trimmed rest. On a cut stem, children of the remaining part stay
/// in place. On a stem that fits, children move to an equal share of their axis.
class TrimmedStem {
 public:
  /// `trimmed` is the rest of `whole` after trimming by `mode`.
  TrimmedStem(Skeleton whole, TrimmedSkeleton trimmed, TrimMode mode);

  TrimMode mode() const { return mode_; }                     ///< effect of the body on the stem
  const Skeleton& whole() const { return whole_; }            ///< skeleton before trimming
  const Skeleton& left() const { return trimmed_.skeleton; }  ///< skeleton that is left

  /// Returns the position on the rest for a position of the whole stem, or nothing if it was trimmed away.
  std::optional<StemPosition> left_of(StemPosition position) const;
  /// Returns for each axis of the rest the axis of the whole stem.
  std::vector<AxisIndex> whole_axes() const;
  /// Moves a frame from a position of the whole stem to a position of the rest, and turns it with the stem.
  Frame moved(const Frame& frame, StemPosition from, StemPosition to) const;

  /// Moves a site of a growing stem from the position `from` of the whole stem to `to` on the remaining stem. The site
  /// then stands on the present bark, with its present size and its birth.
  void settle(const GrowingStem& growing, StemPosition from, StemPosition to, Site& site) const;

  std::uint64_t bytes() const;  ///< heap memory

 private:
  std::optional<StemPosition> share_left_of(StemPosition position) const;

  Skeleton whole_;
  TrimmedSkeleton trimmed_;
  TrimMode mode_;
  // For stems that fit: arc lengths along axes (metres), the axes' nodes, and for each axis of the whole its axis of
  // the rest.
  std::vector<float> whole_arc_;
  std::vector<float> left_arc_;
  std::vector<float> whole_length_;
  std::optional<SkeletonAxes> left_axes_;
  std::vector<AxisIndex> left_axis_;
};

}  // namespace meristem
