// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "meristem/plant/skeleton.h"

namespace meristem {

/// Which positions a node's next child may take: none closer than a hundredth of a step to the node itself, to its
/// parent or to a child it already has. Without this a node between balanced points would get the same child again and
/// again.
class ChildPositions {
 public:
  explicit ChildPositions(double step) : closest_(0.01 * step) {}

  /// Takes note of the newest node of the skeleton; to be called for every node in turn.
  void add_node(NodeIndex parent);
  bool is_free(const Skeleton& skeleton, NodeIndex node, Vec3 position) const;

 private:
  double closest_;
  std::vector<NodeIndex> youngest_child_;  // by node; kNoNode without children
  std::vector<NodeIndex> elder_sibling_;   // by node; kNoNode for the eldest
};

}  // namespace meristem
