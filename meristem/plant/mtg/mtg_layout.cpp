// SPDX-License-Identifier: Apache-2.0
// Orders nodes for writing by a walk with an explicit stack. The child that stays in its column is visited last.
#include "meristem/plant/mtg/mtg_layout.h"

#include <algorithm>

namespace meristem {
namespace {

constexpr std::uint32_t kMaxOrders = 64;
constexpr NodeIndex kBetweenChecks = 65'536;  // nodes between two checks of progress

/// Returns the largest number of branchings between a root and a node.
std::uint32_t deepest_order(const Skeleton& skeleton) {
  const std::vector<bool> is_successor = find_successors(skeleton);
  std::vector<std::uint32_t> order(skeleton.node_count(), 0);
  std::uint32_t deepest = 0;
  for (NodeIndex node = 0; node < skeleton.node_count(); ++node) {
    if (skeleton.is_root(node)) continue;
    order[node] = order[skeleton.parent[node]] + (is_successor[node] ? 0 : 1);
    deepest = std::max(deepest, order[node]);
  }
  return deepest;
}

/// Returns, for each node, the child with the most descendants (tie: the first); kNoNode at tips.
std::vector<NodeIndex> find_largest(const Skeleton& skeleton) {
  std::vector<std::uint32_t> size(skeleton.node_count(), 1);
  for (NodeIndex node = static_cast<NodeIndex>(skeleton.node_count()); node-- > 0;) {
    if (!skeleton.is_root(node)) size[skeleton.parent[node]] += size[node];
  }
  std::vector<NodeIndex> largest(skeleton.node_count(), kNoNode);
  for (NodeIndex node = 0; node < skeleton.node_count(); ++node) {
    if (skeleton.is_root(node)) continue;
    NodeIndex& best = largest[skeleton.parent[node]];
    if (best == kNoNode || size[node] > size[best]) best = node;
  }
  return largest;
}

}  // namespace

std::vector<bool> find_successors(const Skeleton& skeleton) {
  std::vector<bool> is_successor(skeleton.node_count(), false);
  std::vector<bool> goes_on(skeleton.node_count(), false);
  for (NodeIndex node = 0; node < skeleton.node_count(); ++node) {
    const NodeIndex parent = skeleton.parent[node];
    if (parent == kNoNode || skeleton.axis[parent] != skeleton.axis[node] || goes_on[parent]) continue;
    goes_on[parent] = true;
    is_successor[node] = true;
  }
  return is_successor;
}

MtgLayout::MtgLayout(std::span<const Skeleton* const> skeletons, const Progress& progress) {
  std::size_t nodes = 0;
  bool by_order = true;
  for (const Skeleton* skeleton : skeletons) {
    nodes += skeleton->node_count();
    by_order = by_order && deepest_order(*skeleton) < kMaxOrders;
    progress.check();
  }
  places_.reserve(nodes);
  for (const Skeleton* skeleton : skeletons) add(*skeleton, by_order, progress);
}

void MtgLayout::add(const Skeleton& skeleton, bool by_order, const Progress& progress) {
  const NodeChildren children(skeleton);
  const std::vector<bool> is_successor = find_successors(skeleton);
  const std::vector<NodeIndex> largest = by_order ? std::vector<NodeIndex>() : find_largest(skeleton);
  const auto stays = [&](NodeIndex node) {
    return by_order ? is_successor[node] : largest[skeleton.parent[node]] == node;
  };
  std::vector<MtgEntry> waiting;  // stack: the next entry is the last
  for (NodeIndex root = 0; root < skeleton.node_count(); ++root) {
    if (!skeleton.is_root(root)) continue;
    waiting.push_back({.node = root});
    while (!waiting.empty()) {
      const MtgEntry place = waiting.back();
      waiting.pop_back();
      if (places_.size() % kBetweenChecks == 0) progress.check();
      places_.push_back(place);
      columns_ = std::max<std::size_t>(columns_, place.column + std::size_t{1});
      const std::span<const NodeIndex> borne = children.of(place.node);
      const auto wait = [&](NodeIndex node, bool in_column) {
        const auto column = static_cast<std::uint8_t>(place.column + (in_column ? 0 : 1));
        waiting.push_back({node, column, is_successor[node], in_column});
      };
      for (const NodeIndex node : borne) {
        if (stays(node)) wait(node, true);
      }
      for (std::size_t k = borne.size(); k-- > 0;) {
        if (!stays(borne[k])) wait(borne[k], false);
      }
    }
  }
}

}  // namespace meristem
