// SPDX-License-Identifier: Apache-2.0
// Builds the crown body of a skeleton and places sites on a jittered grid within it. A lower bound of the number of
// sites, from one ball of the body, refuses much too dense crowns before any work. The key of a site contains its grid
// cell, so that a site keeps its random numbers when the crown changes elsewhere.
//
// Based on: F. Heuer: Algorithmische Erzeugung von 3D-Low-Poly-Bäumen (2022), 5.5.
#include "meristem/graph/crown_placement.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "meristem/base/math.h"
#include "meristem/graph/table/table.h"
#include "meristem/shape/implicit/body_points.h"
#include "meristem/shape/implicit/plant_body.h"

namespace meristem {

namespace {

/// A rotation with all directions alike, by three numbers from 0 to 1 (K. Shoemake: Uniform random rotations, 1992).
Mat3 any_rotation(RandomKey key) {
  const double roll = 2 * kPi * key.uniform(0);
  const double turn = 2 * kPi * key.uniform(1);
  const double share = key.uniform(2);
  const double a = std::sqrt(1 - share);
  const double b = std::sqrt(share);
  const double x = a * math::sin(roll);
  const double y = a * math::cos(roll);
  const double z = b * math::sin(turn);
  const double w = b * math::cos(turn);
  const glm::dmat3 rotation(1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w),  //
                            2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w),  //
                            2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y));
  return Mat3(rotation);
}

/// A child's directions at a site.
Mat3 axes_at(const BodyPoint& place, const CrownPlacement& placement, RandomKey key) {
  if (placement.orient == CrownPlacement::Orient::random) return any_rotation(key.child("turn"));
  Mat3 axes = frame_along({}, place.outward, kUp).axes;
  if (placement.turn > 0) {
    const RandomKey turn = key.child("turn");
    const Vec3 aside = rotation(axes[1], 2 * kPi * turn.uniform(0)) * axes[0];
    axes = rotation(aside, placement.turn * turn.uniform(1)) * axes;
  }
  return axes;
}

}  // namespace

const ParameterTable& crown_placement_table() {
  static const ParameterTable table =
      Table<CrownPlacement>("a crown link", "Positions of children in a crown body.")
          .number("density", &CrownPlacement::density,
                  {.unit = Unit::per_cubic_metre, .min = 0, .max = 1e9, .above_min = true},
                  "Density of the sites in the crown body; raised, more children.")
          .choice("orient", &CrownPlacement::orient, {"outward", "random"},
                  "Heading of the children: 'outward', away from the crown body's surface, or 'random'.")
          .number("turn", &CrownPlacement::turn, {.unit = Unit::degree, .min = 0, .max = 180, .usual = {0, 90}},
                  "Largest random turn of outward children to any side.")
          .number("droop", &CrownPlacement::droop, {.min = -1, .max = 1},
                  "Share of the turn of the children's heading straight down: 1 lets them hang, 0 leaves them as they "
                  "are, -1 turns them straight up.")
          .number("depth", &CrownPlacement::depth, {.unit = Unit::metre, .min = 0, .max = 1e6, .above_min = true},
                  "Depth below the crown body's surface within which children stand; by default, they fill the body.")
          .only_where({{"orient", {"outward"}}}, {"turn"})
          .elsewhere({"from", "to", "kind"});
  return table;
}

std::vector<Site> place_in_crown(const Skeleton& skeleton, const SurfaceOptions& surface,
                                 const CrownPlacement& placement, const PlacementContext& context, Progress& progress) {
  std::vector<AxisIndex> axes(SkeletonAxes(skeleton).count());
  std::iota(axes.begin(), axes.end(), 0);
  const ImplicitBody body = make_crown_body(skeleton, axes, *surface.crown);
  if (body.is_empty()) return {};
  BodyGrid grid{.origin = DVec3(context.parent.frame.origin),
                .spacing = 1 / math::pow(placement.density, 1.0 / 3),
                .max = context.limits->instances};
  if (placement.depth) grid.depth = *placement.depth;
  // One ball of the body alone shows whether there are far too many.
  const double radius = 0.5 * surface.crown->diameter;
  const double in_ball = placement.depth ? 0 : placement.density * 4 * kPi / 3 * radius * radius * radius;
  const DVec3 size = body.high() - body.low() + 2 * body.reach();
  const double cells = std::max({size.x, size.y, size.z}) / grid.spacing;
  if (in_ball > 2 * static_cast<double>(context.limits->instances) || cells > kMaxBodyCells) {
    throw_limit(in_ball > cells ? "children" : "cells along the crown", std::max(in_ball, cells),
                context.limits->instances, "instances", context.path + ".density");
  }
  const std::vector<BodyPoint> places = places_in(body, grid, context.parent.key, progress);
  if (places.size() > context.limits->instances) {
    throw_limit("children or more", static_cast<double>(places.size()), context.limits->instances, "instances",
                context.path + ".density");
  }
  const double base = body.low().y;
  const double height = body.high().y - base;
  std::vector<Site> sites(places.size(), context.parent);
  for (std::size_t k = 0; k < places.size(); ++k) {
    Site& site = sites[k];
    site.i = static_cast<std::uint32_t>(k);
    site.n = static_cast<std::uint32_t>(places.size());
    for (const int along : {places[k].cell.x, places[k].cell.y, places[k].cell.z}) {
      site.key = site.key.child(static_cast<std::uint32_t>(along));
    }
    site.frame.origin = places[k].position;
    site.frame.axes = drooped(axes_at(places[k], placement, site.key), placement.droop,
                              context.directions.gravity(site.frame.origin));
    site.u = static_cast<float>(std::clamp((places[k].position.y - base) / height, 0.0, 1.0));
    site.length = static_cast<float>(height);
    site.radius = 0;
    site.stem = kOnNoStem;
  }
  return sites;
}

}  // namespace meristem
