// SPDX-License-Identifier: Apache-2.0
// The rows of obstacles, the check of their meshes, and the bodies for the scene. A mesh from a file must be a closed
// body unless the document accepts a broken one; the result of this slow check is kept with the mesh.
#include "meristem/document/obstacle_table.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "meristem/base/number_limit.h"
#include "meristem/base/reading_stop.h"
#include "meristem/graph/table/table.h"
#include "meristem/scene/file/read_mesh.h"

namespace meristem {

namespace {

constexpr NumberRange kCoordinate{.unit = Unit::metre, .min = -1e5, .max = 1e5, .usual = {-10, 10}};
constexpr double kBytesATriangle = 300;  // memory per triangle: the mesh, the test for the inside, and the search tree

/// Returns the mesh of an obstacle at its place in the scene.
TriangleMesh placed_mesh(const ObstacleParameters& form) {
  TriangleMesh mesh = form.mesh ? form.mesh->mesh
                                : box_mesh(glm::min(DVec3(form.box->low), DVec3(form.box->high)),
                                           glm::max(DVec3(form.box->low), DVec3(form.box->high)));
  const DFrame frame = form.pose.frame();
  StopCounter stop;
  for (DVec3& position : mesh.positions) {
    stop.step();
    position = frame.point(position);
  }
  return mesh;
}

ObstacleMesh read_obstacle_mesh(const std::string& path, const SizeLimits& limits) {
  ObstacleMesh read{.mesh = read_mesh(path, limits), .errors = {}, .body_error = {}};
  read.errors = closedness_errors(read.mesh);
  if (read.errors.empty()) read.body_error = body_error(read.mesh);
  return read;
}

void check_box(const Box& box, const DocumentPath& path, ParameterReader& reader) {
  constexpr const char* kAxes = "xyz";
  for (int k = 0; k < 3; ++k) {
    if (box.low[k] != box.high[k]) continue;
    return reader.add_error(path,
                            fmt::format("the box is flat: both of its corners have {} at {:.7g}", kAxes[k], box.low[k]),
                            "two corners that differ in x, y and z");
  }
}

void check_body(const ObstacleParameters& form, const DocumentPath& path, ParameterReader& reader) {
  if (form.mesh->is_sound()) return;
  const bool is_closed = form.mesh->errors.empty();
  const std::string what =
      is_closed ? fmt::format("'{}' {}", form.mesh.path, form.mesh->body_error)
                : fmt::format("'{}' is not closed: {}", form.mesh.path, fmt::join(form.mesh->errors, "; "));
  if (!form.broken) {
    return reader.add_error(path, what,
                            fmt::format("a closed mesh{}, or \"broken\": true to use it anyway",
                                        is_closed ? " that faces outward everywhere" : ""));
  }
  if (is_closed) return reader.warn(path, what + "; it is used as it is");
  reader.warn(path, fmt::format("'{}' is not closed and is used as it is: {}", form.mesh.path,
                                fmt::join(form.mesh->errors, "; ")));
}

void check_obstacle(const ObstacleParameters& form, const DocumentPath& path, ParameterReader& reader) {
  if (form.box) check_box(*form.box, DocumentPath(path, "box"), reader);
  if (form.mesh) check_body(form, DocumentPath(path, "mesh"), reader);
  double farthest = 0;
  for (const DVec3 position : placed_mesh(form).positions) {
    const DVec3 away = glm::abs(position);
    farthest = std::max({farthest, away.x, away.y, away.z});
  }
  if (!(farthest <= kMaxCoordinate)) {
    reader.add_error(path, fmt::format("the obstacle reaches {:.4g} m from the origin", farthest),
                     fmt::format("coordinates within {:.0f} m; scale and translate it", kMaxCoordinate));
  }
}

}  // namespace

const ParameterTable& obstacle_table() {
  static const ParameterTable table =
      Table<ObstacleParameters>("an obstacle", "A body that plants do not enter and that shades them.")
          .box("box", &ObstacleParameters::box, kCoordinate, "Two opposite corners of a box, in any order.")
          .file("mesh", &ObstacleParameters::mesh, read_obstacle_mesh, "File with a closed mesh (OBJ, PLY or GLB).")
          .members(&ObstacleParameters::pose, import_table())
          .boolean("broken", &ObstacleParameters::broken,
                   "Whether a mesh that is not closed is used anyway; a point counts as inside if two of three views, "
                   "along x, y and z, show it inside.")
          .colour("colour", &ObstacleParameters::colour, "Colour of the obstacle in pictures; its surface is matt.")
          .boolean("hidden", &ObstacleParameters::hidden,
                   "Whether pictures leave the obstacle out; it still blocks growth and light.")
          .text("name", &ObstacleParameters::name,
                "Name of the obstacle, which the options of `meristem shade` can give.")
          .one_of({"box", "mesh"})
          .only_with("mesh", {"up", "broken"})
          .check(check_obstacle);
  return table;
}

void check_obstacles(const std::vector<ObstacleParameters>& forms, const DocumentPath& path, ParameterReader& reader) {
  double triangles = 0;
  for (const ObstacleParameters& form : forms)
    triangles += form.mesh ? static_cast<double>(form.mesh->mesh.triangles.size()) : 12;
  const SizeLimits& limits = reader.limits();
  if (triangles > static_cast<double>(limits.triangles)) {
    return reader.add_limit_error(path, "triangles of obstacles", triangles, limits.triangles, "triangles");
  }
  if (kBytesATriangle * triangles > static_cast<double>(limits.mesh_bytes)) {
    reader.add_limit_error(path, "bytes of obstacles", kBytesATriangle * triangles, limits.mesh_bytes, "mesh_bytes");
  }
}

Obstacles build_obstacles(const std::vector<ObstacleParameters>& forms) {
  std::vector<Obstacle> bodies;
  bodies.reserve(forms.size());
  for (const ObstacleParameters& form : forms) {
    bodies.push_back({.mesh = placed_mesh(form),
                      .colour = form.colour,
                      .is_broken = form.broken && !form.mesh->is_sound(),
                      .is_hidden = form.hidden,
                      .name = form.name});
  }
  return Obstacles(std::move(bodies));
}

}  // namespace meristem
