// SPDX-License-Identifier: Apache-2.0
// A skeleton that has grown, as it stood at an earlier step: one growth is the whole film. Segments lengthen from their
// parent's birth to their own, and wood thickens with the tips that it bears.
//
// Nothing is grown anew, so nodes keep the positions that they have at the end: branches that later sag or are bent
// stand as they come to be.
//
// Based on: the pipe model (K. Shinozaki and others, 1964), for the share of its last radius that wood has.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "meristem/plant/skeleton.h"
#include "meristem/plant/trim.h"

namespace meristem {

/// The further column that tells the step at which the branch that begins with a node falls off; 0 where it does not.
inline constexpr std::string_view kFallsColumn = "falls";

/// When the segment that ends in each node grows, in steps.
struct GrowthSpans {
  std::vector<float> begin;  ///< never before the node's parent has grown
  std::vector<float> end;  ///< after it began: the node's birth, but that segments of one step follow each other in it

  explicit GrowthSpans(const Skeleton& skeleton);
  float at(NodeIndex node, float along) const { return begin[node] + along * (end[node] - begin[node]); }
};

/// The step that each node has come to after `step` steps of all: that, but on branches that fall. Those wither in the
/// second half of the time between their last growth and their fall: they go back, as fast as lets the branch end where
/// it began. Empty where nothing falls. Cost linear in nodes.
std::vector<float> steps_of_nodes(const Skeleton& whole, const GrowthSpans& spans, double step);

/// Lets the branches whose first node is marked fall `hold` steps after their last node has come. A branch is a lateral
/// axis; marks on other nodes mean nothing.
void let_fall(Skeleton& skeleton, std::span<const std::uint8_t> marked, double hold);

/// What of `whole` stands after `step` steps, which may have a fraction; it is never called whole. Where it stands, a
/// radius is the last one times the share of tips that it bears of those that it will have borne, to the power of 1 /
/// `pipe_exponent`. Cost linear in nodes.
/// Branches that fall stand as they have withered by then.
TrimmedSkeleton standing_at(const Skeleton& whole, const GrowthSpans& spans, double step, double pipe_exponent);

}  // namespace meristem
