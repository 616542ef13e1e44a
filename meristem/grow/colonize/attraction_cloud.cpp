// SPDX-License-Identifier: Apache-2.0
// Two data structures find the nearest node of each point. For points at rest, new nodes descend through a tree of
// points (nearest_nodes.h). If points move, each point stores the few nodes around it (moving_points.h). Both give
// equal results for a cloud at rest; the second is seven times as slow.
#include "meristem/grow/colonize/attraction_cloud.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "meristem/base/parallel.h"
#include "meristem/grow/colonize/approach.h"
#include "meristem/scene/light_of_points.h"

namespace meristem {
namespace {

constexpr double kUnit = 274'877'906'944;  // 2^38: sums of up to 2^25 unit vectors fit into 64 bits

constexpr std::size_t kTreesPerBlock = 64;

std::int64_t in_units(double component) { return static_cast<std::int64_t>(component * kUnit); }

}  // namespace

AttractionCloud::Tree AttractionCloud::join(Vec3 root, const std::vector<Vec3>& points, const Attraction& attraction,
                                            const Scene& scene, const ShadowGrid* shade) {
  scene_ = &scene;
  if (trees_.empty()) origin_ = root;
  const auto tree = static_cast<Tree>(trees_.size());
  Member& member = trees_.emplace_back();
  member.offset = root - origin_;
  member.attraction = attraction;
  if (attraction.light.shade) member.shade = shade;
  any_feels_shade_ = any_feels_shade_ || member.shade != nullptr;
  const auto reach = static_cast<float>(attraction.kill);
  member.kill2 = reach * reach;
  member.points = points.size();
  for (const Vec3 point : points) points_.push_back(point - origin_);
  add_node(tree, Vec3(0));
  return tree;
}

void AttractionCloud::add_node(Tree tree, Vec3 position) {
  Member& member = trees_[tree];
  new_nodes_.push_back({member.offset + position, tree, member.node_count++, 0, member.kill2});
}

std::optional<Vec3> AttractionCloud::nearest_point(Tree tree) const {
  const Member& member = trees_[tree];
  if (member.nearest_own || (!still_ && !moving_)) return member.nearest_own;
  const auto point = still_ ? still_->nearest_point(member.offset) : moving_->nearest_point(member.offset);
  return point ? std::optional(*point - member.offset) : std::nullopt;
}

void AttractionCloud::begin_round(Progress& progress) {
  progress.check();
  // In the first round, points near a root pull it once before they are used up.
  const bool is_first = !still_ && !moving_;
  if (is_first) plant_points(progress);
  if (record_) record_->begin_step();
  const auto first_new = static_cast<NodeIndex>(nodes_.size());
  take_new_nodes(progress);
  for (Member& member : trees_) {
    member.pulls.clear();
    member.advances = 0;
  }
  if (still_) {
    gather_still(first_new, !is_first);
  } else {
    gather_moving(!is_first, progress);
  }
  hand_over_pulls();
}

/// Uses up the points near the nodes of the last step, and computes the history of each point.
void AttractionCloud::end_record(Progress& progress) {
  if (!record_) return;
  const auto first_new = static_cast<NodeIndex>(nodes_.size());
  if (still_ || moving_) {
    record_->begin_step();
    take_new_nodes(progress);
  }
  if (still_) gather_still(first_new, true);
  if (moving_) use_up_moving(true);
  histories_ = record_->histories(trees_.size(), progress);
  record_.reset();
}

/// Uses up points, and adds the pulls of the others to their nodes.
void AttractionCloud::gather_still(NodeIndex first_new, bool kills) {
  const auto keeps = [&](Vec3 point, NodeIndex node, float distance2) {
    const bool goes = kills && distance2 <= nodes_[node].kill2;
    if (!goes && any_feels_shade_ && is_too_dark(trees_[nodes_[node].tree], point)) return true;
    if (goes || node >= first_new) ++trees_[nodes_[node].tree].advances;
    if (goes && record_) record_->use_up(point);
    if (!goes) add_pull(node, point);
    return !goes;
  };
  // Adjacent points may belong to nodes of different rounds, which are far apart in memory, so prefetch them.
  still_->sweep(keeps, [&](NodeIndex node) { __builtin_prefetch(&nodes_[node]); });
}

/// Gathers the pulls of moving points: they pull from their positions after the move.
void AttractionCloud::gather_moving(bool kills, const Progress& progress) {
  use_up_moving(kills);
  for (Member& member : trees_) note_closeness(member);
  motion_->move(*moving_, progress);
  moving_->sweep([&](Vec3 point, NodeIndex node, float) {
    if (!is_too_dark(trees_[nodes_[node].tree], point)) add_pull(node, point);
    return true;
  });
}

void AttractionCloud::use_up_moving(bool kills) {
  if (record_ && kills) {
    std::vector<Vec3> places;
    places.reserve(moving_->living());
    for (const MovingPoint& point : moving_->points()) places.push_back(point.position);
    record_->place(std::move(places));
  }
  moving_->sweep([&](Vec3 point, NodeIndex node, float distance2) {
    const bool goes = kills && distance2 <= nodes_[node].kill2;
    Member& member = trees_[nodes_[node].tree];
    if (goes) ++member.advances;
    if (goes && record_) record_->use_up(point);
    if (!goes && !is_too_dark(member, point)) member.now_closest2 = std::min(member.now_closest2, distance2);
    return !goes;
  });
}

/// Counts an advance if a tree in a moving cloud comes nearer to its nearest point. Two points that move along on both
/// sides of a tip are no advance.
void AttractionCloud::note_closeness(Member& member) {
  constexpr float kNearer = 0.998F;
  const bool gains = member.now_closest2 < kNearer * member.closest2;
  if (gains || member.advances > 0) member.closest2 = member.now_closest2;
  if (gains) ++member.advances;
  member.now_closest2 = std::numeric_limits<float>::infinity();
}

bool AttractionCloud::is_too_dark(const Member& member, Vec3 point) const {
  return member.shade != nullptr && 1 - member.shade->shade(origin_ + point) < member.attraction.light.shade->bears;
}

/// Builds the data structure of the points for all rounds.
void AttractionCloud::plant_points(Progress& progress) {
  leave_out_darkest(progress);
  if (record_) record_points();
  std::size_t first = 0;
  for (Member& member : trees_) {
    const std::span<const Vec3> own = std::span(points_).subspan(first, member.points);
    if (const auto nearest = nearest_of(own, member.offset)) member.nearest_own = *nearest - member.offset;
    first += member.points;
  }
  const auto moves = [](const Member& member) { return member.attraction.light.moves(); };
  if (std::any_of(trees_.begin(), trees_.end(), moves)) {
    start_moving();
  } else {
    still_.emplace(std::move(points_), progress);
  }
  points_ = {};
}

/// Records the points that take part in growth. Removed points are recorded when they are removed.
void AttractionCloud::record_points() {
  std::size_t next = 0;
  for (Tree tree = 0; tree < trees_.size(); ++tree) {
    for (std::size_t k = 0; k < trees_[tree].points; ++k) record_->bring(tree, points_[next++], false);
  }
}

/// Removes the darkest share of each tree's points. Points of other trees cast shade, too.
void AttractionCloud::leave_out_darkest(const Progress& progress) {
  if (scene_ == nullptr || scene_->light.is_none()) return;
  std::vector<Vec3> kept;
  std::vector<Vec3> world;
  std::optional<LightLimit> known;  // parameters for which `light` was computed
  std::vector<double> light;
  std::size_t first = 0;
  for (Member& member : trees_) {
    const LightLimit& limit = member.attraction.light.limit;
    const std::span<const Vec3> own = std::span(points_).subspan(first, member.points);
    first += member.points;
    if (!(limit.share > 0)) {
      kept.insert(kept.end(), own.begin(), own.end());
      continue;
    }
    if (world.empty()) {
      for (const Vec3 point : points_) world.push_back(origin_ + point);
    }
    if (!known || known->radius != limit.radius || known->k != limit.k) {
      light = light_of_points(world, *scene_, limit.radius, limit.k, progress);
      known = limit;
    }
    const std::span<const double> own_light = std::span(light).subspan(first - member.points, member.points);
    const std::vector<std::uint32_t> left = brightest(own_light, limit.share);
    for (const std::uint32_t point : left) kept.push_back(own[point]);
    if (record_) record_removed(static_cast<Tree>(&member - trees_.data()), own, left);
    member.points = left.size();
  }
  points_ = std::move(kept);
}

void AttractionCloud::record_removed(Tree tree, std::span<const Vec3> points, std::span<const std::uint32_t> left) {
  std::vector<std::uint8_t> is_left(points.size(), 0);
  for (const std::uint32_t point : left) is_left[point] = 1;
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (is_left[k] == 0) record_->bring(tree, points[k], true);
  }
}

void AttractionCloud::start_moving() {
  std::vector<MovingPoint> points;
  std::vector<CloudMotion::Cloud> clouds;
  for (const Member& member : trees_) {
    CloudMotion::Cloud cloud{member.attraction.light, member.offset.y, 0, member.attraction.directions};
    for (std::size_t k = 0; k < member.points; ++k) {
      MovingPoint& point = points.emplace_back();
      point.position = points_[points.size() - 1];
      point.cloud = static_cast<std::uint32_t>(clouds.size());
      cloud.top = std::max(cloud.top, static_cast<double>(point.position.y) - cloud.base);
    }
    clouds.push_back(std::move(cloud));
  }
  moving_.emplace(std::move(points));
  motion_.emplace(*scene_, origin_, std::move(clouds));
}

void AttractionCloud::take_new_nodes(Progress& progress) {
  std::vector<NearestNodes::NewNode> added;
  added.reserve(new_nodes_.size());
  for (const Node& node : new_nodes_) {
    const Attraction& attraction = trees_[node.tree].attraction;
    added.push_back({node.position, static_cast<float>(attraction.influence)});
    if (motion_) motion_->add_node(node.position, attraction.light.sunlit_weight);
  }
  const auto first = static_cast<NodeIndex>(nodes_.size());
  if (still_) still_->add_nodes(first, added, progress);
  if (moving_) moving_->add_nodes(first, added, progress);
  nodes_.insert(nodes_.end(), new_nodes_.begin(), new_nodes_.end());
  new_nodes_.clear();
}

/// Distributes the sums to their trees, sorted by node.
void AttractionCloud::hand_over_pulls() {
  for (const Sum& sum : sums_) {
    Node& node = nodes_[sum.node];
    node.sum = 0;
    const DVec3 units(static_cast<double>(sum.x), static_cast<double>(sum.y), static_cast<double>(sum.z));
    trees_[node.tree].pulls.push_back({node.index, units / kUnit});
  }
  sums_.clear();
  parallel_for(trees_.size(), kTreesPerBlock, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      std::sort(trees_[k].pulls.begin(), trees_[k].pulls.end(),
                [](const Pull& a, const Pull& b) { return a.node < b.node; });
    }
  });
}

void AttractionCloud::add_pull(std::uint32_t index, Vec3 point) {
  Node& node = nodes_[index];
  if (node.sum == 0) {
    sums_.push_back({index, 0, 0, 0});
    node.sum = static_cast<std::uint32_t>(sums_.size());
  }
  // A point exactly at its node pulls in no direction.
  const DVec3 offset = DVec3(point) - DVec3(node.position);
  const double square = squared_length(offset);
  if (square == 0) return;
  const double scale = 1 / std::sqrt(square);
  Sum& sum = sums_[node.sum - 1];
  sum.x += in_units(offset.x * scale);
  sum.y += in_units(offset.y * scale);
  sum.z += in_units(offset.z * scale);
}

}  // namespace meristem
