// SPDX-License-Identifier: Apache-2.0
// The nodes of growing trees, with search for the nodes nearest to a position. Nodes are only added. Search trees
// double in size, so each node is inserted into a new tree a logarithmic number of times.
//
// Based on: J. Bentley, J. Saxe: Decomposable searching problems I (1980).
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "meristem/base/point_tree.h"
#include "meristem/base/progress.h"
#include "meristem/plant/skeleton.h"

namespace meristem {

/// Collects the nodes nearest to a position, up to kMax of them, nearest first. Ties go to the lower number. A node
/// may be offered several times.
class NearestFew {
 public:
  static constexpr std::size_t kMax = 9;

  std::size_t count() const { return count_; }
  NodeIndex node(std::size_t k) const { return node_[k]; }
  float distance2(std::size_t k) const { return distance2_[k]; }
  /// Returns the squared distance beyond which offers have no effect.
  float within2() const { return count_ < kMax ? std::numeric_limits<float>::infinity() : distance2_[kMax - 1]; }

  void offer(NodeIndex node, float distance2) {
    const auto is_before = [&](std::size_t k) {
      return distance2_[k] < distance2 || (distance2_[k] == distance2 && node_[k] <= node);
    };
    if (count_ == kMax && is_before(kMax - 1)) return;
    std::size_t position = count_;
    while (position > 0 && !is_before(position - 1)) --position;
    if (position > 0 && node_[position - 1] == node) return;
    count_ += count_ < kMax ? 1 : 0;
    for (std::size_t k = count_ - 1; k > position; --k) {
      node_[k] = node_[k - 1];
      distance2_[k] = distance2_[k - 1];
    }
    node_[position] = node;
    distance2_[position] = distance2;
  }

 private:
  std::size_t count_ = 0;
  std::array<NodeIndex, kMax> node_{};
  std::array<float, kMax> distance2_{};
};

/// A static search tree of nodes.
class NodeTree {
 public:
  NodeTree(std::vector<NumberedPoint> nodes, const Progress& progress)
      : nodes_(std::move(nodes)), tree_(nodes_, progress, kLeafNodes) {}

  const std::vector<NumberedPoint>& nodes() const { return nodes_; }
  /// Offers all nodes that may be among the nearest.
  void search(Vec3 position, NearestFew& nearest) const;
  /// Calls `see(node, squared distance)` for all nodes up to the squared distance `within2`, which `see` may reduce.
  template <class See>
  void visit(Vec3 position, float& within2, See see) const;

 private:
  static constexpr std::size_t kLeafNodes = 16;

  std::vector<NumberedPoint> nodes_;
  PointTree tree_;
};

/// A growing set of nodes.
class NodeForest {
 public:
  void add(std::span<const NumberedPoint> nodes, const Progress& progress);
  const std::vector<NodeTree>& trees() const { return trees_; }
  void search(Vec3 position, NearestFew& nearest) const {
    for (const NodeTree& tree : trees_) tree.search(position, nearest);
  }

 private:
  std::vector<NodeTree> trees_;  // from large to small
};

template <class See>
void NodeTree::visit(Vec3 position, float& within2, See see) const {
  struct Part {
    int level;
    std::uint32_t index;
    float gap2;
  };
  const auto part_at = [&](int level, std::uint32_t index) {
    return Part{level, index, distance2(tree_.boxes()[PointTree::place(level, index)], position)};
  };
  // A stack with one entry per level suffices; there are no more than 2^32 nodes.
  Part waiting[34];
  int count = 0;
  waiting[count++] = part_at(0, 0);
  while (count > 0) {
    const Part part = waiting[--count];
    if (part.gap2 > within2) continue;
    if (part.level < tree_.leaf_level()) {
      // Search the nearer half first.
      const Part left = part_at(part.level + 1, 2 * part.index);
      const Part right = part_at(part.level + 1, 2 * part.index + 1);
      const bool is_left_nearer = left.gap2 <= right.gap2;
      waiting[count++] = is_left_nearer ? right : left;
      waiting[count++] = is_left_nearer ? left : right;
      continue;
    }
    const std::uint32_t end = tree_.first_point(part.level, part.index + 1);
    for (std::uint32_t k = tree_.first_point(part.level, part.index); k < end; ++k) {
      const float square = squared_length(position - nodes_[k].position);
      if (square <= within2) see(nodes_[k].number, square);
    }
  }
}

}  // namespace meristem
