// SPDX-License-Identifier: Apache-2.0
// The common data structure of all growth models: a rooted forest of nodes, stored as one array per column.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "meristem/base/vec.h"
#include "meristem/plant/operation_records.h"

namespace meristem {

using NodeIndex = std::uint32_t;                   ///< index of a node in its skeleton
using AxisIndex = std::uint32_t;                   ///< index of an axis in its skeleton
inline constexpr NodeIndex kNoNode = 0xffffffffU;  ///< marks a missing node, such as the parent of a root
inline constexpr AxisIndex kNoAxis = 0xffffffffU;  ///< marks a missing axis

/// Nodes joined by segments from parent to child. Every column has one entry per node.
///
/// A parent's index is smaller than the indices of its children. Plain loops therefore run from root to tips and back,
/// without recursion. Each node belongs to the axis on which it lies. The first node of a lateral axis is the first
/// node after the fork, and its parent lies on the parent axis.
struct Skeleton {
  std::vector<NodeIndex> parent;     ///< kNoNode for roots
  std::vector<Vec3> position;        ///< metres
  std::vector<float> radius;         ///< metres, at the node
  std::vector<AxisIndex> axis;       ///< axes are numbered from 0 in the order of their first nodes
  std::vector<std::uint16_t> order;  ///< branching order: 0 on the stem, one more at each lateral
  std::vector<float> birth;          ///< growth step at which the node appeared
  std::map<std::string, std::vector<float>, std::less<>> extra;  ///< further columns, if known: light, resource, ...
  OperationRecords operations;  ///< operations done to it as it grew, one tree after another

  std::size_t node_count() const { return parent.size(); }                ///< number of nodes, roots included
  std::size_t axis_count() const;                                         ///< number of axes
  std::uint64_t bytes() const;                                            ///< memory of all columns
  bool is_root(NodeIndex node) const { return parent[node] == kNoNode; }  ///< true if the node has no parent

  void reserve(std::size_t nodes);  ///< reserves memory for this number of nodes in all columns
  /// Appends a node with radius 0, axis 0 and order 0, and returns its index. `parent` is kNoNode or an earlier node.
  NodeIndex add_node(NodeIndex parent, Vec3 position, float birth);
  /// Appends further trees and continues the numbering of axes. Extra columns that one side lacks are 0 on its nodes.
  void append(Skeleton more);
};

/// The children of all nodes in one array: node k has `child[first[k] .. first[k+1])`, by rising index.
struct NodeChildren {
  std::vector<std::uint32_t> first;  ///< begin of each node's children in `child`; one entry more than nodes
  std::vector<NodeIndex> child;      ///< children of all nodes

  /// Finds the children of all nodes. Cost: linear.
  explicit NodeChildren(const Skeleton& skeleton);
  /// Returns the children of a node.
  std::span<const NodeIndex> of(NodeIndex node) const {
    return std::span(child).subspan(first[node], first[node + 1] - first[node]);
  }
};

/// The nodes of each axis from base to tip: axis a has `node[first[a] .. first[a+1])`. The node that a lateral axis
/// grows from is not included: it is the parent of the axis's first node.
struct SkeletonAxes {
  std::vector<std::uint32_t> first;  ///< begin of each axis in `node`; one entry more than axes
  std::vector<NodeIndex> node;       ///< nodes of all axes

  /// Finds the nodes of all axes. Cost: linear.
  explicit SkeletonAxes(const Skeleton& skeleton);
  std::size_t count() const { return first.size() - 1; }  ///< number of axes
  /// Returns the nodes of an axis, from base to tip.
  std::span<const NodeIndex> of(AxisIndex axis) const {
    return std::span(node).subspan(first[axis], first[axis + 1] - first[axis]);
  }
};

/// Returns, for each node, the distance in metres along the skeleton to the farthest tip beyond it (0 at tips).
std::vector<float> tip_distance(const Skeleton& skeleton);

/// Returns the bounding box of all nodes with their radii.
Box bounds(const Skeleton& skeleton);

/// Returns a hash of the bytes of all columns as 32 hexadecimal digits. Equal skeletons have equal hashes.
std::string skeleton_hash(const Skeleton& skeleton);

}  // namespace meristem
