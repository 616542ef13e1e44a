// SPDX-License-Identifier: Apache-2.0
// The living attraction points and, for each point, the nearest node that influences it.
//
// Nodes never move or disappear, so a new node can only take points from nodes that are farther away. Each point stores
// its nearest node and compares it with new nodes only. The new nodes of a round descend a tree of the points together.
// Each part of the tree stores the largest distance of its points to their nodes, so parts that no new node can improve
// are skipped. Cost per new node: the points that it comes nearer to, and a few more around them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "meristem/base/point_tree.h"
#include "meristem/base/progress.h"
#include "meristem/plant/skeleton.h"

namespace meristem {

class NearestNodes {
 public:
  struct NewNode {
    Vec3 position{0};
    float influence = 0;  ///< metres within which it takes points; above 0, may be infinite
  };

  /// Throws std::invalid_argument for points that are not finite.
  NearestNodes(std::vector<Vec3> points, Progress& progress);

  /// Compares all living points with the new nodes, which have the numbers `first`, `first` + 1, ... Ties go to the
  /// node with the lower number. Throws Cancelled.
  void add_nodes(NodeIndex first, std::span<const NewNode> nodes, Progress& progress);

  std::size_t living() const { return living_; }
  /// Returns the living point nearest to a position, or nothing if no point is left.
  std::optional<Vec3> nearest_point(Vec3 position) const;

  /// Calls `keeps(position, node, squared distance)` for every living point that a node influences. Removes the point
  /// if it returns false. The order is unspecified. `expect(node)` is called a little earlier, so that the caller can
  /// prefetch data of the node.
  template <class Keeps, class Expect>
  void sweep(Keeps keeps, Expect expect) {
    for (std::vector<Leaf>& part : influenced_) {
      std::size_t left = 0;
      for (std::size_t i = 0; i < part.size(); ++i) {
        const Leaf leaf = part[i];
        const Leaf next = part[std::min(i + 1, part.size() - 1)];
        for (std::uint32_t k = begin_[next]; k < end_[next]; ++k) {
          if (node_[k] != kNoNode) expect(node_[k]);
        }
        for (std::uint32_t k = begin_[leaf]; k < end_[leaf];) {
          if (node_[k] == kNoNode || keeps(Vec3(x_[k], y_[k], z_[k]), node_[k], distance2_[k])) {
            ++k;
          } else {
            remove(leaf, k);
          }
        }
        if (begin_[leaf] < end_[leaf]) part[left++] = leaf;
      }
      part.resize(left);
    }
  }

  template <class Keeps>
  void sweep(Keeps keeps) {
    sweep(keeps, [](NodeIndex) {});
  }

 private:
  using Leaf = std::uint32_t;

  /// The new nodes of a round as a structure of arrays.
  struct Candidates {
    NodeIndex first = 0;
    std::vector<float> x, y, z;
    std::vector<float> within2;  // squared influence distances
    bool are_alike = true;       // true if all influence distances are equal
  };

  /// The working memory of a thread that descends one part of the tree.
  struct Descent {
    const Candidates* candidates;
    // Lists of candidates near the tree nodes on the path; the list of a child is above that of its parent.
    std::vector<std::uint32_t> stack;
  };

  void descend_in_parts(const Candidates& candidates, const Progress& progress);
  void start_descent(int level, std::uint32_t index, std::span<const std::uint32_t> near, const Candidates& candidates);
  void descend(int level, std::uint32_t index, std::size_t first, std::size_t last, Descent& descent);
  std::size_t push_near(std::uint32_t tree_node, std::size_t first, std::size_t last, Descent& descent) const;
  bool is_near(std::uint32_t tree_node, std::uint32_t candidate, const Candidates& candidates) const;
  bool compare(Leaf leaf, std::span<const std::uint32_t> near, const Candidates& candidates);
  void join_halves(std::uint32_t tree_node) {
    farthest2_[tree_node] = std::max(farthest2_[2 * tree_node + 1], farthest2_[2 * tree_node + 2]);
  }
  void remove(Leaf leaf, std::uint32_t point);

  std::size_t living_;
  PointTree tree_;
  int part_level_;  // threads share the subtrees below this level

  // By point, in the tree's order.
  std::vector<float> x_, y_, z_;
  std::vector<float> distance2_;  // squared distance to the nearest node; infinite without one
  std::vector<NodeIndex> node_;

  std::vector<float> farthest2_;  // by tree node: upper bound of distance2_ of its living points
  // By leaf: its living points are [begin, end).
  std::vector<std::uint32_t> begin_;
  std::vector<std::uint32_t> end_;
  std::vector<std::uint8_t> is_influenced_;    // by leaf: a node has influenced one of its points
  std::vector<std::vector<Leaf>> influenced_;  // such leaves, for each part
};

}  // namespace meristem
