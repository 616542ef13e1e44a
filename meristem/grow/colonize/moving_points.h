// SPDX-License-Identifier: Apache-2.0
// Living attraction points that move, and for each point the nearest node that influences it.
//
// Each point stores the few nodes around it and a lower bound for the distance of all other nodes. New nodes within
// this bound are added immediately. While one of the known nodes must be the nearest, an update only measures the known
// nodes. Otherwise it searches trees of all nodes.
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
  std::uint32_t cloud = 0;                                   ///< group number, chosen by the caller
  bool is_inert = false;                                     ///< true: pulls no node and is not used up
  NodeIndex node = kNoNode;                                  ///< the node that influences it
  float distance2 = std::numeric_limits<float>::infinity();  ///< squared distance to that node

 private:
  friend class MovingPoints;
  static constexpr std::size_t kMaxKnown = 8;  // a value of 1 makes growth a third slower
  std::array<NodeIndex, kMaxKnown> known{};
  std::uint32_t known_count = 0;
  float others = -1;  // lower bound for the distance of all unknown nodes; negative if there is no bound
};

class MovingPoints {
 public:
  using NewNode = NearestNodes::NewNode;

  /// Points must be finite. Throws std::invalid_argument otherwise.
  explicit MovingPoints(std::vector<MovingPoint> points);

  /// Adds nodes with the numbers `first`, `first` + 1, ... and updates all points for the new nodes and for their own
  /// moves. Ties go to the node with the lower number. Throws Cancelled.
  void add_nodes(NodeIndex first, std::span<const NewNode> nodes, const Progress& progress);

  std::size_t living() const { return points_.size(); }
  std::span<const MovingPoint> points() const { return points_; }
  std::optional<Vec3> nearest_point(Vec3 position) const;

  void set_inert(std::size_t point, bool is_inert) { points_[point].is_inert = is_inert; }
  /// Moves a point. Its nearest node is updated by the next call of add_nodes().
  void move(std::size_t point, Vec3 to);

  /// Like NearestNodes::sweep(), for every point that a node influences and that is not inert.
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
    float within2;  // squared influence distance
  };

  void update(MovingPoint& point, const std::optional<NodeTree>& added) const;
  void find_influence(MovingPoint& point, const NearestFew& nearest) const;

  std::vector<MovingPoint> points_;
  std::vector<Node> nodes_;
  NodeForest forest_;
  float widest_ = 0;       // largest influence distance of any node
  bool are_alike_ = true;  // true if all nodes have equal influence distances
};

}  // namespace meristem
