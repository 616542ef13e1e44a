// SPDX-License-Identifier: Apache-2.0
#include "meristem/grow/colonize/attraction_cloud.h"

#include <algorithm>
#include <cmath>

namespace meristem {
namespace {

constexpr double kUnit = 274'877'906'944;  // 2^38: sums of up to 2^25 unit vectors fit into 64 bits

std::int64_t in_units(double component) { return static_cast<std::int64_t>(component * kUnit); }

}  // namespace

AttractionCloud::Tree AttractionCloud::join(Vec3 root, const std::vector<Vec3>& points, double influence, double kill) {
  if (trees_.empty()) origin_ = root;
  const auto tree = static_cast<Tree>(trees_.size());
  Member& member = trees_.emplace_back();
  member.offset = root - origin_;
  member.influence = static_cast<float>(influence);
  const auto reach = static_cast<float>(kill);
  member.kill2 = reach * reach;
  points_.reserve(points_.size() + points.size());
  for (const Vec3 point : points) points_.push_back(point - origin_);
  add_node(tree, Vec3(0));
  return tree;
}

void AttractionCloud::add_node(Tree tree, Vec3 position) {
  Member& member = trees_[tree];
  new_nodes_.push_back({member.offset + position, tree, member.node_count++, 0});
}

std::optional<Vec3> AttractionCloud::nearest_point(Tree tree) const {
  if (!nearest_) return std::nullopt;
  const Vec3 offset = trees_[tree].offset;
  const std::optional<Vec3> point = nearest_->nearest_point(offset);
  return point ? std::optional(*point - offset) : std::nullopt;
}

void AttractionCloud::begin_round(Progress& progress) {
  progress.check();
  // Points near a root pull it once before they are used up.
  const bool kills = nearest_.has_value();
  if (!nearest_) nearest_.emplace(std::move(points_), progress);
  const auto first_new = static_cast<NodeIndex>(nodes_.size());
  take_new_nodes(progress);
  gather_pulls(first_new, kills);
}

void AttractionCloud::take_new_nodes(Progress& progress) {
  std::vector<NearestNodes::NewNode> added;
  added.reserve(new_nodes_.size());
  for (const Node& node : new_nodes_) added.push_back({node.position, trees_[node.tree].influence});
  nearest_->add_nodes(static_cast<NodeIndex>(nodes_.size()), added, progress);
  nodes_.insert(nodes_.end(), new_nodes_.begin(), new_nodes_.end());
  new_nodes_.clear();
}

void AttractionCloud::gather_pulls(NodeIndex first_new, bool kills) {
  for (Member& member : trees_) {
    member.pulls.clear();
    member.advances = 0;
  }
  // Use points up, and sum up the others by node.
  sums_.clear();
  nearest_->sweep([&](Vec3 point, NodeIndex node, float distance2) {
    Member& member = trees_[nodes_[node].tree];
    const bool is_used_up = kills && distance2 <= member.kill2;
    if (is_used_up || node >= first_new) ++member.advances;
    if (!is_used_up) add_pull(node, point);
    return !is_used_up;
  });
  // Hand the sums to their trees in the order of the nodes.
  std::sort(sums_.begin(), sums_.end(), [](const Sum& a, const Sum& b) { return a.node < b.node; });
  for (const Sum& sum : sums_) {
    Node& node = nodes_[sum.node];
    node.sum = 0;
    const DVec3 units(static_cast<double>(sum.x), static_cast<double>(sum.y), static_cast<double>(sum.z));
    trees_[node.tree].pulls.push_back({node.index, units / kUnit});
  }
}

void AttractionCloud::add_pull(std::uint32_t index, Vec3 point) {
  Node& node = nodes_[index];
  if (node.sum == 0) {
    sums_.push_back({index, 0, 0, 0});
    node.sum = static_cast<std::uint32_t>(sums_.size());
  }
  // A point exactly on its node pulls nowhere.
  const DVec3 offset = DVec3(point) - DVec3(node.position);
  const double length2 = (offset.x * offset.x + offset.z * offset.z) + offset.y * offset.y;
  if (length2 == 0) return;
  const double scale = 1 / std::sqrt(length2);
  Sum& sum = sums_[node.sum - 1];
  sum.x += in_units(offset.x * scale);
  sum.y += in_units(offset.y * scale);
  sum.z += in_units(offset.z * scale);
}

}  // namespace meristem
