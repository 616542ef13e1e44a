// SPDX-License-Identifier: Apache-2.0
// Reads skeletons that others have measured or grown, from tables of three forms.
//
// A table of nodes has a line per node: x, y, z, the parent and, optionally, a radius or diameter. Such tables are
// written by Meristem (write_skeleton_csv) and kept in spreadsheets. A table of cylinders has a line per cylinder: its
// begin, its direction and length or its end, its radius and its parent. Quantitative structure models (TreeQSM,
// SimpleForest) have this form. A tree file has a line per tree with all segments of the tree in sequence, as written
// by treetools (raycloudtools).
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

/// The nodes of a table, parents before children. They keep the order of their lines if it has parents first. Otherwise
/// they are sorted level by level from the roots. All columns have an entry per node. A table of cylinders has one more
/// node at each place where cylinders without a parent begin.
struct NodeTable {
  NodeTableForm form = NodeTableForm::nodes;  ///< the form that the head line has shown
  bool is_y_up = false;                       ///< true in Meristem's own tables; otherwise z is up, x east and y north
  std::vector<NodeIndex> parent;              ///< index of an earlier node; kNoNode for roots
  std::vector<DVec3> position;                ///< in the units of the file
  std::vector<double> radius;                 ///< in the units of the file; NaN if missing
  std::vector<std::uint32_t> branch;          ///< nodes of one branch form one axis; empty if the file has no branches
  std::vector<float> birth;                   ///< empty if the file has no births
  std::vector<int> line;                      ///< line of the file, from 1

  std::size_t node_count() const { return parent.size(); }  ///< number of nodes
};

/// Reads the text of a table. The names in its head line decide the form. A row is a root if its parent is empty or
/// negative, or if it is 0 and no row has the number 0. Throws InputError with line and column in `file` for missing
/// columns (with the nearest name), texts instead of numbers, and numbers out of range (base/number_limit.h). Throws it
/// also for duplicate node numbers, missing parents, parents in a circle, no nodes, and more nodes than `limits` allow.
NodeTable read_node_table(std::string_view text, const std::string& file, const SizeLimits& limits);

/// How the nodes of a file are placed in the world.
struct NodeTablePlacement {
  double unit = 1;               ///< metres per unit of coordinates and radii
  double radius_factor = 1;      ///< factor on radii, in addition to `unit`
  bool is_y_up = false;          ///< false: z is up, x east and y north
  bool begins_at_origin = true;  ///< true: moves the first root to the origin; false: keeps the file's coordinates
};

/// Returns the nodes as a skeleton. The radius is 0 if the file has none. Nodes of one branch form an axis as long as
/// they are a chain. If the file has no branches, the thickest child continues the axis of its parent (tie: the lower
/// index). If radii are missing, the child with the longest way to a tip continues it. Throws InputError for
/// coordinates more than 1000 km from the origin or the first root, for radii above 1 km, and for branching orders
/// above 65535. Cost: linear.
Skeleton skeleton_of(const NodeTable& table, const NodeTablePlacement& placement, const std::string& file);

}  // namespace meristem
