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

/// A stem that stands as it stood at a step of its growth.
struct GrowingStem {
  GrowthSpans spans;                  ///< of the whole stem
  double step = 0;                    ///< step at which it stands
  double steps_per_second = 1;        ///< of the stem's clock
  double unfold = 0;                  ///< steps in which what stands on it comes to its full size
  double pipe_exponent = 2;           ///< of the thickness of its wood
  std::vector<float> step_of_node{};  ///< of the whole stem, as steps_of_nodes gives them

  /// The share of its size that something has whose place on the segment of a node of the whole stem was born then.
  float share_unfolded(NodeIndex node, double birth) const;
};

/// Where what stood on a stem before it was trimmed stands on what is left of it. A cut stem keeps what stands on the
/// part that is left, where it is; on a stem that fits, everything moves to the same share of its axis.
class TrimmedStem {
 public:
  /// `trimmed` is what `mode` has left of `whole`.
  TrimmedStem(Skeleton whole, TrimmedSkeleton trimmed, TrimMode mode);

  TrimMode mode() const { return mode_; }                     ///< effect of the body on the stem
  const Skeleton& whole() const { return whole_; }            ///< skeleton before trimming
  const Skeleton& left() const { return trimmed_.skeleton; }  ///< skeleton that is left

  /// Where a position of the whole stem stands on what is left, or nothing where it is gone.
  std::optional<StemPosition> left_of(StemPosition position) const;
  /// By axis of what is left: the axis of the whole stem.
  std::vector<AxisIndex> whole_axes() const;
  /// A frame at a position of the whole stem, moved to `to` on what is left and turned as the stem is there.
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
  // For stems that fit: metres along axes, the axes' nodes, and the axis on what is left by axis of the whole.
  std::vector<float> whole_arc_;
  std::vector<float> left_arc_;
  std::vector<float> whole_length_;
  std::optional<Axes> left_axes_;
  std::vector<AxisIndex> left_axis_;
};

}  // namespace meristem
