// SPDX-License-Identifier: Apache-2.0
#include "meristem/shape/tube_plan.h"

#include "meristem/base/frame.h"
#include "meristem/base/math.h"
#include "meristem/base/parallel.h"

namespace meristem {
namespace {

constexpr float kCosSharpestMitre = 0.25881905F;     // 75 degrees
constexpr float kCosSharpestFanOfTwo = -0.8660254F;  // 150 degrees
constexpr float kHidden = 0.95F;      // of the mother's inner radius that a lateral's first ring may fill
constexpr float kBarkReach = 6;       // of the mother's radius along her axis that a collar may touch
constexpr float kFlareHeight = 4;     // of a root's radius
constexpr float kLeastCollar = 0.3F;  // of a branch's radius that must exceed what roundness allows
constexpr std::size_t kAxesPerBlock = 64;

}  // namespace

std::uint32_t fan_size(float cosine) {
  return cosine >= kCosSharpestMitre ? 1 : cosine >= kCosSharpestFanOfTwo ? 2 : 3;
}

float flare_factor(const Surface& surface, float base_radius, float metres) {
  const float left = std::max(0.0F, 1 - metres / (kFlareHeight * base_radius));
  return 1 + surface.flare * left * left * left;
}

TubePlan::TubePlan(const Skeleton& skeleton, const Surface& surface)
    : skeleton_(skeleton), surface_(surface), axes_(skeleton) {
  most_sides_ = std::max(3, surface.sides);
  for (const float radius : skeleton.radius) thickest_ = std::max(thickest_, radius);
  plans_.resize(axes_.count());
  radii_.resize(skeleton.node_count());
  parallel_for(plans_.size(), kAxesPerBlock, [this](std::size_t begin, std::size_t end) {
    for (std::size_t axis = begin; axis < end; ++axis) smooth_radii(static_cast<AxisIndex>(axis));
  });
  // Sides first: how much of a lateral its mother hides depends on hers.
  parallel_for(plans_.size(), kAxesPerBlock, [this](std::size_t begin, std::size_t end) {
    for (std::size_t axis = begin; axis < end; ++axis) choose_sides(static_cast<AxisIndex>(axis));
  });
  parallel_for(plans_.size(), kAxesPerBlock, [this](std::size_t begin, std::size_t end) {
    for (std::size_t axis = begin; axis < end; ++axis) count_rings(static_cast<AxisIndex>(axis));
  });
  for (std::size_t axis = 0; axis < plans_.size(); ++axis) {
    plans_[axis].first_vertex = size_.vertices;
    plans_[axis].first_triangle = size_.triangles;
    size_.vertices += plans_[axis].vertices(path(static_cast<AxisIndex>(axis)).is_lateral());
    size_.triangles += plans_[axis].triangles();
  }
}

AxisPath TubePlan::path(AxisIndex axis) const {
  const std::span<const NodeIndex> nodes = axes_.of(axis);
  return {&skeleton_, radii_, nodes, nodes.empty() ? kNoNode : skeleton_.parent[nodes[0]]};
}

Bark TubePlan::bark_below(const AxisPath& lateral) const {
  const AxisPath mother = path(skeleton_.axis[lateral.mother]);
  const auto found = std::lower_bound(mother.nodes.begin(), mother.nodes.end(), lateral.mother);
  const auto point = static_cast<std::size_t>(found - mother.nodes.begin()) + (mother.is_lateral() ? 1 : 0);
  return {mother, point, kBarkReach * mother.radius(point)};
}

/// Spreads the steps in which radii fall at forks: each becomes the mean over so much of the axis to both sides, less
/// near its ends, which keep theirs.
void TubePlan::smooth_radii(AxisIndex axis) {
  const std::span<const NodeIndex> nodes = axes_.of(axis);
  for (const NodeIndex node : nodes) radii_[node] = skeleton_.radius[node];
  if (nodes.size() < 3 || !(surface_.smooth > 0)) return;
  // Sum up length and the area under the radii along the axis.
  std::vector<float> way(nodes.size(), 0);
  std::vector<double> area(nodes.size(), 0);
  for (std::size_t i = 1; i < nodes.size(); ++i) {
    const float length = glm::distance(skeleton_.position[nodes[i]], skeleton_.position[nodes[i - 1]]);
    way[i] = way[i - 1] + length;
    area[i] = area[i - 1] + 0.5 * length * (skeleton_.radius[nodes[i - 1]] + skeleton_.radius[nodes[i]]);
  }
  const auto area_before = [&](float place) {
    const auto after = std::upper_bound(way.begin() + 1, way.end() - 1, place);
    const auto i = static_cast<std::size_t>(after - way.begin()) - 1;
    const float from = skeleton_.radius[nodes[i]];
    const float length = way[i + 1] - way[i];
    const float share = length > 0 ? (place - way[i]) / length : 0;
    const float to = glm::mix(from, skeleton_.radius[nodes[i + 1]], share);
    return area[i] + 0.5 * (place - way[i]) * (from + to);
  };
  for (std::size_t i = 1; i + 1 < nodes.size(); ++i) {
    const float room = std::min(way[i], way.back() - way[i]);
    const float half = std::min(surface_.smooth * skeleton_.radius[nodes[i]], room);
    if (!(half > 1e-3F * skeleton_.radius[nodes[i]])) continue;
    const double mean = (area_before(way[i] + half) - area_before(way[i] - half)) / (2.0 * half);
    radii_[nodes[i]] = static_cast<float>(mean);
  }
}

void TubePlan::choose_sides(AxisIndex axis) {
  const AxisPath points = path(axis);
  if (points.size() == 0) return;
  const double share = thickest_ > 0 ? math::pow(std::min(1.0F, points.radius(0) / thickest_), 1.0 / 3) : 0;
  plans_[axis].sides = static_cast<std::uint32_t>(std::max(3.0, std::floor(most_sides_ * share + 0.5)));
}

void TubePlan::count_rings(AxisIndex axis) {
  const AxisPath points = path(axis);
  if (points.size() < 2) return;
  AxisPlan& plan = plans_[axis];
  plan_start(points, plan);
  // The start, the bends between it and the tip, and the tip.
  plan.rings = plan.collar ? AxisPlan::kCollarRings + 1 : 2 + plan.flare_rings;
  Vec3 before = plan.collar ? plan.collar->direction : points.direction(0, kUp);
  for (std::size_t i = plan.collar ? plan.collar->next_point : 1; i + 1 < points.size(); ++i) {
    const Vec3 after = points.direction(i, before);
    plan.rings += fan_size(glm::dot(before, after));
    before = after;
  }
}

void TubePlan::plan_start(const AxisPath& points, AxisPlan& plan) const {
  plan.start_radius = points.radius(0);
  if (!points.is_lateral()) {
    // Where nodes are far apart the flare needs rings of its own.
    const float first = glm::distance(points.position(0), points.position(1));
    if (surface_.flare > 0 && first > 0.5F * kFlareHeight * plan.start_radius) plan.flare_rings = AxisPlan::kFlareRings;
    return;
  }
  const float roundness = thickest_ * static_cast<float>(1 - math::cos(kPi / most_sides_));
  if (surface_.collar > 0 && kLeastCollar * plan.start_radius > roundness) {
    plan.collar = plan_collar(points, bark_below(points), surface_.collar);
    plan.sink = 2 * roundness;
  }
  if (!plan.collar) plan.start_radius = std::min(plan.start_radius, room_inside(points.mother));
}

/// The radius of the largest disc about a node that its tube hides however the disc is turned.
float TubePlan::room_inside(NodeIndex node) const {
  const std::span<const NodeIndex> nodes = axes_.of(skeleton_.axis[node]);
  const float radius = std::max(radii_[node], kThinnestTube);
  // The flats of the tube are nearer than its corners, and where it tapers the nearest point lies ahead.
  const double flat = math::cos(kPi / plans_[skeleton_.axis[node]].sides);
  const auto next = std::upper_bound(nodes.begin(), nodes.end(), node);
  double taper = 0;
  if (next != nodes.end()) {
    const float length = glm::distance(skeleton_.position[*next], skeleton_.position[node]);
    taper = std::max(0.0F, radius - radii_[*next]) / std::max(length, kThinnestTube);
  }
  return static_cast<float>(kHidden * radius * flat / std::sqrt(1 + taper * taper));
}

}  // namespace meristem
