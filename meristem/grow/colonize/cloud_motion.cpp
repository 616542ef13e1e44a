// SPDX-License-Identifier: Apache-2.0
// Moves the points of each cloud by a common shift and a drift of each point, both toward brighter positions, and along
// the fields around its tree. Light is computed once per node that pulls points.
#include "meristem/grow/colonize/cloud_motion.h"

#include <algorithm>
#include <cmath>

#include "meristem/base/parallel.h"
#include "meristem/scene/brighter_way.h"

namespace meristem {
namespace {

constexpr std::size_t kNodesPerBlock = 16;
constexpr std::size_t kMovingPointsPerBlock = 1024;

}  // namespace

void CloudMotion::move(MovingPoints& points, const Progress& progress) {
  const std::vector<Pulled> pulled = pulled_nodes(points);
  if (pulled.empty()) return;
  pulls_.assign(clouds_.size(), 0);
  for (const Pulled& one : pulled) pulls_[one.cloud] = 1;
  seek_light(pulled, progress);
  const std::vector<DVec3> shift = shifts(pulled);
  const std::vector<double> factors = height_factors(points, shift);
  const bool has_obstacles = !scene_.obstacles.empty();
  parallel_for(points.living(), kMovingPointsPerBlock, [&](std::size_t begin, std::size_t end) {
    progress.check();
    for (std::size_t k = begin; k < end; ++k) {
      const MovingPoint& point = points.points()[k];
      const Cloud& cloud = clouds_[point.cloud];
      if (!cloud.response.moves()) continue;
      DVec3 to = DVec3(point.position) + displacement(point, shift);
      to.y = cloud.base + (to.y - cloud.base) * factors[point.cloud];
      points.move(k, Vec3(to));
      if (has_obstacles) points.set_inert(k, scene_.obstacles.contain(origin_ + Vec3(to)));
    }
  });
}

/// Returns all nodes that pull points of moving clouds, sorted by cloud and node, without duplicates.
std::vector<CloudMotion::Pulled> CloudMotion::pulled_nodes(const MovingPoints& points) const {
  std::vector<Pulled> pulled;
  for (const MovingPoint& point : points.points()) {
    if (point.node == kNoNode || point.is_inert || !clouds_[point.cloud].response.moves()) continue;
    pulled.push_back({point.cloud, point.node});
  }
  std::sort(pulled.begin(), pulled.end());
  pulled.erase(std::unique(pulled.begin(), pulled.end()), pulled.end());
  return pulled;
}

void CloudMotion::seek_light(std::span<const Pulled> pulled, const Progress& progress) {
  std::vector<NodeIndex> unknown;
  for (const Pulled& one : pulled) {
    if (!clouds_[one.cloud].response.seeks_light()) continue;
    if (!nodes_[one.node].knows_light) unknown.push_back(one.node);
    nodes_[one.node].knows_light = true;
  }
  parallel_for(unknown.size(), kNodesPerBlock, [&](std::size_t begin, std::size_t end) {
    progress.check();
    for (std::size_t k = begin; k < end; ++k) {
      Node& node = nodes_[unknown[k]];
      node.brighter = brighter_way(scene_, origin_ + node.position, node.sunlit_weight);
    }
  });
}

/// Returns the common shift of each cloud.
std::vector<DVec3> CloudMotion::shifts(std::span<const Pulled> pulled) const {
  std::vector<DVec3> shifts(clouds_.size(), DVec3(0));
  for (const Pulled& one : pulled) shifts[one.cloud] += nodes_[one.node].brighter;
  for (std::size_t k = 0; k < shifts.size(); ++k) {
    const double size = std::sqrt(squared_length(shifts[k]));
    shifts[k] = size > 1e-12 ? shifts[k] * (clouds_[k].response.shift / size) : DVec3(0);
  }
  return shifts;
}

DVec3 CloudMotion::displacement(const MovingPoint& point, std::span<const DVec3> shifts) const {
  const double drift = clouds_[point.cloud].response.drift;
  DVec3 way = shifts[point.cloud];
  if (drift != 0 && point.node != kNoNode && !point.is_inert) way += drift * nodes_[point.node].brighter;
  return way + carried(point);
}

/// Returns the movement of a point along the fields at its position.
DVec3 CloudMotion::carried(const MovingPoint& point) const {
  const Cloud& cloud = clouds_[point.cloud];
  if (cloud.response.field == 0 || pulls_[point.cloud] == 0) return DVec3(0);
  const Vec3 position = origin_ + point.position;
  const Vec3 pull =
      cloud.directions.light_sense().given_at(position) + cloud.directions.gravity_sense().given_at(position);
  return cloud.response.field * DVec3(pull);
}

/// Returns the scale factor for the heights of each cloud that keeps the mean height of its points, and so its top,
/// constant.
std::vector<double> CloudMotion::height_factors(const MovingPoints& points, std::span<const DVec3> shifts) const {
  std::vector<double> rise(clouds_.size(), 0);
  std::vector<std::uint64_t> count(clouds_.size(), 0);
  for (const MovingPoint& point : points.points()) {
    if (!clouds_[point.cloud].response.hold_height) continue;
    rise[point.cloud] += displacement(point, shifts).y;
    ++count[point.cloud];
  }
  std::vector<double> factors(clouds_.size(), 1);
  for (std::size_t k = 0; k < clouds_.size(); ++k) {
    if (count[k] == 0 || !(clouds_[k].top > 0)) continue;
    const double top = clouds_[k].top + rise[k] / static_cast<double>(count[k]);
    if (top > 0.5 * clouds_[k].top) factors[k] = clouds_[k].top / top;
  }
  return factors;
}

}  // namespace meristem
