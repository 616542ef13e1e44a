// SPDX-License-Identifier: Apache-2.0
// Plans the tubes of a skeleton: sides, rings, collars and successors of each axis, and the place of each tube in its
// mesh. Nodes get no ring where axis and radius are straight within the allowed error. Sizes are known before memory is
// used.
#include "meristem/shape/tube/tube_plan.h"

#include "meristem/base/frame.h"
#include "meristem/base/math.h"
#include "meristem/base/parallel.h"
#include "meristem/plant/trim.h"

namespace meristem {
namespace {

constexpr float kRunsOn = 0.94F;  // cosine of 20 degrees: largest angle at which one axis continues another
constexpr float kAsThick = 0.7F;  // share of a tip's radius: an axis that continues there with at least this radius is
                                  // one piece of wood with it
constexpr float kCosSharpestMitre = 0.25881905F;     // 75 degrees
constexpr float kCosSharpestFanOfTwo = -0.8660254F;  // 150 degrees
constexpr float kHidden = 0.95F;           // share of the parent's inner radius that a lateral's first ring may fill
constexpr float kBarkReach = 6;            // distance along the parent's axis that a collar may touch, in the parent's
                                           // radii
constexpr float kFlareHeight = 4;          // in radii of the root
constexpr float kMinCollar = 0.3F;         // share of a branch's radius that must exceed the allowed roundness error
constexpr std::uint32_t kRoundCollar = 6;  // minimum number of sides; coarser tubes have no collar, which would double
                                           // a twig's triangles
constexpr std::size_t kPlannedAxesPerBlock = 64;

}  // namespace

std::uint32_t fan_size(float cosine) {
  return cosine >= kCosSharpestMitre ? 1 : cosine >= kCosSharpestFanOfTwo ? 2 : 3;
}

float flare_factor(const SurfaceOptions& surface, float base_radius, float metres) {
  const float left = std::max(0.0F, 1 - metres / (kFlareHeight * base_radius));
  return 1 + surface.flare * left * left * left;
}

TubePlan::TubePlan(const Skeleton& skeleton, std::vector<TubeWear> wears, std::vector<std::uint32_t> wear_of_axis,
                   const std::vector<std::uint32_t>& mesh_of_axis, std::span<const Vec3> deformed)
    : skeleton_(&skeleton),
      deformed_(deformed),
      wears_(std::move(wears)),
      wear_of_axis_(std::move(wear_of_axis)),
      axes_(skeleton) {
  thickest_.resize(wears_.size(), 0);
  for (std::size_t node = 0; node < skeleton.node_count(); ++node) {
    float& thickest = thickest_[wear(skeleton.axis[node])];
    thickest = std::max(thickest, skeleton.radius[node]);
  }
  std::uint32_t meshes = 0;
  for (const TubeWear& wear : wears_) {
    max_sides_ = std::max(max_sides_, wear.surface.sides);
    meshes = std::max(meshes, wear.mesh + 1);
  }
  for (const std::uint32_t mesh : mesh_of_axis) meshes = std::max(meshes, mesh + 1);
  plans_.resize(axes_.count());
  radii_.resize(skeleton.node_count());
  kept_.resize(skeleton.node_count());
  kept_count_.resize(axes_.count());
  is_tip_.resize(skeleton.node_count());
  goes_on_.resize(axes_.count());
  base_radius_.resize(axes_.count());
  parallel_for(plans_.size(), kPlannedAxesPerBlock, [this](std::size_t begin, std::size_t end) {
    for (std::size_t axis = begin; axis < end; ++axis) {
      if (wears_[wear(axis)].left_out) continue;
      smooth_radii(static_cast<AxisIndex>(axis));
      choose_rings(static_cast<AxisIndex>(axis));
      const std::span<const NodeIndex> nodes = axes_.of(static_cast<AxisIndex>(axis));
      if (!nodes.empty()) is_tip_[nodes.back()] = 1;
    }
  });
  // Sides first: the hidden part of a lateral depends on the parent's sides.
  parallel_for(plans_.size(), kPlannedAxesPerBlock, [this](std::size_t begin, std::size_t end) {
    for (std::size_t axis = begin; axis < end; ++axis) {
      find_start(static_cast<AxisIndex>(axis));
      choose_sides(static_cast<AxisIndex>(axis));
    }
  });
  find_successors();
  parallel_for(plans_.size(), kPlannedAxesPerBlock, [this](std::size_t begin, std::size_t end) {
    for (std::size_t axis = begin; axis < end; ++axis) count_rings(static_cast<AxisIndex>(axis));
  });
  sizes_.resize(meshes);
  for (std::size_t axis = 0; axis < plans_.size(); ++axis) {
    AxisPlan& plan = plans_[axis];
    plan.mesh = mesh_of_axis.empty() ? wears_[wear(axis)].mesh : mesh_of_axis[axis];
    TubeSize& size = sizes_[plan.mesh];
    plan.first_vertex = size.vertices;
    plan.first_triangle = size.triangles;
    size.vertices += plan.vertices(path(static_cast<AxisIndex>(axis)).is_lateral());
    size.triangles += plan.triangles();
  }
}

AxisPath TubePlan::path(AxisIndex axis) const {
  const auto nodes = std::span(kept_).subspan(axes_.first[axis], kept_count_[axis]);
  if (nodes.empty()) return {skeleton_, radii_, nodes};
  return {skeleton_, radii_, nodes, skeleton_->parent[nodes[0]], base_radius_[axis]};
}

void TubePlan::find_start(AxisIndex axis) {
  if (axes_.of(axis).empty()) return;
  const bool goes_on = find_whether_it_goes_on(axis);
  goes_on_[axis] = goes_on ? 1 : 0;
  base_radius_[axis] = base_radius(axis, goes_on);
}

/// Returns the radius at the start of an axis. A lateral begins with the radius of its first node, because its base is
/// hidden in the parent. An axis that continues a parent's end is visible there. It begins with the radius of its
/// taper, but not more than the parent's tip.
float TubePlan::base_radius(AxisIndex axis, bool goes_on) const {
  const std::span<const NodeIndex> nodes = axes_.of(axis);
  const float first = radii_[nodes[0]];
  const NodeIndex parent = skeleton_->parent[nodes[0]];
  if (nodes.size() < 2 || !goes_on) return first;
  const float before = glm::distance(skeleton_->position[nodes[0]], skeleton_->position[parent]);
  const float after = glm::distance(skeleton_->position[nodes[1]], skeleton_->position[nodes[0]]);
  const float fallen = after > 0 ? (skeleton_->radius[nodes[0]] - skeleton_->radius[nodes[1]]) * before / after : 0;
  return std::clamp(first + fallen, first, std::max(first, skeleton_->radius[parent]));
}

/// Returns true if an axis begins at the tip of another and continues in about the same direction.
bool TubePlan::find_whether_it_goes_on(AxisIndex axis) const {
  const NodeIndex first = axes_.of(axis)[0];
  const NodeIndex parent = skeleton_->parent[first];
  if (parent == kNoNode || is_tip_[parent] == 0) return false;
  const NodeIndex before = skeleton_->parent[parent];
  if (before == kNoNode) return false;
  const Vec3 theirs = unit_or(skeleton_->position[parent] - skeleton_->position[before], Vec3(0));
  const Vec3 own = unit_or(skeleton_->position[first] - skeleton_->position[parent], Vec3(0));
  return glm::dot(theirs, own) > kRunsOn;
}

/// Finds tubes that are one piece of wood. An axis may end where others continue, for example a leader that was cut
/// back to a lateral. The thickest axis that continues with a similar radius succeeds it, if both have equal surfaces.
void TubePlan::find_successors() {
  for (std::size_t axis = 0; axis < plans_.size(); ++axis) {
    if (goes_on_[axis] == 0 || surface(axis).style != SurfaceOptions::Style::tubes || wears_[wear(axis)].left_out)
      continue;
    const NodeIndex first = axes_.of(static_cast<AxisIndex>(axis))[0];
    const NodeIndex tip = skeleton_->parent[first];
    const AxisIndex before = skeleton_->axis[tip];
    const bool is_as_thick = radii_[first] >= kAsThick * radii_[tip] && base_radius_[axis] <= radii_[tip];
    if (!is_as_thick || wear(axis) != wear(before)) continue;
    AxisIndex& successor = plans_[before].successor;
    if (successor == kNoAxis || radii_[axes_.of(successor)[0]] < radii_[first]) {
      successor = static_cast<AxisIndex>(axis);
    }
  }
  for (std::size_t axis = 0; axis < plans_.size(); ++axis) {
    const AxisIndex successor = plans_[axis].successor;
    if (successor == kNoAxis) continue;
    plans_[successor].succeeds = true;
    base_radius_[successor] = radii_[axes_.of(static_cast<AxisIndex>(axis)).back()];
  }
}

float TubePlan::roundness(std::size_t axis) const {
  const double sides = std::max(3, surface(axis).sides);
  return thickest_[wear(axis)] * static_cast<float>(1 - math::cos(kPi / sides));
}

Bark TubePlan::bark_below(const AxisPath& lateral) const {
  const AxisPath parent = path(skeleton_->axis[lateral.parent]);
  // The nearest ring at or before the node.
  const auto after = std::upper_bound(parent.nodes.begin(), parent.nodes.end(), lateral.parent);
  const auto before = static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, after - parent.nodes.begin() - 1));
  const std::size_t point = before + (parent.is_lateral() ? 1 : 0);
  return {parent, point, kBarkReach * parent.radius(point)};
}

/// Spreads the steps of radii at forks. Each radius becomes the mean over a stretch of the axis to both sides. The
/// stretch is shorter near the axis's ends, which keep their radii.
void TubePlan::smooth_radii(AxisIndex axis) {
  const std::span<const NodeIndex> nodes = axes_.of(axis);
  for (const NodeIndex node : nodes) radii_[node] = skeleton_->radius[node];
  const float smooth = surface(axis).smooth;
  if (nodes.size() < 3 || !(smooth > 0)) return;
  // Add up the length, and the area under the radii along the axis.
  std::vector<float> way(nodes.size(), 0);
  std::vector<double> area(nodes.size(), 0);
  for (std::size_t i = 1; i < nodes.size(); ++i) {
    const float length = glm::distance(skeleton_->position[nodes[i]], skeleton_->position[nodes[i - 1]]);
    way[i] = way[i - 1] + length;
    area[i] = area[i - 1] + 0.5 * length * (skeleton_->radius[nodes[i - 1]] + skeleton_->radius[nodes[i]]);
  }
  const auto area_before = [&](float place) {
    const auto after = std::upper_bound(way.begin() + 1, way.end() - 1, place);
    const auto i = static_cast<std::size_t>(after - way.begin()) - 1;
    const float from = skeleton_->radius[nodes[i]];
    const float length = way[i + 1] - way[i];
    const float share = length > 0 ? (place - way[i]) / length : 0;
    const float to = glm::mix(from, skeleton_->radius[nodes[i + 1]], share);
    return area[i] + 0.5 * (place - way[i]) * (from + to);
  };
  for (std::size_t i = 1; i + 1 < nodes.size(); ++i) {
    const float room = std::min(way[i], way.back() - way[i]);
    const float half = std::min(smooth * skeleton_->radius[nodes[i]], room);
    if (!(half > 1e-3F * skeleton_->radius[nodes[i]])) continue;
    const double mean = (area_before(way[i] + half) - area_before(way[i] - half)) / (2.0 * half);
    radii_[nodes[i]] = static_cast<float>(mean);
  }
}

/// Removes nodes between which axis and radius are straight within the allowed error of the surface.
void TubePlan::choose_rings(AxisIndex axis) {
  const std::span<const NodeIndex> nodes = axes_.of(axis);
  const std::span<NodeIndex> kept = std::span(kept_).subspan(axes_.first[axis], nodes.size());
  const float error = surface(axis).error;
  const std::size_t longest = wears_[wear(axis)].longest_run;
  const auto are_straight = [&](std::size_t from, std::size_t to) {
    return is_straight(skeleton_->position, nodes, from, to, error) &&
           (deformed_.empty() || is_straight(deformed_, nodes, from, to, error));
  };
  std::uint32_t count = 0;
  for (std::size_t i = 0; i < nodes.size();) {
    kept[count++] = nodes[i];
    std::size_t next = i + 1;
    // Check only a few nodes at a time, so that the cost stays linear.
    const std::size_t last = std::min(nodes.size() - 1, i + longest);
    while (error > 0 && i > 0 && next < last && are_straight(i, next + 1)) ++next;
    i = next;
  }
  kept_count_[axis] = count;
}

/// Returns true if the nodes between two nodes of the axis lie on the line between them, in position and radius.
bool TubePlan::is_straight(std::span<const Vec3> positions, std::span<const NodeIndex> nodes, std::size_t from,
                           std::size_t to, float error) const {
  const Vec3 base = positions[nodes[from]];
  const Vec3 chord = positions[nodes[to]] - base;
  const float length2 = glm::dot(chord, chord);
  if (!(length2 > 0)) return false;
  for (std::size_t i = from + 1; i < to; ++i) {
    const Vec3 offset = positions[nodes[i]] - base;
    const float share = glm::dot(offset, chord) / length2;
    const float radius = radii_[nodes[i]];
    const Vec3 aside = offset - share * chord;
    const float allowed = error * radius;
    const float off = glm::mix(radii_[nodes[from]], radii_[nodes[to]], share) - radius;
    if (!(share >= 0 && share <= 1) || glm::dot(aside, aside) > allowed * allowed || std::abs(off) > allowed) {
      return false;
    }
  }
  return true;
}

void TubePlan::choose_sides(AxisIndex axis) {
  const AxisPath points = path(axis);
  if (points.size() == 0) return;
  const float thickest = thickest_[wear(axis)];
  const double share = thickest > 0 ? math::pow(std::min(1.0F, points.radius(0) / thickest), 1.0 / 3) : 0;
  const double max = std::max(3, surface(axis).sides);
  plans_[axis].sides = static_cast<std::uint32_t>(std::max(3.0, std::floor(max * share + 0.5)));
}

void TubePlan::count_rings(AxisIndex axis) {
  const AxisPath points = path(axis);
  if (points.size() < 2 || surface(axis).style != SurfaceOptions::Style::tubes || wears_[wear(axis)].left_out) return;
  AxisPlan& plan = plans_[axis];
  plan_start(points, plan, axis);
  // The start, the bends between start and tip, and the tip.
  plan.rings = plan.collar ? AxisPlan::kCollarRings + 1 : 2 + plan.flare_rings;
  Vec3 before = plan.collar ? plan.collar->direction : points.direction(0, kUp);
  for (std::size_t i = plan.collar ? plan.collar->next_point : 1; i + 1 < points.size(); ++i) {
    const Vec3 after = points.direction(i, before);
    plan.rings += fan_size(glm::dot(before, after));
    before = after;
  }
  plan.cap = cap(axis);
  if (plan.cap == SurfaceOptions::Cap::round) plan.rings += AxisPlan::kDomeRings;
}

SurfaceOptions::Cap TubePlan::cap(AxisIndex axis) const {
  // A cone stays hidden in the successor's tube.
  if (plans_[axis].successor != kNoAxis) return SurfaceOptions::Cap::pointed;
  const auto cut = skeleton_->extra.find(kCutColumn);
  const bool is_cut = cut != skeleton_->extra.end() && cut->second[axes_.of(axis).back()] != 0;
  return is_cut ? SurfaceOptions::Cap::flat : surface(axis).cap;
}

void TubePlan::plan_start(const AxisPath& points, AxisPlan& plan, AxisIndex axis) const {
  plan.start_radius = points.radius(0);
  if (!points.is_lateral()) {
    // If nodes are far apart, the flare needs additional rings.
    const float first = glm::distance(points.position(0), points.position(1));
    const bool flares = surface(axis).flare > 0 && first > 0.5F * kFlareHeight * plan.start_radius;
    if (flares) plan.flare_rings = AxisPlan::kFlareRings;
    return;
  }
  if (plan.succeeds) return;
  // An axis that continues the parent's end, and is no thicker, needs no room inside the parent.
  if (goes_on_[axis] != 0 && plan.start_radius <= radii_[points.parent]) return;
  const float hollow = roundness(skeleton_->axis[points.parent]);
  const bool is_round = plan.sides >= kRoundCollar;
  if (surface(axis).collar > 0 && is_round && kMinCollar * plan.start_radius > hollow) {
    plan.collar = plan_collar(points, bark_below(points), surface(axis).collar);
    plan.sink = 2 * hollow;
  }
  if (!plan.collar) plan.start_radius = std::min(plan.start_radius, room_inside(points.parent));
}

/// Returns the radius of the largest disc around a node that its tube hides in any orientation.
float TubePlan::room_inside(NodeIndex node) const {
  const std::span<const NodeIndex> nodes = axes_.of(skeleton_->axis[node]);
  const float radius = std::max(radii_[node], kThinnestTube);
  // The flat sides of the tube are nearer than its corners, its line may deviate from the node, and where it tapers the
  // nearest point lies ahead.
  const AxisIndex axis = skeleton_->axis[node];
  const double flat = std::max(0.3, math::cos(kPi / plans_[axis].sides) - 2.0 * surface(axis).error);
  const auto next = std::upper_bound(nodes.begin(), nodes.end(), node);
  double taper = 0;
  if (next != nodes.end()) {
    const float length = glm::distance(skeleton_->position[*next], skeleton_->position[node]);
    taper = std::max(0.0F, radius - radii_[*next]) / std::max(length, kThinnestTube);
  }
  return static_cast<float>(kHidden * radius * flat / std::sqrt(1 + taper * taper));
}

}  // namespace meristem
