// SPDX-License-Identifier: Apache-2.0
#include "instance_value.h"

#include <limits>
#include <optional>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "meristem/graph/instances.h"
#include "meristem/plant/axis_labels.h"

namespace meristem::studio {

namespace {

/// The place on a stem that is nearest to a point.
struct StemPlace {
  const Stem* stem = nullptr;
  AxisIndex axis = 0;
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
      nearest = {&stem, skeleton.axis[node]};
    }
  }
  return nearest;
}

Value vector_value(Vec3 v) { return Value::List{v.x, v.y, v.z}; }

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
  const Document& document = *grown.wish.document;
  InstanceWish wish{.component = request.component};
  Value shoot;
  const bool is_in_world = request.frame.axes == Mat3(1) && request.frame.origin == Vec3(0);
  const StemPlace place = is_in_world ? nearest_stem(grown.plant, request.component, request.position) : StemPlace();
  if (place.stem != nullptr) {
    wish.of = InstanceWish::Of::stem;
    wish.number = place.stem->part(place.axis).instance;
    shoot = axis_labels(place.stem->skeleton)[place.axis];
  } else {
    const std::optional<std::uint64_t> number = nearest_organ(grown.plant, request.component, request.frame);
    if (!number) return {};
    wish.number = *number;
  }
  const auto found = find_instance(document.graph, document.scene, grown.time, wish, progress, &cache, grown.view);
  if (!found) return {};
  Value::Object told = described(request.component, *found);
  told.emplace_back("shoot", std::move(shoot));
  return told;
}

}  // namespace meristem::studio
