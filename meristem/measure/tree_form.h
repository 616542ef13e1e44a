// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "meristem/base/mesh.h"
#include "meristem/base/progress.h"
#include "meristem/plant/skeleton.h"

namespace meristem {

/// Size, shape and order of one tree. Lengths are in metres.
struct TreeForm {
  std::uint64_t nodes = 0;     ///< skeleton nodes, the root included
  std::uint64_t metamers = 0;  ///< metamers numbered by the column "metamer" on each axis if it exists, else segments
  std::uint64_t tips = 0;      ///< nodes without children
  std::uint64_t forks = 0;     ///< nodes with more than one child
  std::vector<std::uint64_t> axes_by_order;  ///< axes of each branching order, from 0
  std::vector<double> length_by_order;       ///< length of the axes of each branching order, from 0, metres
  double height = 0;                         ///< height of the highest node above the root
  std::optional<NodeIndex> fork;             ///< the first fork, where the crown begins
  double crown_height = 0;                   ///< height of the highest node above the first fork
  double crown_width = 0;                    ///< the largest horizontal distance between crown nodes
  double crown_mean_width = 0;               ///< mean over all horizontal directions of the crown's extent
  double crown_ground_area = 0;              ///< area of the convex hull of the crown's nodes projected on the ground
  double crown_hull_area = 0;                ///< surface of the convex hull of the crown's nodes, square metres
  double crown_hull_volume = 0;              ///< volume of the convex hull of the crown's nodes, cubic metres
  Mesh crown_hull;                 ///< convex_hull of the crown's nodes; empty if they are flat or if there is no crown
  double base_diameter = 0;        ///< diameter at the root (collar); 0 if unknown
  std::optional<double> diameter;  ///< diameter of the thickest stem at breast height above the root, if a stem reaches
                                   ///< it
  std::uint64_t stems = 0;         ///< stems at breast height: the thickest, and all that are at least a third as thick
  double diameter_squares = 0;     ///< sum of the squared diameters of these stems, square metres
  DVec3 segment_sum{0};            ///< sum of all vectors from parent to node
  DVec3 node_sum{0};               ///< sum of the positions of all nodes, relative to the root
};

inline constexpr double kBreastHeight = 1.3;  ///< metres above the root
/// Smallest share of the thickest diameter at breast height that makes a shoot a stem. Thinner shoots are branches.
///
/// Based on: USDA Forest Service, Forest Inventory and Analysis National Core Field Guide, section 5.9.2 (forked
/// trees).
inline constexpr double kStemShare = 1.0 / 3;

/// Measures a tree. `skeleton` must have one root, which is its first node. The crown is everything beyond the first
/// fork on the way from the root. Without a fork there is no crown, and its measures are 0. All measures of an empty
/// skeleton are 0. Throws Cancelled if `progress` is given and was cancelled.
TreeForm measure_form(const Skeleton& skeleton, const NodeChildren& children, const Progress* progress = nullptr);

}  // namespace meristem
