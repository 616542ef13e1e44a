// SPDX-License-Identifier: Apache-2.0
// Skeletons that others have measured or grown, from tables of three forms.
//
// A table of nodes has a line per node: x, y, z, the parent, and if it is there a radius or diameter, as the tables of
// skeletons that Meristem writes (write_skeleton_csv) and those that people keep in spreadsheets. A table of cylinders
// has a line per cylinder: where it begins, its direction and length or its end, its radius and its parent, as those of
// quantitative structure models (TreeQSM, SimpleForest). A tree file has a line per tree, in which all its segments
// follow each other, as treetools (raycloudtools) writes it.
//
// Based on: P. Raumonen et al., Fast automatic precision tree models from terrestrial laser scanner data, 2013 (the
// columns of cylinders).
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "meristem/base/limits.h"
#include "meristem/plant/skeleton.h"

namespace meristem {

/// The form of a table.
enum class NodeTableForm { nodes, cylinders, trees };

/// The nodes of a table, parents before children; else in the order of their lines. All columns have an entry per node.
struct NodeTable {
  NodeTableForm form = NodeTableForm::nodes;
  bool is_y_up = false;  ///< as Meristem's own tables are; else z is up, x east and y north
  std::vector<NodeIndex> parent;
  std::vector<DVec3> position;        ///< in the units of the file
  std::vector<double> radius;         ///< in the units of the file; NaN where there is none
  std::vector<std::uint32_t> branch;  ///< nodes of one branch are one axis; empty where the file says nothing of it
  std::vector<float> birth;           ///< empty where the file says nothing of it
  std::vector<int> line;              ///< line of the file, from 1

  std::size_t node_count() const { return parent.size(); }
};

/// Reads the text of a table; the names in its head line say which form it has. Throws InputError with line and column
/// in `file`: columns that are missing (with the nearest name), texts for numbers, numbers that are used twice, parents
/// that are not there, parents in a circle, numbers that are out of range (base/number_limit.h), no nodes, more nodes
/// than `limits` allow.
NodeTable read_node_table(std::string_view text, const std::string& file, const Limits& limits);

/// How the nodes of a file become a skeleton.
struct NodeTablePlacement {
  double unit = 1;               ///< metres that a coordinate or radius of 1 means
  double radius_factor = 1;      ///< factor on radii, besides the unit
  bool is_y_up = false;          ///< false: z is up, x east and y north
  bool begins_at_origin = true;  ///< the first root comes to stand there; else coordinates are as in the file
};

/// The nodes as a skeleton, with radius 0 where the file has none. Nodes of one branch make an axis, as long as they
/// are a chain; where the file tells no branches, of each node's children the thickest continues its axis (tie: the
/// lower index), or where radii are missing the one that bears the longest way to a tip. Throws InputError for
/// coordinates beyond 1000 km of the origin or the first root, and for radii above 1 km. Cost linear.
Skeleton skeleton_of(const NodeTable& table, const NodeTablePlacement& placement, const std::string& file);

}  // namespace meristem
