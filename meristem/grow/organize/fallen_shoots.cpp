// SPDX-License-Identifier: Apache-2.0
// Rebuilds the skeleton with all shoots that have fallen, by the birth numbers of metamers.
#include "meristem/grow/organize/fallen_shoots.h"

#include <algorithm>
#include <string>
#include <unordered_map>
#include <utility>

#include "meristem/base/frame.h"
#include "meristem/base/math.h"
#include "meristem/plant/further_columns.h"
#include "meristem/plant/growth_in_time.h"

namespace meristem {

namespace {

/// Returns the angle in radians about the axis from its upper side to the lateral bud.
float angle_of_bud(const Metamers& metamers, MetamerIndex metamer) {
  const Frame frame = frame_along(Vec3(0), metamers.heading(metamer), kUp);
  const Vec3 side = metamers.side[metamer];
  return static_cast<float>(math::atan2(glm::dot(side, frame.right()), glm::dot(side, frame.upper())));
}

}  // namespace

void FallenShoots::number_all(std::size_t count) {
  while (numbers_.size() < count) numbers_.push_back(next_number_++);
}

void FallenShoots::note(const Metamers& metamers, MetamerIndex first, int iteration) {
  number_all(metamers.count());
  for (const MetamerIndex metamer : metamers.with_borne(first)) {
    const MetamerIndex parent = metamers.parent[metamer];
    fallen_.push_back({.number = numbers_[metamer],
                       .parent = numbers_[parent],
                       .internode = metamers.tip[metamer] - metamers.tip[parent],
                       .birth = static_cast<float>(metamers.birth[metamer]),
                       .falls = static_cast<float>(iteration),
                       .on_axis = static_cast<float>(metamers.number[metamer]),
                       .bud_angle = angle_of_bud(metamers, metamer),
                       .order = metamers.order[metamer],
                       .begins_axis = metamers.begins_shoot(metamer)});
  }
}

void FallenShoots::forget(const std::vector<std::uint8_t>& gone) {
  number_all(gone.size());
  erase_marked(numbers_, gone);
}

Skeleton FallenShoots::with_fallen(Skeleton standing, const PipeModel& model) {
  number_all(standing.node_count());
  if (fallen_.empty()) return standing;
  std::ranges::sort(fallen_, {}, &Fallen::number);
  Skeleton all;
  all.operations = std::move(standing.operations);
  all.reserve(standing.node_count() + fallen_.size());
  for (const auto& [name, values] : standing.extra) all.extra[name];
  std::vector<float>& falls = all.extra[std::string(kFallsColumn)];
  std::vector<NodeIndex> place(next_number_, kNoNode);
  std::unordered_map<AxisIndex, AxisIndex> axes;  // of the standing skeleton
  AxisIndex next_axis = 0;
  const auto fill = [&] {
    for (auto& [name, values] : all.extra) values.resize(all.node_count(), 0);
  };
  const auto add_fallen = [&](const Fallen& one) {
    const NodeIndex parent = place[one.parent];
    const NodeIndex made = all.add_node(parent, all.position[parent] + one.internode, one.birth);
    place[one.number] = made;
    fill();
    falls[made] = one.falls;
    all.extra.find(kMetamerColumn)->second[made] = one.on_axis;
    all.extra.find(kBudAngleColumn)->second[made] = one.bud_angle;
    all.order[made] = one.order;
    all.axis[made] = one.begins_axis ? next_axis++ : all.axis[parent];
  };
  const auto add_standing = [&](NodeIndex node) {
    const NodeIndex parent = standing.parent[node];
    const NodeIndex made = all.add_node(parent == kNoNode ? kNoNode : place[numbers_[parent]], standing.position[node],
                                        standing.birth[node]);
    place[numbers_[node]] = made;
    fill();
    for (const auto& [name, values] : standing.extra) all.extra.find(name)->second[made] = values[node];
    all.radius[made] = standing.radius[node];
    all.order[made] = standing.order[node];
    const auto [axis, is_new] = axes.try_emplace(standing.axis[node], next_axis);
    if (is_new) ++next_axis;
    all.axis[made] = axis->second;
  };
  std::size_t next = 0;
  for (NodeIndex node = 0; node < standing.node_count(); ++node) {
    for (; next < fallen_.size() && fallen_[next].number < numbers_[node]; ++next) add_fallen(fallen_[next]);
    add_standing(node);
  }
  for (; next < fallen_.size(); ++next) add_fallen(fallen_[next]);

  // A fallen branch was no thicker than the wood that bore it.
  const std::vector<float> pipes = pipe_radii(all.parent, {}, model);
  for (NodeIndex node = 0; node < all.node_count(); ++node) {
    if (all.radius[node] == 0) all.radius[node] = std::min(pipes[node], all.radius[all.parent[node]]);
  }
  return all;
}

}  // namespace meristem
