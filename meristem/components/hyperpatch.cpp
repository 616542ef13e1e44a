// SPDX-License-Identifier: Apache-2.0
// Deforms descendants by a Bézier volume whose control points are given or moved by functions.
#include "meristem/components/hyperpatch.h"

#include <fmt/format.h>

#include "meristem/base/deform/bezier_volume.h"

namespace meristem {

namespace {

/// Tolerance of control points at rest for the rounding of decimals, relative to the box's size.
constexpr float kAtRest = 1e-6F;

const ParameterTable& control_point_table() {
  static const ParameterTable table =
      Table<ControlPoint>("a control point", "Position of a control point of a hyperpatch.")
          .vector("at", &ControlPoint::at, {.unit = Unit::metre, .min = -1e5, .max = 1e5, .usual = {-10, 10}},
                  "Position of the control point, in the component's frame.")
          .in_space(InSpace::position)
          .required()
          .shorthand("at");
  return table;
}

BezierVolume::Degree degree_of(const Hyperpatch& patch) { return {patch.degree[0], patch.degree[1], patch.degree[2]}; }

bool has_room(const Box& box) { return glm::all(glm::lessThan(box.low, box.high)); }

void check(const Hyperpatch& patch, const DocumentPath& path, ParameterReader& reader) {
  if (patch.box && !has_room(*patch.box)) {
    reader.add_error(DocumentPath(path, "box"), "the box is flat", "corners that differ in x, y and z");
  }
  const BezierVolume::Degree degree = degree_of(patch);
  const std::size_t wanted = BezierVolume::point_count(degree);
  if (patch.points.empty() || patch.points.size() == wanted) return;
  reader.add_error(
      DocumentPath(path, "points"),
      fmt::format("a hyperpatch of degree [{}] has {} control points, and here are {}", fmt::join(degree, ", "), wanted,
                  patch.points.size()),
      fmt::format("{} x {} x {} of them: layer by layer from the lowest y up, in each layer row by row toward "
                  "+z, in each row toward +x",
                  degree[0] + 1, degree[1] + 1, degree[2] + 1));
}

/// Returns the control points. Points that differ from rest only by the rounding of decimals are set exactly to rest.
std::vector<DVec3> control_points(const Hyperpatch& patch, const std::vector<DVec3>& rest) {
  std::vector<DVec3> points = rest;
  const Vec3 near = kAtRest * patch.box->size();
  for (std::size_t k = 0; k < rest.size(); ++k) {
    const Vec3 given = patch.points[k].at;
    if (!glm::all(glm::lessThanEqual(glm::abs(given - Vec3(rest[k])), near))) points[k] = DVec3(given);
  }
  return points;
}

/// Returns the volume of the patch, or null if its control points do not move.
std::shared_ptr<const BezierVolume> volume_of(const Hyperpatch& patch, const Site& site,
                                              const InstanceContext& instance) {
  if (patch.points.empty() && patch.functions.is_empty()) return nullptr;
  if (!has_room(*patch.box)) {
    throw InputError(Diagnostic{.message = fmt::format("the box of instance {} of {} is flat", site.i, site.n),
                                .expected = "corners that differ in x, y and z",
                                .path = "components." + instance.component() + ".box"});
  }
  const DVec3 low(patch.box->low), high(patch.box->high);
  std::vector<DVec3> points = BezierVolume::points_at_rest(low, high, degree_of(patch));
  if (!patch.points.empty()) {
    points = control_points(patch, points);
  } else {
    std::vector<DMat3> slopes(points.size());
    map_of(patch.functions, site, instance.time()).map(points, slopes);
  }
  return std::make_shared<const BezierVolume>(low, high, degree_of(patch), points);
}

void expand(const Hyperpatch& patch, const Site& site, const InstanceContext& instance, SiteSink& sites) {
  deform_below(patch.deforming, volume_of(patch, site, instance), site, instance, sites);
}

}  // namespace

ComponentType hyperpatch_component() {
  return define_component<Hyperpatch>({
      .traits = {.name = "hyperpatch",
                 .doc =
                     "A free-form deformation by a Bézier volume over a box: everything below it follows its control "
                     "points.",
                 .has_geometry = false,
                 .speaks_of_space = true},
      .parameters =
          Table<Hyperpatch>("a hyperpatch", "A free-form deformation by a Bézier volume.")
              .box("box", &Hyperpatch::box, {.unit = Unit::metre, .min = -1e5, .max = 1e5, .usual = {-10, 10}},
                   "Box over which the control points stand evenly at rest, in the component's frame; beyond it the "
                   "deformation goes on straight, with the slope that it has at the box's sides.")
              .required()
              .integers("degree", &Hyperpatch::degree, 3, {.min = 1, .max = 3},
                        "Degree along x, y and z: along each there is one control point more; raised, it can bend in "
                        "more places.")
              .list("points", &Hyperpatch::points, control_point_table,
                    "Control points [x, y, z], all of them: layer by layer from the lowest y up, in each layer row by "
                    "row toward +z, in each row toward +x; by default, where they stand at rest.")
              .members(&Hyperpatch::functions, space_functions_table())
              .never_with("points", {"dx", "dy", "dz"})
              .members(&Hyperpatch::deforming, deforming_table())
              .check(check),
      .expand = expand,
  });
}

}  // namespace meristem
