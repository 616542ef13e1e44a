// SPDX-License-Identifier: Apache-2.0
#include "meristem/grow/colonize/node_forest.h"

#include <utility>

namespace meristem {

void NodeTree::search(Vec3 position, NearestFew& nearest) const {
  float within2 = nearest.within2();
  visit(position, within2, [&](NodeIndex node, float square) {
    nearest.offer(node, square);
    within2 = nearest.within2();
  });
}

void NodeForest::add(std::span<const NumberedPoint> nodes, const Progress& progress) {
  if (nodes.empty()) return;
  std::vector<NumberedPoint> joined(nodes.begin(), nodes.end());
  while (!trees_.empty() && trees_.back().nodes().size() <= 2 * joined.size()) {
    const std::vector<NumberedPoint>& last = trees_.back().nodes();
    joined.insert(joined.end(), last.begin(), last.end());
    trees_.pop_back();
  }
  trees_.emplace_back(std::move(joined), progress);
}

}  // namespace meristem
