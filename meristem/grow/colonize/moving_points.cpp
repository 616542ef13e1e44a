// SPDX-License-Identifier: Apache-2.0
// Updates the nearest nodes of moving points with lower bounds, so that most points need no search. See
// moving_points.h.
#include "meristem/grow/colonize/moving_points.h"

#include <cmath>
#include <stdexcept>
#include <utility>

#include "meristem/base/parallel.h"

namespace meristem {
namespace {

constexpr std::size_t kPointsPerBlock = 256;
constexpr float kBelow = 0.999998F;  // margin for the rounding of a distance or of several moves

float squared_distance(Vec3 a, Vec3 b) { return squared_length(a - b); }

}  // namespace

MovingPoints::MovingPoints(std::vector<MovingPoint> points) : points_(std::move(points)) {
  for (const MovingPoint& point : points_) {
    if (!std::isfinite(point.position.x + point.position.y + point.position.z)) {
      throw std::invalid_argument("attraction points must be finite");
    }
  }
}

void MovingPoints::add_nodes(NodeIndex first, std::span<const NewNode> nodes, const Progress& progress) {
  std::vector<NumberedPoint> places;
  places.reserve(nodes.size());
  for (const NewNode& node : nodes) {
    places.push_back({node.position, first + static_cast<NodeIndex>(places.size())});
    nodes_.push_back({node.position, node.influence * node.influence});
    are_alike_ = are_alike_ && nodes_.back().within2 == nodes_.front().within2;
    widest_ = std::max(widest_, node.influence);
  }
  forest_.add(places, progress);
  std::optional<NodeTree> added;
  if (!places.empty()) added.emplace(std::move(places), progress);
  parallel_for(points_.size(), kPointsPerBlock, [&](std::size_t begin, std::size_t end) {
    progress.check();
    for (std::size_t k = begin; k < end; ++k) update(points_[k], added);
  });
}

void MovingPoints::update(MovingPoint& point, const std::optional<NodeTree>& added) const {
  NearestFew nearest;
  for (std::uint32_t k = 0; k < point.known_count; ++k) {
    nearest.offer(point.known[k], squared_distance(point.position, nodes_[point.known[k]].position));
  }
  if (added && point.others > 0) {
    float within2 = std::min(point.others * point.others, nearest.within2());
    added->visit(point.position, within2, [&](NodeIndex node, float square) {
      nearest.offer(node, square);
      within2 = std::min(within2, nearest.within2());
    });
  }
  const bool is_sure = nearest.count() > 0 && std::sqrt(nearest.distance2(0)) < point.others;
  if (!is_sure) {
    // The known nodes bound the search.
    forest_.search(point.position, nearest);
    point.others = std::numeric_limits<float>::infinity();
  }
  static_assert(NearestFew::kMax == MovingPoint::kMaxKnown + 1);
  point.known_count = static_cast<std::uint32_t>(std::min(nearest.count(), MovingPoint::kMaxKnown));
  for (std::uint32_t k = 0; k < point.known_count; ++k) point.known[k] = nearest.node(k);
  point.others = std::min(point.others, kBelow * std::sqrt(nearest.within2()));
  find_influence(point, nearest);
}

/// Sets the node that influences a point, given its nearest nodes.
void MovingPoints::find_influence(MovingPoint& point, const NearestFew& nearest) const {
  const auto reaches = [&](NodeIndex node, float square) { return square <= nodes_[node].within2; };
  point.node = kNoNode;
  point.distance2 = std::numeric_limits<float>::infinity();
  if (nearest.count() == 0) return;
  if (reaches(nearest.node(0), nearest.distance2(0))) {
    point.node = nearest.node(0);
    point.distance2 = nearest.distance2(0);
  } else if (!are_alike_) {
    // A tree with a larger reach may influence the point past a nearer node that does not reach it.
    float within2 = widest_ * widest_;
    for (const NodeTree& tree : forest_.trees()) {
      tree.visit(point.position, within2, [&](NodeIndex node, float square) {
        if (!reaches(node, square) || square > point.distance2) return;
        if (square == point.distance2 && node > point.node) return;
        point.node = node;
        point.distance2 = square;
        within2 = square;
      });
    }
  }
}

void MovingPoints::move(std::size_t index, Vec3 to) {
  MovingPoint& point = points_[index];
  point.others -= std::sqrt(squared_distance(to, point.position)) / kBelow;
  point.position = to;
  if (point.node != kNoNode) point.distance2 = squared_distance(to, nodes_[point.node].position);
}

std::optional<Vec3> MovingPoints::nearest_point(Vec3 position) const {
  std::optional<Vec3> nearest;
  float min2 = std::numeric_limits<float>::infinity();
  for (const MovingPoint& point : points_) {
    const float square = squared_distance(point.position, position);
    if (square >= min2) continue;
    min2 = square;
    nearest = point.position;
  }
  return nearest;
}

}  // namespace meristem
