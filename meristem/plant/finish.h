// SPDX-License-Identifier: Apache-2.0
// Post-processing of skeletons that were grown or drawn. All columns are kept, and new nodes get interpolated values.
// Growth models that derive axes, orders and radii from the skeleton assign them afterwards. Order of use: decimate,
// relax, subdivide. A branch here is the run of nodes from a root or fork to the next fork or tip. A node marked in the
// column `end` also ends a branch.
//
// The caller can pass a test that tells whether a straight segment is free of obstacles. If all segments of the input
// are free, all segments of the result are free: a node is kept, or keeps its position, if a new segment would be
// blocked.
//
// Based on: J. Jansen, Space Colonization-gestützte Generierung realitätskonformer Vegetationsszenarien, TU Dortmund
// 2020, section 3.5.2 (equation 3.21 corrected, see relax_angles).
#pragma once

#include <cstdint>
#include <vector>

#include "meristem/base/function_ref.h"
#include "meristem/base/progress.h"
#include "meristem/plant/skeleton.h"

namespace meristem {

/// Options of post-processing. Steps run in this order, and each is optional.
struct FinishOptions {
  double decimate = 0;   ///< length in steps over which nodes are removed; 0 removes none, 4 keeps about every fourth
  bool relax = true;     ///< softens fork angles
  double subdivide = 0;  ///< spacing of the final nodes in steps; 0 keeps the nodes as they are
};

/// Returns true if no obstacle blocks the straight way between two positions.
using IsOpen = FunctionRef<bool(Vec3 from, Vec3 to)>;

/// Nodes that other things stand on. They are kept, and their numbers are updated.
struct TrackedNodes {
  std::vector<std::uint8_t> stays;  ///< 1 for each node that must be kept, else 0; empty: none
  std::vector<NodeIndex> now;       ///< the new number of each node; kNoNode if removed
};

/// Returns the skeleton without some inner nodes of branches. Walks each branch from the base. Removes a node if the
/// length removed since the last kept node, plus the node's own segment, is below `tolerance - step / 2`. Forks, roots
/// and tips are kept. The half step makes the result independent of rounding: a tolerance of 4 steps keeps every fourth
/// inner node.
Skeleton decimate(const Skeleton& skeleton, double tolerance, double step);
Skeleton decimate(const Skeleton& skeleton, double tolerance, double step, IsOpen is_open,
                  TrackedNodes* tracked = nullptr);

/// Moves every node except the roots to the midpoint between the node and its parent's old position, all at once. Fork
/// angles fall from about 100° to 50-60°.
void relax_angles(Skeleton& skeleton);
void relax_angles(Skeleton& skeleton, IsOpen is_open);

/// Replaces the inner nodes of each branch by points at equal arc distance, near `spacing` metres, on the natural
/// spline through the branch's nodes (parametrised by chord length). A branch with fewer than three nodes uses the
/// straight line. The ends of branches keep their positions. If an obstacle blocks the spline, the branch keeps its
/// nodes, and the straight segments between them are divided. Throws std::invalid_argument unless `spacing` is above 0.
Skeleton subdivide(const Skeleton& skeleton, double spacing);
Skeleton subdivide(const Skeleton& skeleton, double spacing, IsOpen is_open, TrackedNodes* tracked = nullptr);

/// Inputs of the steps of a finish from the caller.
struct FinishContext {
  double step = 1;                                       ///< growth step, metres
  IsOpen is_open;                                        ///< tells whether a new segment is free of obstacles
  FunctionRef<void(std::uint64_t nodes)> require_nodes;  ///< throws if there would be more nodes than the limit
  const Progress& progress;                              ///< checked for a cancel; must outlive the call
};

/// Returns the skeleton after all steps that `wanted` enables. Throws what `require_nodes` throws, before subdividing.
/// Throws Cancelled.
Skeleton finish(Skeleton skeleton, const FinishOptions& wanted, const FinishContext& context,
                TrackedNodes* tracked = nullptr);

}  // namespace meristem
