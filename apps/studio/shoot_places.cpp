// SPDX-License-Identifier: Apache-2.0
// Finds positions on the shoots of a plant. A point is compared with all segments. Names are labels such as
// "main.4.2b", in which each part counts the metamers of a shoot, so neighbours in the tree follow from the labels.
#include "shoot_places.h"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>
#include <vector>

#include <glm/geometric.hpp>

#include "meristem/plant/axis_labels.h"

namespace meristem::studio {

namespace {

using Go = ShootRequest::Go;

float squared_length(Vec3 v) { return glm::dot(v, v); }

/// Returns the signed distance from a point to the surface around a segment of a skeleton.
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
  const bool is_below =
      squared_length(point - skeleton.position[below]) < squared_length(point - skeleton.position[node]);
  return is_below ? below : node;
}

/// Returns the label of the parent shoot: "main.4" for "main.4.2b". Returns an empty text for "main".
std::string_view bearing_label(std::string_view label) {
  const std::size_t dot = label.rfind('.');
  return dot == std::string_view::npos ? std::string_view() : label.substr(0, dot);
}

/// Returns the number of the metamer from which a shoot branches off: 2 for "main.4.2b".
std::uint32_t bearing_number(std::string_view label) {
  const std::string_view last = label.substr(label.rfind('.') + 1);
  std::uint32_t number = 0;
  std::from_chars(last.data(), last.data() + last.size(), number);
  return number;
}

/// The shoots of one stem, with their names.
class NamedShoots {
 public:
  explicit NamedShoots(const Stem& stem)
      : stem_(stem), numbers_(axis_numbers(stem.skeleton)), names_(shoot_names(stem.skeleton, stem.part_of_axis)) {}

  const std::vector<ShootName>& names() const { return names_; }

  std::optional<AxisIndex> find(const ShootName& name) const {
    const auto found = std::ranges::find(names_, name);
    if (found == names_.end()) return std::nullopt;
    return static_cast<AxisIndex>(found - names_.begin());
  }

  /// Returns the child shoots of a shoot, from its base on.
  std::vector<AxisIndex> borne_by(AxisIndex axis) const {
    const ShootName& bearer = names_[axis];
    std::vector<AxisIndex> borne;
    for (AxisIndex other = 0; other < names_.size(); ++other) {
      const ShootName& name = names_[other];
      if (name.part == bearer.part && name.tree == bearer.tree && bearing_label(name.label) == bearer.label)
        borne.push_back(other);
    }
    std::ranges::stable_sort(borne, {}, [&](AxisIndex other) { return bearing_number(names_[other].label); });
    return borne;
  }

  /// Returns the last position of a shoot up to a metamer, but at least its first metamer. Metamer 0 is where the shoot
  /// branches off.
  ShootPlace place_at(AxisIndex axis, std::uint32_t metamer) const {
    const std::vector<NodeIndex> nodes = shoot_nodes(stem_.skeleton, axis);
    ShootPlace place{.stem = &stem_, .axis = axis, .node = nodes.front()};
    for (const NodeIndex node : nodes) {
      if (stem_.skeleton.axis[node] != axis) continue;
      const bool is_first = place.node == nodes.front() && metamer > 0;
      if (is_first || numbers_[node] <= metamer) place.node = node;
    }
    return place;
  }

  /// Returns the parent of a shoot. Returns nothing for the main stem of a tree.
  std::optional<AxisIndex> bearer_of(AxisIndex axis) const {
    const ShootName& name = names_[axis];
    const std::string_view label = bearing_label(name.label);
    return label.empty() ? std::nullopt : find({name.part, name.tree, std::string(label)});
  }

 private:
  const Stem& stem_;
  const std::vector<std::uint32_t> numbers_;  // by node
  const std::vector<ShootName> names_;        // by axis
};

/// The main stems of all trees of a component, in their order. The named tree is at index `named`.
struct MainShoots {
  std::vector<ShootPlace> places;
  std::optional<std::size_t> named;
};

MainShoots main_shoots(const Plant& plant, const ShootRequest& request) {
  MainShoots all;
  for (const Stem& stem : plant.stems) {
    const bool has_some =
        std::ranges::any_of(stem.parts, [&](const StemPart& part) { return part.component == request.component; });
    if (!has_some) continue;
    const NamedShoots shoots(stem);
    for (AxisIndex axis = 0; axis < shoots.names().size(); ++axis) {
      const ShootName& name = shoots.names()[axis];
      const StemPart& part = stem.part(axis);
      if (name.label != "main" || part.component != request.component) continue;
      if (request.of && part.instance == request.of->stem && name.tree == request.of->tree)
        all.named = all.places.size();
      all.places.push_back(shoots.place_at(axis, 1));
    }
  }
  return all;
}

/// Returns the next or previous index in a circle. Returns nothing if there is only one.
std::optional<std::size_t> beside(std::size_t index, std::size_t count, Go go) {
  if (count < 2) return std::nullopt;
  return (index + (go == Go::next ? 1 : count - 1)) % count;
}

ShootPlace place_beside(const NamedShoots& shoots, AxisIndex axis, const ShootRequest& request) {
  const ShootName& name = shoots.names()[axis];
  const std::optional<AxisIndex> bearer = shoots.bearer_of(axis);
  switch (request.go) {
    case Go::nowhere:
      return shoots.place_at(axis, request.of->metamer);
    case Go::parent:
      return bearer ? shoots.place_at(*bearer, bearing_number(name.label)) : ShootPlace();
    case Go::child: {
      const std::vector<AxisIndex> borne = shoots.borne_by(axis);
      if (borne.empty()) return {};
      const auto above = std::ranges::find_if(
          borne, [&](AxisIndex other) { return bearing_number(shoots.names()[other].label) >= request.of->metamer; });
      return shoots.place_at(above == borne.end() ? borne.back() : *above, 1);
    }
    case Go::next:
    case Go::previous: {
      if (!bearer) return {};
      const std::vector<AxisIndex> all = shoots.borne_by(*bearer);
      const auto index = static_cast<std::size_t>(std::ranges::find(all, axis) - all.begin());
      const auto other = beside(index, all.size(), request.go);
      return other ? shoots.place_at(all[*other], 1) : ShootPlace();
    }
  }
  return {};
}

}  // namespace

ShootPlace nearest_shoot(const Plant& plant, const std::string& component, Vec3 point) {
  ShootPlace nearest;
  float min = std::numeric_limits<float>::max();
  for (const Stem& stem : plant.stems) {
    const Skeleton& skeleton = stem.skeleton;
    for (NodeIndex node = 0; node < skeleton.node_count(); ++node) {
      if (stem.part(skeleton.axis[node]).component != component) continue;
      const float distance = distance_to_segment(skeleton, node, point);
      if (distance >= min) continue;
      min = distance;
      nearest = {.stem = &stem, .axis = skeleton.axis[node], .node = nearer_end(skeleton, node, point)};
    }
  }
  return nearest;
}

ShootPlace requested_shoot(const Plant& plant, const ShootRequest& request) {
  const bool is_sideways = request.go == Go::next || request.go == Go::previous;
  if (!request.of || (is_sideways && request.of->shoot == "main")) {
    const MainShoots all = main_shoots(plant, request);
    if (!request.of) return all.places.empty() ? ShootPlace() : all.places.front();
    const auto other = all.named ? beside(*all.named, all.places.size(), request.go) : std::nullopt;
    return other ? all.places[*other] : ShootPlace();
  }
  for (const Stem& stem : plant.stems) {
    for (std::uint32_t part = 0; part < stem.parts.size(); ++part) {
      if (stem.parts[part].component != request.component || stem.parts[part].instance != request.of->stem) continue;
      const NamedShoots shoots(stem);
      const auto axis = shoots.find({part, request.of->tree, request.of->shoot});
      return axis ? place_beside(shoots, *axis, request) : ShootPlace();
    }
  }
  return {};
}

}  // namespace meristem::studio
