// SPDX-License-Identifier: Apache-2.0
// Converts the entities of one scale to nodes in one pass, because an entity comes after the entity that bears it.
#include "meristem/plant/mtg/mtg_skeleton.h"

#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

#include <fmt/format.h>

#include "meristem/base/number_limit.h"
#include "meristem/base/reading_stop.h"
#include "meristem/plant/mtg/mtg_columns.h"
#include "meristem/plant/mtg/mtg_text.h"

namespace meristem {
namespace {

class SkeletonReader {
 public:
  SkeletonReader(const MtgTree& tree, const std::string& file, const MtgGeometry& geometry)
      : tree_(tree), file_(file), geometry_(geometry) {}

  MtgSkeleton read(const SizeLimits& limits) {
    for (std::size_t k = 0; k < 3; ++k) {
      position_.at(k) = metres(feature_of(geometry_.position.at(k)), geometry_.length_unit);
    }
    read_diameters();
    const int finest = node_scale();
    node_.assign(tree_.vertex_count(), kNoNode);
    continued_.assign(tree_.vertex_count(), false);
    std::vector<bool> begun(tree_.vertex_count(), false);
    StopCounter stop;
    for (MtgVertex vertex = 1; vertex < tree_.vertex_count(); ++vertex) {
      stop.step();
      if (tree_.scale(vertex) != finest) continue;
      if (tree_.parent[vertex] != kNoVertex) {
        add_borne(vertex);
      } else {
        add_root(vertex, !begun[tree_.complex[vertex]]);
      }
      begun[tree_.complex[vertex]] = true;
    }
    read_mtg_columns(tree_, file_, node_, taken_, limits, made_);
    return std::move(made_);
  }

 private:
  /// Returns the scale of the entities that become nodes.
  int node_scale() const {
    const int finest = tree_.finest_scale();
    if (!geometry_.scale) return finest;
    for (MtgVertex vertex = 1; vertex < tree_.vertex_count(); ++vertex) {
      if (tree_.scale(vertex) == *geometry_.scale) return *geometry_.scale;
    }
    throw InputError(Diagnostic{.message = fmt::format("there are no entities of scale {}", *geometry_.scale),
                                .expected = fmt::format("a scale that the file has, up to {}", finest),
                                .file = file_});
  }

  /// Returns the index of a feature and excludes it from the further columns.
  std::uint32_t feature_of(const std::string& name) {
    const auto feature = tree_.find_feature(name);
    taken_.push_back(name);
    if (feature) return *feature;
    std::vector<std::string> names;
    for (const MtgFeature& declared : tree_.features) names.push_back(declared.name);
    const std::string nearest = names.size() > 1000 ? "" : nearest_name(name, names);
    throw InputError(Diagnostic{.message = fmt::format("there is no feature '{}'", name),
                                .expected = fmt::format("features with the coordinates ({}) and diameters of entities",
                                                        fmt::join(geometry_.position, ", ")),
                                .nearest = nearest,
                                .file = file_});
  }

  /// Returns the lengths of all vertices in metres, NaN if missing. Lengths already in metres are rounded only once.
  std::vector<double> metres(std::uint32_t feature, double unit) const {
    constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();
    std::vector<double> lengths;
    lengths.reserve(tree_.vertex_count());
    StopCounter stop;
    for (const std::string_view text : tree_.texts(feature)) {
      stop.step();
      const auto exact = unit == 1 ? to_float(text) : std::nullopt;
      lengths.push_back(exact ? *exact : unit * to_number(text).value_or(kMissing));
    }
    return lengths;
  }

  void read_diameters() {
    if (!geometry_.diameter.empty()) {
      diameter_ = metres(feature_of(geometry_.diameter), geometry_.diameter_unit);
      return;
    }
    for (const char* const usual : {"TopDia", "TopDiameter"}) {
      if (!tree_.find_feature(usual)) continue;
      diameter_ = metres(feature_of(usual), geometry_.diameter_unit);
      return;
    }
    diameter_.assign(tree_.vertex_count(), std::numeric_limits<double>::quiet_NaN());
  }

  [[noreturn]] void fail(MtgVertex vertex, std::string message, std::string expected) const {
    throw InputError(Diagnostic{.message = std::move(message),
                                .expected = std::move(expected),
                                .file = file_,
                                .line = static_cast<int>(tree_.line[vertex])});
  }

  /// Returns the position of an entity if all three coordinates are present.
  std::optional<Vec3> position(MtgVertex vertex) const {
    DVec3 given;
    for (int k = 0; k < 3; ++k) given[k] = position_.at(static_cast<std::size_t>(k))[vertex];
    if (std::isnan(given.x + given.y + given.z)) return {};
    if (std::abs(given.x) > kMaxCoordinate || std::abs(given.y) > kMaxCoordinate ||
        std::abs(given.z) > kMaxCoordinate) {
      fail(vertex, fmt::format("{} is too far away", tree_.label(vertex)),
           fmt::format("coordinates within {:.0f} m", kMaxCoordinate));
    }
    return Vec3(given.x, given.z, -given.y);
  }

  std::optional<float> radius(MtgVertex vertex) const {
    const double diameter = diameter_[vertex];
    if (std::isnan(diameter)) return {};
    if (diameter < 0 || diameter > 2 * kMaxRadius) {
      fail(vertex, fmt::format("{} has a diameter of {:.4g} m", tree_.label(vertex), diameter),
           fmt::format("one from 0 to {:.0f} m", 2 * kMaxRadius));
    }
    return static_cast<float>(diameter / 2);
  }

  NodeIndex add_node(MtgVertex vertex, NodeIndex parent, Vec3 position, float radius) {
    Skeleton& skeleton = made_.skeleton;
    const NodeIndex node = skeleton.add_node(parent, position, 0);
    skeleton.radius[node] = radius;
    made_.vertex.push_back(vertex);
    node_[vertex] = node;
    return node;
  }

  void add_borne(MtgVertex vertex) {
    Skeleton& skeleton = made_.skeleton;
    const MtgVertex bearer = tree_.parent[vertex];
    const NodeIndex parent = node_[bearer];
    const auto given = position(vertex);
    if (!given) ++made_.guessed;
    const NodeIndex node = add_node(vertex, parent, given.value_or(skeleton.position[parent]),
                                    radius(vertex).value_or(skeleton.radius[parent]));
    if (tree_.edge[vertex] == MtgEdge::successor && !continued_[bearer]) {
      continued_[bearer] = true;
      skeleton.axis[node] = skeleton.axis[parent];
      skeleton.order[node] = skeleton.order[parent];
      return;
    }
    if (skeleton.order[parent] == std::numeric_limits<std::uint16_t>::max()) {
      fail(vertex, fmt::format("the branching order of {} is too high", tree_.label(vertex)),
           fmt::format("orders up to {}", std::numeric_limits<std::uint16_t>::max()));
    }
    skeleton.axis[node] = axes_++;
    skeleton.order[node] = static_cast<std::uint16_t>(skeleton.order[parent] + 1);
  }

  void add_root(MtgVertex vertex, bool begins_complex) {
    std::optional<Vec3> base;
    MtgVertex whole = tree_.complex[vertex];
    // Find the coordinates of the coarser entity that this one begins, from the next scale up.
    for (; begins_complex && whole != kNoVertex; whole = tree_.complex[whole]) {
      base = position(whole);
      if (base) break;
    }
    const auto given = position(vertex);
    if (!given && !base) {
      fail(vertex, fmt::format("{} has no coordinates", tree_.label(vertex)),
           fmt::format("{} of the first entity of a plant", fmt::join(geometry_.position, ", ")));
    }
    const float thickness = radius(vertex).value_or(0);
    NodeIndex parent = kNoNode;
    if (base) parent = add_node(whole, kNoNode, *base, radius(whole).value_or(thickness));
    if (!given) ++made_.guessed;
    const NodeIndex node = add_node(vertex, parent, given.value_or(base.value_or(Vec3(0))), thickness);
    made_.skeleton.axis[node] = axes_;
    if (parent != kNoNode) made_.skeleton.axis[parent] = axes_;
    ++axes_;
  }

  const MtgTree& tree_;
  const std::string& file_;
  const MtgGeometry& geometry_;
  std::array<std::vector<double>, 3> position_;  // metres
  std::vector<double> diameter_;                 // metres
  std::vector<std::string> taken_;               // the features of both
  std::vector<NodeIndex> node_;                  // node of each vertex
  std::vector<bool> continued_;                  // true if the axis of the vertex has been continued
  AxisIndex axes_ = 0;
  MtgSkeleton made_;
};

}  // namespace

MtgSkeleton skeleton_of(const MtgTree& tree, const std::string& file, const MtgGeometry& geometry,
                        const SizeLimits& limits) {
  if (!(geometry.length_unit > 0) || !(geometry.diameter_unit > 0)) {
    throw std::invalid_argument("the units of an MTG's geometry must be above 0");
  }
  return SkeletonReader(tree, file, geometry).read(limits);
}

}  // namespace meristem
