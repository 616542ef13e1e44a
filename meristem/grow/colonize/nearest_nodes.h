// SPDX-License-Identifier: Apache-2.0
// The living attraction points and, for each, the nearest node that influences it.
//
// Nodes never move and never go, so a new node can only take points over, and only from nodes that are farther away: a
// point's nearest node is kept, and compared with new nodes alone. A round's new nodes descend a tree of the points
// together; each part of it knows how far its points are from their nodes at most, so parts that are already well
// served are passed by. Costs per new node: the points it comes nearer to, and a few more around.
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
    float influence = 0;  ///< metres within which it takes points, above 0, may be infinite
  };

  /// Throws std::invalid_argument for points that are not finite.
  NearestNodes(std::vector<Vec3> points, Progress& progress);

  /// Compares all living points with the new nodes, which have the numbers `first`, `first` + 1, ... Among nodes at the
  /// same distance the one with the lower number stays. Throws Cancelled.
  void add_nodes(NodeIndex first, std::span<const NewNode> nodes, Progress& progress);

  std::size_t living() const { return living_; }
  /// The living point nearest to a position, if there is one.
  std::optional<Vec3> nearest_point(Vec3 position) const;

  /// Calls `keeps(position, node, squared distance)` for every living point that a node influences, and removes those
  /// for which it says no. The order means nothing. `expect(node)` is called a little before, so that what is known of
  /// a node can be fetched meanwhile.
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

  /// A round's new nodes, structure of arrays.
  struct Candidates {
    NodeIndex first = 0;
    std::vector<float> x, y, z;
    std::vector<float> within2;  // squared distances below this are influenced
    bool are_alike = true;       // in that
  };

  /// What a thread needs to let candidates descend one part of the tree.
  struct Descent {
    const Candidates* candidates;
    std::vector<std::uint32_t> stack;  // which of them are near a node of the tree lies above those near its parent
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
  int part_level_;  // parts of the tree that threads share out are its nodes on this level

  // By point, in the tree's order.
  std::vector<float> x_, y_, z_;
  std::vector<float> distance2_;  // squared, to the nearest node; infinite without one
  std::vector<NodeIndex> node_;

  std::vector<float> farthest2_;  // by node of the tree: no living point in it has a larger distance2
  // By leaf: its living points are [begin, end).
  std::vector<std::uint32_t> begin_;
  std::vector<std::uint32_t> end_;
  std::vector<std::uint8_t> is_influenced_;    // whether a node has influenced a point in it
  std::vector<std::vector<Leaf>> influenced_;  // those leaves, for each part
};

}  // namespace meristem
