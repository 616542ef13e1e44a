// SPDX-License-Identifier: Apache-2.0
// Computes how a grown skeleton looked at an earlier step, so that one growth gives all frames of a film. Segments
// lengthen from their parent's birth to their own birth, and wood thickens with the number of tips that it bears.
//
// Limit: nodes keep their final positions, so branches that later sag or are bent appear in their final shape from the
// start.
//
// Based on: the pipe model (K. Shinozaki and others, 1964), for the share of the final radius.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "meristem/plant/skeleton.h"
#include "meristem/plant/trim.h"

namespace meristem {

/// Column with the step at which the branch that begins with a node falls off; 0 if it never falls.
inline constexpr std::string_view kFallsColumn = "falls";

/// The time span in which the segment that ends in each node grows, in steps.
struct GrowthSpans {
  std::vector<float> begin;  ///< never before the parent has grown
  /// later than `begin`; the node's birth, or an earlier share of that step if several nodes share the birth
  std::vector<float> end;

  /// Computes the spans of all nodes. Cost: linear in nodes.
  explicit GrowthSpans(const Skeleton& skeleton);
  /// Returns the step at which the segment of `node` has the share `along` (0 to 1) of its length.
  float at(NodeIndex node, float along) const { return begin[node] + along * (end[node] - begin[node]); }
};

/// Returns the step that each node shows after `step` steps. The result is `step`, except on branches that fall: they
/// wither in the second half of the time between their last growth and their fall. A withering branch shrinks back at
/// constant speed and reaches its base at its fall. Returns an empty list if no branch falls. Cost: linear in nodes.
std::vector<float> steps_of_nodes(const Skeleton& whole, const GrowthSpans& spans, double step);

/// Makes the branches whose first node is marked fall `hold` steps after the birth of their last node. A branch is a
/// lateral axis. Marks on other nodes have no effect.
void let_fall(Skeleton& skeleton, std::span<const std::uint8_t> marked, double hold);

/// Returns the part of `whole` that stands after `step` steps, which may be fractional. The result never has `is_whole`
/// set. The radius of a node is its final radius times (current tips / final tips)^(1 / `pipe_exponent`), with the tips
/// that it bears. Branches that fall appear as withered as they are by then. Cost: linear in nodes.
TrimmedSkeleton standing_at(const Skeleton& whole, const GrowthSpans& spans, double step, double pipe_exponent);

}  // namespace meristem
