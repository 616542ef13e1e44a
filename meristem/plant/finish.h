// SPDX-License-Identifier: Apache-2.0
// Post-processing of skeletons that have grown or were drawn. All columns are kept (interpolated where nodes are new);
// growth models whose axes, orders and radii follow from the skeleton assign them afterwards. Order of use: decimate,
// relax, subdivide. A branch here is the run of nodes between a root or fork and the next fork or tip; where the column
// `end` marks a node, a branch ends there, too.
//
// Where things stand in the way, the caller says which straight ways are open. A skeleton whose segments all are has
// only open ones afterwards: nodes stay, or stay where they were, where a new segment would not be.
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

/// Post-processing in this order; each step is optional.
struct Finish {
  double decimate = 0;   ///< removes nodes over this many steps of length; 0 for none. 4 keeps about every fourth
  bool relax = true;     ///< softens fork angles
  double subdivide = 0;  ///< spacing of the final nodes in steps; 0 keeps the nodes as they are
};

/// Whether nothing stands in the straight way from one position to another.
using IsOpen = FunctionRef<bool(Vec3 from, Vec3 to)>;

/// Nodes that something stands on: they stay, and their numbers are followed.
struct TrackedNodes {
  std::vector<std::uint8_t> stays;  ///< 1 or 0 for each node of the skeleton; empty: nothing stands on any
  std::vector<NodeIndex> now;       ///< the new number of each of its nodes, kNoNode of those that have gone
};

/// Removes inner nodes of branches: walking each branch, a node goes while the length removed since the last node that
/// was kept, plus its own segment, is below `tolerance - step / 2`. Forks, roots and tips stay. The half step keeps
/// rounding from deciding; with tolerance = 4 steps every fourth inner node stays.
Skeleton decimate(const Skeleton& skeleton, double tolerance, double step);
Skeleton decimate(const Skeleton& skeleton, double tolerance, double step, IsOpen is_open,
                  TrackedNodes* tracked = nullptr);

/// Moves every node but the roots to the middle between itself and its parent's old position, all at once. Fork angles
/// fall from about 100° to 50-60°.
void relax_angles(Skeleton& skeleton);
void relax_angles(Skeleton& skeleton, IsOpen is_open);

/// Replaces the nodes of each branch by points at equal arc distance, near `spacing` metres, on the natural spline
/// through them (parametrised by chord length; branches with fewer than three nodes by the straight line). The ends of
/// branches stay where they are. A branch whose spline leads through what is in the way keeps its nodes, with straight
/// pieces between them that are parted. Throws std::invalid_argument unless `spacing` is above 0.
Skeleton subdivide(const Skeleton& skeleton, double spacing);
Skeleton subdivide(const Skeleton& skeleton, double spacing, IsOpen is_open, TrackedNodes* tracked = nullptr);

/// What all steps of a finish ask for.
struct FinishContext {
  double step = 1;  ///< metres
  IsOpen is_open;
  FunctionRef<void(std::uint64_t nodes)> require_nodes;  ///< throws where that is more than may be
  const Progress& progress;
};

/// The skeleton after all steps that `wanted` has. Throws what `require_nodes` throws, before it subdivides; Cancelled.
Skeleton finish(Skeleton skeleton, const Finish& wanted, const FinishContext& context, TrackedNodes* tracked = nullptr);

}  // namespace meristem
