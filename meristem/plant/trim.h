// SPDX-License-Identifier: Apache-2.0
// Stems that are kept within a part of space, as by shears or by a natural limit.
//
// Based on: the trimming of B. Lintermann and O. Deussen's rule-based objects: a stem is cut off at the boundary, or it
// grows up to the boundary and then gets the taper that suits its length.
#pragma once

#include <string_view>
#include <vector>

#include "meristem/base/function_ref.h"
#include "meristem/base/vec.h"
#include "meristem/plant/skeleton.h"

namespace meristem {

/// What a body that stands around a stem does to it.
enum class TrimMode {
  cut,   ///< the stem ends at the boundary as thick as it is there, and what stands beyond is gone
  fit,   ///< the stem ends at the boundary with the taper of a whole stem
  none,  ///< nothing
};

/// The further column that marks, with 1, where an axis has been cut off: a flat end.
inline constexpr std::string_view kCutColumn = "cut";

/// How far a straight way stays inside the space: the share of the way from `from` to `to` before it first leaves, 1
/// where it does not, 0 where `from` is not inside. May be called from many threads at once.
using StayInside = FunctionRef<float(Vec3 from, Vec3 to)>;

struct TrimmedSkeleton {
  Skeleton skeleton;
  /// By node of the whole skeleton: where what is left of its segment ends, or kNoNode.
  std::vector<NodeIndex> node;
  /// By node of the whole skeleton: share of its segment that is left; 1 all of it (and roots that stay), 0 nothing.
  std::vector<float> kept;
  bool is_whole = true;  ///< nothing was outside: `skeleton` and the lists above are empty then
};

/// The skeleton up to where each of its axes first leaves the space. Roots outside are gone with all that grows on
/// them, and so are roots of which no segment is left. With `fit`, an axis that has been shortened has the radii of the
/// whole one over its new length, and no branch is thicker than the wood that bears it. `mode` is not `none`. Cost
/// linear in nodes.
TrimmedSkeleton trim_skeleton(const Skeleton& whole, StayInside stays_inside, TrimMode mode);

/// What is left of a skeleton where the share of each segment that stays is known, one per node: 0 beyond a segment of
/// which less than all stays. It is never called whole. Cost linear in nodes.
TrimmedSkeleton keep_shares(const Skeleton& whole, std::vector<float> kept);

/// What `then` has left of what `first` has left, by the nodes of the skeleton before both.
TrimmedSkeleton one_after_other(TrimmedSkeleton first, TrimmedSkeleton then);

/// Metres along its axis at each node, from where the axis springs; 0 at roots.
std::vector<float> arcs_along_axes(const Skeleton& skeleton);

}  // namespace meristem
