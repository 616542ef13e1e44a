// SPDX-License-Identifier: Apache-2.0
// Turns skeletons into implicit bodies: one chain of round cones per axis, blended from the thickest axis to the
// thinnest. Radii below the size that cells can represent are raised, so that no branch falls apart.
#include "meristem/shape/implicit/plant_body.h"

#include <algorithm>
#include <array>

#include "meristem/base/frame.h"
#include "meristem/plant/further_columns.h"
#include "meristem/shape/tube/tube_plan.h"

namespace meristem {

namespace {

// Minimum radius of a tube in cells so that it stays in one piece in any direction, slightly more than sqrt(3) / 2.
// Then the corner nearest to each point of the axis is inside. The corners of neighbouring points are equal or share an
// edge, and every other inside corner is connected to one of them by edges that come nearer and nearer. Among random
// tubes, some 4 in 1,000 fall apart or vanish at 0.75, 2 in 1,000 at 0.84, and none from 0.85 on
// (PlantBody.IsosurfaceHoldsThinTubes).
constexpr double kHeldRadius = 0.867;

struct AxisPoint {
  DVec3 position{0};
  double radius = 0;
};

/// Returns the points of an axis, beginning at its parent's node.
std::vector<AxisPoint> points_of(const Skeleton& skeleton, std::span<const NodeIndex> nodes, Vec3 origin) {
  std::vector<AxisPoint> points;
  if (nodes.empty()) return points;
  const auto place = [&](NodeIndex node) { return DVec3(skeleton.position[node]) - DVec3(origin); };
  const NodeIndex parent = skeleton.parent[nodes[0]];
  if (parent != kNoNode) points.push_back({place(parent), skeleton.radius[nodes[0]]});
  for (const NodeIndex node : nodes) points.push_back({place(node), skeleton.radius[node]});
  return points;
}

/// Widens a root's base. Adds points between its first nodes if these are far apart.
void flare(std::vector<AxisPoint>& points, const SurfaceOptions& surface) {
  if (!(surface.flare > 0) || points.size() < 2 || !(points[0].radius > 0)) return;
  const auto base = static_cast<float>(points[0].radius);
  std::vector<AxisPoint> flared;
  double way = 0;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const double length = glm::distance(points[i].position, points[i + 1].position);
    const int parts = flare_factor(surface, base, static_cast<float>(way)) > 1 && length > base ? 4 : 1;
    for (int k = 0; k < parts; ++k) {
      const double share = static_cast<double>(k) / parts;
      AxisPoint point{glm::mix(points[i].position, points[i + 1].position, share),
                      glm::mix(points[i].radius, points[i + 1].radius, share)};
      point.radius *= flare_factor(surface, base, static_cast<float>(way + share * length));
      flared.push_back(point);
    }
    way += length;
  }
  flared.push_back(points.back());
  flared.back().radius *= flare_factor(surface, base, static_cast<float>(way));
  points = std::move(flared);
}

/// Returns the space below a root's base. It is removed, so that the round ends of cones do not protrude there.
ImplicitBody below_base(std::span<const AxisPoint> points, double min_radius) {
  double widest = min_radius;
  for (const AxisPoint& point : points) widest = std::max(widest, point.radius);
  const auto half = static_cast<float>(2 * widest);
  for (const AxisPoint& point : points) {
    const Vec3 along(point.position - points[0].position);
    if (!(glm::length(along) > 0)) continue;
    Frame frame = frame_along(Vec3(points[0].position), along, kUp);
    frame.origin -= half * frame.heading();
    return ImplicitBody::box(frame, Vec3(half));
  }
  return {};
}

/// Returns the cones of one axis. Empty if the axis has no length or no thickness.
ImplicitBody axis_body(std::span<const AxisPoint> points, bool is_root, double min_radius) {
  ImplicitBody body;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const DVec3 from = points[i].position;
    const DVec3 to = points[i + 1].position;
    const double from_radius = std::max(points[i].radius, min_radius);
    const double to_radius = std::max(points[i + 1].radius, min_radius);
    if (!(std::max(from_radius, to_radius) > 0)) continue;
    const bool is_flat = is_root && i == 0 && glm::distance(from, to) > 0;
    body.unite(is_flat ? ImplicitBody::flat_cone(from, from_radius, to, to_radius)
                       : ImplicitBody::round_cone(from, from_radius, to, to_radius));
  }
  if (is_root && !body.is_empty()) body.subtract(below_base(points, min_radius));
  return body;
}

double first_radius(const Skeleton& skeleton, std::span<const NodeIndex> nodes) {
  return nodes.empty() ? 0 : skeleton.radius[nodes[0]];
}

bool is_root_axis(const Skeleton& skeleton, std::span<const NodeIndex> nodes) {
  return !nodes.empty() && skeleton.is_root(nodes[0]);
}

}  // namespace

ImplicitBody make_stem_body(const Skeleton& skeleton, std::span<const AxisIndex> axes, const SurfaceOptions& surface,
                            double min_radius, Vec3 origin) {
  const SkeletonAxes nodes(skeleton);
  // Thick axes first: later blends then reach less far.
  std::vector<AxisIndex> sorted(axes.begin(), axes.end());
  std::stable_sort(sorted.begin(), sorted.end(), [&](AxisIndex a, AxisIndex b) {
    return first_radius(skeleton, nodes.of(a)) > first_radius(skeleton, nodes.of(b));
  });
  ImplicitBody body;
  for (const AxisIndex axis : sorted) {
    std::vector<AxisPoint> points = points_of(skeleton, nodes.of(axis), origin);
    const bool is_root = is_root_axis(skeleton, nodes.of(axis));
    if (is_root) flare(points, surface);
    const double thick = std::max(first_radius(skeleton, nodes.of(axis)), min_radius);
    body.blend(axis_body(points, is_root, min_radius), BlendKind::poly, surface.blend * thick);
  }
  return body;
}

BodyThickening find_thickening(const Skeleton& skeleton, std::span<const AxisIndex> axes,
                               const SurfaceOptions& surface) {
  BodyThickening thickening;
  const SkeletonAxes nodes(skeleton);
  Box box;
  for (const AxisIndex axis : axes) {
    std::vector<AxisPoint> points = points_of(skeleton, nodes.of(axis), Vec3(0));
    if (is_root_axis(skeleton, nodes.of(axis))) flare(points, surface);
    for (const AxisPoint& point : points) {
      box.add(Vec3(point.position - point.radius));
      box.add(Vec3(point.position + point.radius));
    }
  }
  const Vec3 size = box.size();
  // A thickened body is wider by up to this radius at both ends, which also enlarges its cells.
  const double cell = std::max({size.x, size.y, size.z}) / (surface.resolution - 2 * kHeldRadius);
  if (surface.thicken) thickening.min_radius = kHeldRadius * cell;
  const auto cone_volume = [](double length, double a, double b) { return kPi / 3 * length * (a * a + a * b + b * b); };
  for (const AxisIndex axis : axes) {
    const std::vector<AxisPoint> points = points_of(skeleton, nodes.of(axis), Vec3(0));
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      const double length = glm::distance(points[i].position, points[i + 1].position);
      const std::array<double, 2> radii{points[i].radius, points[i + 1].radius};
      const double min = thickening.min_radius;
      const double volume = cone_volume(length, radii[0], radii[1]);
      thickening.length += length;
      if (std::min(radii[0], radii[1]) < min) thickening.thickened += length;
      thickening.volume += volume;
      thickening.added += cone_volume(length, std::max(radii[0], min), std::max(radii[1], min)) - volume;
    }
  }
  return thickening;
}

std::vector<NodeIndex> branch_ends(const Skeleton& skeleton, std::span<const AxisIndex> axes) {
  const SkeletonAxes nodes(skeleton);
  const auto column = skeleton.extra.find(kEndColumn);
  std::vector<NodeIndex> ends;
  std::vector<NodeIndex> tips;
  for (const AxisIndex axis : axes) {
    const std::span<const NodeIndex> of_axis = nodes.of(axis);
    if (of_axis.empty()) continue;
    tips.push_back(of_axis.back());
    if (column == skeleton.extra.end()) continue;
    for (const NodeIndex node : of_axis) {
      if (column->second[node] > 0) ends.push_back(node);
    }
  }
  return ends.empty() ? tips : ends;
}

ImplicitBody make_crown_body(const Skeleton& skeleton, std::span<const AxisIndex> axes, const CrownBody& crown,
                             Vec3 origin) {
  ImplicitBody body;
  for (const NodeIndex node : branch_ends(skeleton, axes)) {
    const DVec3 centre = DVec3(skeleton.position[node]) - DVec3(origin) + DVec3(0, crown.offset, 0);
    body.blend(ImplicitBody::sphere(centre, 0.5 * crown.diameter), crown.blend, crown.fuse);
  }
  return body;
}

}  // namespace meristem
