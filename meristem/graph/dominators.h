// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "meristem/base/progress.h"

namespace meristem {

/// The dominators of a directed graph whose nodes are numbered from 0. A node dominates another node if every path from
/// the root to the other node passes it. Construction takes O(edges * log(nodes)) time, a query takes constant time.
class Dominators {
 public:
  using Node = std::uint32_t;

  /// `successors` lists for each node the nodes at the ends of its edges. `progress` can stop the search. Null: the
  /// search cannot be stopped.
  Dominators(const std::vector<std::vector<Node>>& successors, Node root, const Progress* progress = nullptr);

  /// Returns true if `node` can be reached from the root, differs from `above`, and every way to it passes `above`.
  bool is_strictly_dominated(Node node, Node above) const {
    return node != above && spans_[node].end != 0 && spans_[above].end != 0 &&
           spans_[above].begin < spans_[node].begin && spans_[node].begin < spans_[above].end;
  }

 private:
  /// Preorder numbers in the tree of dominators: the node's own, and the number after the last node below it. Both are
  /// 0 if the node cannot be reached.
  struct Span {
    std::uint32_t begin = 0;
    std::uint32_t end = 0;
  };
  std::vector<Span> spans_;
};

}  // namespace meristem
