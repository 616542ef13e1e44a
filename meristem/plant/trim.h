// SPDX-License-Identifier: Apache-2.0
// Keeps stems within a region of space, as by shears or by a natural limit.
//
// Based on: the trimming of B. Lintermann and O. Deussen's rule-based objects. A stem is cut off at the boundary, or it
// grows up to the boundary and gets the taper of a stem of that length.
#pragma once

#include <string_view>
#include <vector>

#include "meristem/base/function_ref.h"
#include "meristem/base/vec.h"
#include "meristem/plant/skeleton.h"

namespace meristem {

/// The effect of a body on the stem inside it.
enum class TrimMode {
  cut,   ///< the stem ends at the boundary with its local radius; everything beyond is removed
  fit,   ///< the stem ends at the boundary with the form of a whole stem: thinner as it is shorter
  none,  ///< nothing
};

/// Column with 1 at nodes where an axis was cut off and has a flat end.
inline constexpr std::string_view kCutColumn = "cut";

/// Returns how far a straight way stays inside the space: the share of the way from `from` to `to` before it first
/// leaves. Returns 1 if it does not leave, and 0 if `from` is outside. Must be thread-safe.
using StayInside = FunctionRef<float(Vec3 from, Vec3 to)>;

/// A trimmed skeleton, and the place of each node of the whole skeleton in it.
struct TrimmedSkeleton {
  Skeleton skeleton;  ///< the remaining skeleton; its nodes are numbered anew
  /// For each node of the whole skeleton, the node that ends the remaining part of its segment, or kNoNode.
  std::vector<NodeIndex> node;
  /// For each node of the whole skeleton, the share of its segment that is left: 1 all (also for roots that stay), 0
  /// nothing.
  std::vector<float> kept;
  bool is_whole = true;  ///< true: nothing was outside, and `skeleton` and the lists above are empty
};

/// Returns the skeleton up to the point where each of its axes first leaves the space. Removes roots outside, with all
/// that grows on them, and roots without a remaining segment. With `fit`, a shortened axis has the form of the whole
/// axis: its length and its radii are smaller by one factor. No branch is thicker than its bearing wood. `mode` must
/// not be `none`. Cost: linear in nodes.
TrimmedSkeleton trim_skeleton(const Skeleton& whole, StayInside stays_inside, TrimMode mode);

/// Returns what is left of a skeleton if `kept` is the remaining share of each segment, one per node. All nodes beyond
/// a shortened segment are removed. The result never has `is_whole` set. Cost: linear in nodes.
TrimmedSkeleton keep_shares(const Skeleton& whole, std::vector<float> kept);

/// Combines two trimmings: `then` was applied to the skeleton of `first`. The result is indexed by the nodes of the
/// original skeleton.
TrimmedSkeleton one_after_other(TrimmedSkeleton first, TrimmedSkeleton then);

/// Returns, for each node, the length along its axis from the base of the axis, in metres; 0 at roots.
std::vector<float> arcs_along_axes(const Skeleton& skeleton);

}  // namespace meristem
