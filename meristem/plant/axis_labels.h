// SPDX-License-Identifier: Apache-2.0
// Names for shoots that stay with them: the path of numbers at which axes branch off.
#pragma once

#include <compare>
#include <cstdint>
#include <string>
#include <vector>

#include "meristem/plant/further_columns.h"
#include "meristem/plant/skeleton.h"

namespace meristem {

/// The number of each node on its axis: what `metamer` says where that is a whole number from 1 to 2^24, else counted
/// on along the axis, from 1 at its base; 0 at a root.
std::vector<std::uint32_t> axis_numbers(const Skeleton& skeleton);

/// The label of each axis. An axis that begins at a root is `main`; any other has the label of the axis that bears it,
/// a dot, and the number of the node that bears it: `main.4` comes from the fourth metamer of the stem, `main.4.2` from
/// the second one of that branch, `main.0` from the root itself. Further axes from one number have letters behind it,
/// in the order of the axes: `main.4`, `main.4b`, ..., `main.4z`, `main.4aa`. So labels differ within a tree. An axis
/// on which no node lies has an empty one. Cost linear in nodes and in the letters of all labels.
std::vector<std::string> axis_labels(const Skeleton& skeleton);

/// What an axis is called where stems are joined: each of them has trees and labels of its own.
struct ShootName {
  std::uint32_t part = 0;  ///< the stem that the axis belongs to, as `part_of_axis` says
  std::uint32_t tree = 0;  ///< number of its root among the roots of that part, in the order of nodes
  std::string label;       ///< as axis_labels() gives it for that part alone

  auto operator<=>(const ShootName&) const = default;
};

/// The name of each axis. `part_of_axis` (Stem::part_of_axis) has a number for each axis, or is empty where all belong
/// to part 0. A part that stands on another one has one tree, whose `main` is the first of its axes.
std::vector<ShootName> shoot_names(const Skeleton& skeleton, const std::vector<std::uint32_t>& part_of_axis);

/// The nodes of an axis from its base on, after the node that it springs from.
std::vector<NodeIndex> shoot_nodes(const Skeleton& skeleton, AxisIndex axis);

}  // namespace meristem
