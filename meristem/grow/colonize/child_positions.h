// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "meristem/plant/skeleton.h"

namespace meristem {

/// Tests positions for the next child of a node. A position is free if it is at least a hundredth of a step away from
/// the node itself, its parent and its existing children. Without this rule, a node between balanced points would get
/// equal children again and again.
class ChildPositions {
 public:
  explicit ChildPositions(double step) : closest_(0.01 * step) {}

  /// Registers the newest node of the skeleton. Call it for every node in order.
  void add_node(NodeIndex parent);
  bool is_free(const Skeleton& skeleton, NodeIndex node, Vec3 position) const;

 private:
  double closest_;
  std::vector<NodeIndex> youngest_child_;  // by node; kNoNode without children
  std::vector<NodeIndex> elder_sibling_;   // by node; kNoNode for the eldest
};

}  // namespace meristem
