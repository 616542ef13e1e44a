// SPDX-License-Identifier: Apache-2.0
// Living attraction points that move, and for each the nearest node that influences it.
//
// A point that has looked knows the few nodes around it and how far all others are at least. New nodes that come nearer
// it gets to know at once. As long as one it knows must be the nearest, however far it has moved, it only measures
// those anew; else it looks again, in trees of all nodes.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "meristem/base/progress.h"
#include "meristem/grow/colonize/nearest_nodes.h"
#include "meristem/grow/colonize/node_forest.h"

namespace meristem {

struct MovingPoint {
  Vec3 position{0};
  std::uint32_t cloud = 0;                                   ///< any number of its group
  bool is_inert = false;                                     ///< pulls nothing and is not used up
  NodeIndex node = kNoNode;                                  ///< that influences it
  float distance2 = std::numeric_limits<float>::infinity();  ///< squared, to it

 private:
  friend class MovingPoints;
  static constexpr std::size_t kMostKnown = 8;  // with 1 growth takes a third longer
  std::array<NodeIndex, kMostKnown> known{};
  std::uint32_t known_count = 0;
  float others = -1;  // all nodes that it does not know are at least so far away; below 0 where nothing is sure
};

class MovingPoints {
 public:
  using NewNode = NearestNodes::NewNode;

  /// Points must be finite, else std::invalid_argument.
  explicit MovingPoints(std::vector<MovingPoint> points);

  /// Brings all points up to date with the new nodes, which have the numbers `first`, `first` + 1, ..., and with their
  /// own moves. Among nodes at the same distance the one with the lower number counts. Throws Cancelled.
  void add_nodes(NodeIndex first, std::span<const NewNode> nodes, const Progress& progress);

  std::size_t living() const { return points_.size(); }
  std::span<const MovingPoint> points() const { return points_; }
  std::optional<Vec3> nearest_point(Vec3 position) const;

  void set_inert(std::size_t point, bool is_inert) { points_[point].is_inert = is_inert; }
  /// Moves a point; which node is nearest stays as it is until nodes are added.
  void move(std::size_t point, Vec3 to);

  /// As NearestNodes::sweep: for every point that a node influences and that is not inert.
  template <class Keeps>
  void sweep(Keeps keeps) {
    const auto is_done = [&](const MovingPoint& point) {
      return !point.is_inert && point.node != kNoNode && !keeps(point.position, point.node, point.distance2);
    };
    points_.erase(std::remove_if(points_.begin(), points_.end(), is_done), points_.end());
  }

 private:
  struct Node {
    Vec3 position;
    float within2;  // it takes points whose squared distances are at most this
  };

  void update(MovingPoint& point, const std::optional<NodeTree>& added) const;
  void find_influence(MovingPoint& point, const NearestFew& nearest) const;

  std::vector<MovingPoint> points_;
  std::vector<Node> nodes_;
  NodeForest forest_;
  float widest_ = 0;       // influence of any node
  bool are_alike_ = true;  // all nodes have that
};

}  // namespace meristem
