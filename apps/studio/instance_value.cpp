// SPDX-License-Identifier: Apache-2.0
#include "instance_value.h"

#include <algorithm>
#include <limits>
#include <optional>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "meristem/components/expanded.h"
#include "meristem/graph/instances.h"
#include "meristem/output/packet/short_values.h"
#include "meristem/plant/axis_labels.h"

namespace meristem::studio {

namespace {

/// The place on a stem that is nearest to a point.
struct StemPlace {
  const Stem* stem = nullptr;
  AxisIndex axis = 0;
  NodeIndex node =
      0;  // the end of its segment that is nearer; where that is the lower one of a shoot's first, its parent
};

float squared(Vec3 v) { return glm::dot(v, v); }

float distance_squared(const Frame& a, const Frame& b) {
  float sum = squared(a.origin - b.origin);
  for (int k = 0; k < 3; ++k) sum += squared(a.axes[k] - b.axes[k]);
  return sum;
}

/// Number of the component's organ whose frame is nearest.
std::optional<std::uint64_t> nearest_organ(const Plant& plant, const std::string& component, const Frame& frame) {
  std::optional<std::uint64_t> nearest;
  float least = std::numeric_limits<float>::max();
  std::uint64_t number = 0;
  std::vector<bool> is_wanted;
  for (const OrganPrototype& prototype : plant.prototypes) is_wanted.push_back(prototype.component == component);
  for (const Organ& organ : plant.organs) {
    if (!is_wanted[organ.prototype]) continue;
    const float distance = distance_squared(organ.frame, frame);
    if (distance < least) {
      least = distance;
      nearest = number;
    }
    ++number;
  }
  return nearest;
}

/// Signed distance from a point to the surface about a segment of a skeleton.
float distance_to_segment(const Skeleton& skeleton, NodeIndex node, Vec3 point) {
  const Vec3 end = skeleton.position[node];
  if (skeleton.is_root(node)) return glm::length(point - end) - skeleton.radius[node];
  const Vec3 way = end - skeleton.position[skeleton.parent[node]];
  const float length = glm::dot(way, way);
  const float along = length > 0 ? glm::clamp(glm::dot(point - (end - way), way) / length, 0.0F, 1.0F) : 1.0F;
  return glm::length(point - (end - way + along * way)) - skeleton.radius[node];
}

NodeIndex nearer_end(const Skeleton& skeleton, NodeIndex node, Vec3 point) {
  if (skeleton.is_root(node)) return node;
  const NodeIndex below = skeleton.parent[node];
  return squared(point - skeleton.position[below]) < squared(point - skeleton.position[node]) ? below : node;
}

/// What is told of the shoot on which a place lies: its name, where it runs, and the metamer at the place.
Value::Object shoot_value(const StemPlace& place) {
  const Skeleton& skeleton = place.stem->skeleton;
  const std::vector<std::uint32_t> numbers = axis_numbers(skeleton);
  const ShootName name = shoot_names(skeleton, place.stem->part_of_axis)[place.axis];
  Value::List course;
  Value::List metamers;
  for (const NodeIndex node : shoot_nodes(skeleton, place.axis)) {
    for (int axis = 0; axis < 3; ++axis) course.emplace_back(static_cast<double>(skeleton.position[node][axis]));
    metamers.emplace_back(skeleton.axis[node] == place.axis ? static_cast<double>(numbers[node]) : 0.0);
  }
  const bool is_below = skeleton.axis[place.node] != place.axis;
  return {{"shoot", name.label},
          {"tree", static_cast<double>(name.tree)},
          {"metamer", is_below ? 0.0 : static_cast<double>(numbers[place.node])},
          {"course", std::move(course)},
          {"metamers", std::move(metamers)}};
}

StemPlace nearest_stem(const Plant& plant, const std::string& component, Vec3 point) {
  StemPlace nearest;
  float least = std::numeric_limits<float>::max();
  for (const Stem& stem : plant.stems) {
    const Skeleton& skeleton = stem.skeleton;
    for (NodeIndex node = 0; node < skeleton.node_count(); ++node) {
      if (stem.part(skeleton.axis[node]).component != component) continue;
      const float distance = distance_to_segment(skeleton, node, point);
      if (distance >= least) continue;
      least = distance;
      nearest = {&stem, skeleton.axis[node], nearer_end(skeleton, node, point)};
    }
  }
  return nearest;
}

Value::Object described(const std::string& component, const FoundInstance& found) {
  Value::List values;
  for (const auto& [path, number] : found.values) values.push_back(Value::Object{{"path", path}, {"value", number}});
  return {{"component", component},
          {"key", instance_key(found.site)},
          {"i", static_cast<double>(found.site.i)},
          {"n", static_cast<double>(found.site.n)},
          {"u", found.site.u},
          {"order", static_cast<double>(found.site.order)},
          {"depth", static_cast<double>(found.site.depth)},
          {"position", vector_value(found.site.frame.origin)},
          {"values", std::move(values)}};
}

}  // namespace

std::string instance_key(const Site& site) { return fmt::format("{:016x}", site.key.bits()); }

Value instance_value(const GrownWish& grown, const InstanceRequest& request, Progress& progress, GrowthCache& cache) {
  const Document& document = *grown.document;
  InstanceWish wish{.component = request.component};
  Value::Object shoot{{"shoot", Value()}};
  const bool is_in_world = request.frame.axes == Mat3(1) && request.frame.origin == Vec3(0);
  const StemPlace place = is_in_world ? nearest_stem(grown.plant, request.component, request.position) : StemPlace();
  if (place.stem != nullptr) {
    wish.of = InstanceWish::Of::stem;
    wish.number = place.stem->part(place.axis).instance;
    shoot = shoot_value(place);
  } else {
    const std::optional<std::uint64_t> number = nearest_organ(grown.plant, request.component, request.frame);
    if (!number) return {};
    wish.number = *number;
  }
  const auto found = find_instance(document.graph, document.scene, grown.time, wish, progress, &cache, grown.view);
  if (!found) return {};
  Value::Object told = described(request.component, *found);
  for (Value::Member& member : shoot) told.push_back(std::move(member));
  const auto prototype = std::ranges::find(document.graph.components, request.component, &Prototype::id);
  const auto last = prototype != document.graph.components.end() ? last_iteration(*prototype) : std::nullopt;
  told.emplace_back("iteration", last ? Value(*last) : Value());
  return told;
}

Value stand_value(const GrownWish& grown, const std::string& component, Progress& progress, GrowthCache& cache) {
  const Document& document = *grown.document;
  const auto found =
      find_instance(document.graph, document.scene, grown.time,
                    {.component = component, .of = InstanceWish::Of::instance}, progress, &cache, grown.view);
  if (!found) return {};
  Value::List rows;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) rows.push_back(static_cast<double>(found->site.frame.axes[column][row]));
    rows.push_back(static_cast<double>(found->site.frame.origin[row]));
  }
  return rows;
}

}  // namespace meristem::studio
