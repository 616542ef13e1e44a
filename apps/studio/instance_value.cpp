// SPDX-License-Identifier: Apache-2.0
// Finds the instance of a visible part and lists its facts. An organ is found by the nearest frame, a stem by the
// nearest segment. Values of expressions are computed at the component's first instance, or with the variables alone.
#include "instance_value.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "meristem/base/expression/expression.h"
#include "meristem/components/expanded.h"
#include "meristem/export/packet/short_values.h"
#include "meristem/graph/instances.h"
#include "meristem/plant/axis_labels.h"
#include "shoot_places.h"

namespace meristem::studio {

namespace {

float squared(Vec3 v) { return glm::dot(v, v); }

float distance_squared(const Frame& a, const Frame& b) {
  float sum = squared(a.origin - b.origin);
  for (int k = 0; k < 3; ++k) sum += squared(a.axes[k] - b.axes[k]);
  return sum;
}

/// Returns the number of the component's organ whose frame is nearest.
std::optional<std::uint64_t> nearest_organ(const Plant& plant, const std::string& component, const Frame& frame) {
  std::optional<std::uint64_t> nearest;
  float min = std::numeric_limits<float>::max();
  std::uint64_t number = 0;
  std::vector<bool> is_wanted;
  for (const OrganPrototype& prototype : plant.prototypes) is_wanted.push_back(prototype.component == component);
  for (const Organ& organ : plant.organs) {
    if (!is_wanted[organ.prototype]) continue;
    const float distance = distance_squared(organ.frame, frame);
    if (distance < min) {
      min = distance;
      nearest = number;
    }
    ++number;
  }
  return nearest;
}

/// Returns the facts about the shoot of a position: its name, its course, and the metamer at the position.
Value::Object shoot_value(const ShootPlace& place) {
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
          {"stem", static_cast<double>(place.stem->part(place.axis).instance)},
          {"tree", static_cast<double>(name.tree)},
          {"metamer", is_below ? 0.0 : static_cast<double>(numbers[place.node])},
          {"course", std::move(course)},
          {"metamers", std::move(metamers)}};
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

/// Returns the facts about a part of the plant, including its shoot if it is on one. Returns null if the instance is
/// unknown.
Value told_instance(const GrownPlant& grown, const InstanceQuery& request, const ShootPlace& place, Progress& progress,
                    GrowthCache& cache) {
  const Document& document = *grown.document;
  const auto found = find_instance(document.graph, document.scene, grown.time, request, progress, &cache, grown.view);
  if (!found) return {};
  Value::Object told = described(request.component, *found);
  Value::Object shoot = place.stem != nullptr ? shoot_value(place) : Value::Object{{"shoot", Value()}};
  for (Value::Member& member : shoot) told.push_back(std::move(member));
  const auto prototype = std::ranges::find(document.graph.components, request.component, &Prototype::id);
  const auto last = prototype != document.graph.components.end() ? last_iteration(*prototype) : std::nullopt;
  told.emplace_back("iteration", last ? Value(*last) : Value());
  return told;
}

Value told_shoot(const GrownPlant& grown, const std::string& component, const ShootPlace& place, Progress& progress,
                 GrowthCache& cache) {
  const InstanceQuery request{
      .component = component, .of = InstanceQuery::Of::stem, .number = place.stem->part(place.axis).instance};
  return told_instance(grown, request, place, progress, cache);
}

std::optional<FoundInstance> first_instance(const GrownPlant& grown, const std::string& component, Progress& progress,
                                            GrowthCache& cache) {
  const Document& document = *grown.document;
  const InstanceQuery request{.component = component, .of = InstanceQuery::Of::instance};
  return find_instance(document.graph, document.scene, grown.time, request, progress, &cache, grown.view);
}

/// Returns the value of an expression that uses only the document's variables. Returns nothing for other expressions,
/// and for texts that are no expression.
std::optional<double> constant_of(const std::string& text, const ExpressionNames& names, const SizeLimits& limits) {
  try {
    const Expression expression = Expression::compile(text, names, limits.expression_bytes);
    if (!expression.is_constant()) return std::nullopt;
    const double value = expression.evaluate();
    return std::isfinite(value) ? std::optional(value) : std::nullopt;
  } catch (const ExpressionError&) {
    return std::nullopt;
  }
}

}  // namespace

std::string instance_key(const Site& site) { return fmt::format("{:016x}", site.key.bits()); }

Value instance_value(const GrownPlant& grown, const InstanceRequest& request, Progress& progress, GrowthCache& cache) {
  const bool is_in_world = request.frame.axes == Mat3(1) && request.frame.origin == Vec3(0);
  const ShootPlace place = is_in_world ? nearest_shoot(grown.plant, request.component, request.position) : ShootPlace();
  if (place.stem != nullptr) return told_shoot(grown, request.component, place, progress, cache);
  const std::optional<std::uint64_t> number = nearest_organ(grown.plant, request.component, request.frame);
  if (!number) return {};
  return told_instance(grown, {.component = request.component, .number = *number}, {}, progress, cache);
}

Value shoot_instance_value(const GrownPlant& grown, const ShootRequest& request, Progress& progress,
                           GrowthCache& cache) {
  const ShootPlace place = requested_shoot(grown.plant, request);
  if (place.stem == nullptr) return {};
  return told_shoot(grown, request.component, place, progress, cache);
}

Value stand_value(const GrownPlant& grown, const std::string& component, Progress& progress, GrowthCache& cache) {
  const auto found = first_instance(grown, component, progress, cache);
  if (!found) return {};
  Value::List rows;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) rows.push_back(static_cast<double>(found->site.frame.axes[column][row]));
    rows.push_back(static_cast<double>(found->site.frame.origin[row]));
  }
  return rows;
}

Value worked_out_value(const GrownPlant& grown, const WorkedOutRequest& request, Progress& progress,
                       GrowthCache& cache) {
  std::map<std::string, double> of_instance;
  if (request.component) {
    if (const auto found = first_instance(grown, *request.component, progress, cache))
      of_instance.insert(found->values.begin(), found->values.end());
  }
  ExpressionNames names;
  for (const Variable& variable : grown.document->variables) {
    if (variable.per.empty()) names.constants.push_back({variable.name, variable.value});
  }
  Value::Object numbers;
  for (const auto& [path, text] : request.expressions) {
    progress.check();
    const auto known = of_instance.find(path);
    const std::optional<double> number = known != of_instance.end()
                                             ? std::optional(known->second)
                                             : constant_of(text, names, grown.document->graph.limits);
    if (number) numbers.emplace_back(path, *number);
  }
  return numbers;
}

}  // namespace meristem::studio
