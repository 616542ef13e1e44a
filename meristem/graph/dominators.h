// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "meristem/base/progress.h"

namespace meristem {

/// The dominators of a directed graph whose nodes are numbered from 0. A node dominates another one if every way from
/// the root to the other one passes it. Building takes O(edges * log(nodes)) time, a question takes constant time.
class Dominators {
 public:
  using Node = std::uint32_t;

  /// `successors` holds the nodes to which the edges of each node lead. `progress` may stop the search; null: never.
  Dominators(const std::vector<std::vector<Node>>& successors, Node root, const Progress* progress = nullptr);

  /// Returns true if `node` can be reached from the root, differs from `above`, and every way to it passes `above`.
  bool is_strictly_dominated(Node node, Node above) const {
    return node != above && spans_[node].end != 0 && spans_[above].end != 0 &&
           spans_[above].begin < spans_[node].begin && spans_[node].begin < spans_[above].end;
  }

 private:
  /// Preorder numbers in the tree of dominators: of the node, and behind the last node below it. 0 and 0 if the node
  /// cannot be reached.
  struct Span {
    std::uint32_t begin = 0;
    std::uint32_t end = 0;
  };
  std::vector<Span> spans_;
};

}  // namespace meristem
