// SPDX-License-Identifier: Apache-2.0
// Stable names for shoots: the path of metamer numbers at which axes branch off.
#pragma once

#include <compare>
#include <cstdint>
#include <string>
#include <vector>

#include "meristem/plant/further_columns.h"
#include "meristem/plant/skeleton.h"

namespace meristem {

/// Returns the number of each node on its axis. If the column `metamer` has a whole number from 1 to 2^24, uses that
/// number. Otherwise counts along the axis, from 1 at its base. Roots have 0.
std::vector<std::uint32_t> axis_numbers(const Skeleton& skeleton);

/// Returns the label of each axis. An axis that begins at a root is `main`. Any other axis has the label of its parent
/// axis, a dot, and the number of the node that bears the axis. `main.4` grows from the fourth metamer of the stem,
/// `main.4.2` from the second metamer of that branch, and `main.0` from the root node. If several axes grow from one
/// number, the later ones have a letter appended, in the order of the axes: `main.4`, `main.4b`, ..., `main.4z`,
/// `main.4aa`. Labels are unique within a tree. The label of an axis without nodes is empty. Cost: linear in the nodes
/// and in the total length of the labels.
std::vector<std::string> axis_labels(const Skeleton& skeleton);

/// The name of an axis in a stem made of joined parts. Each part has its own trees and labels.
struct ShootName {
  std::uint32_t part = 0;  ///< the part that the axis belongs to, from `part_of_axis`
  std::uint32_t tree = 0;  ///< index of the tree's root among the roots of the part, in the order of nodes
  std::string label;       ///< label from axis_labels(), computed within the part

  auto operator<=>(const ShootName&) const = default;
};

/// Returns the name of each axis. `part_of_axis` (Stem::part_of_axis) has a part number for each axis; if empty, all
/// axes belong to part 0. A part that stands on another part has one tree, and its first axis is `main`.
std::vector<ShootName> shoot_names(const Skeleton& skeleton, const std::vector<std::uint32_t>& part_of_axis);

/// Returns the nodes of an axis from base to tip, without the parent node that the axis grows from.
std::vector<NodeIndex> shoot_nodes(const Skeleton& skeleton, AxisIndex axis);

}  // namespace meristem
