// SPDX-License-Identifier: Apache-2.0
// Simplifies a mesh on one thread. Large meshes are first collapsed in parts by index, up to a similar cost, and then
// as a whole in the order of cost.
#include "meristem/shape/mesh/simplify.h"

#include <cmath>

#include "meristem/base/require.h"
#include "meristem/shape/mesh/edge_collapse.h"
#include "meristem/shape/mesh/filled.h"
#include "meristem/shape/mesh/shading.h"

namespace meristem {

namespace {

void check_input(const Mesh& mesh, const Progress& progress) {
  require(mesh.uvs.empty() && mesh.tangents.empty(), "a mesh with uvs or tangents cannot be simplified");
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    if (v % kItemsBetweenChecks == 0) progress.check();
    const Vec3 at = mesh.positions[v];
    require(std::isfinite(at.x) && std::isfinite(at.y) && std::isfinite(at.z), "a position is not finite");
  }
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    if (t % kItemsBetweenChecks == 0) progress.check();
    for (const std::uint32_t v : mesh.triangles[t]) require(v < mesh.vertex_count(), "a triangle has no such vertex");
  }
}

Mesh shaded_like(const Mesh& original, Mesh mesh) {
  return original.normals.empty() ? std::move(mesh) : smooth_shaded(mesh);
}

}  // namespace

Mesh simplify(const Mesh& mesh, const SimplifyTarget& target, Progress& progress) {
  require(target.error >= 0, "an error must not be negative");
  check_input(mesh, progress);
  if (mesh.triangle_count() <= target.triangles) return mesh;
  EdgeCollapse edges(mesh, target.error, progress);
  edges.run(target.triangles, progress);
  return shaded_like(mesh, edges.mesh(progress));
}

std::vector<Mesh> levels_of_detail(const Mesh& mesh, std::span<const std::size_t> triangles, Progress& progress) {
  check_input(mesh, progress);
  for (std::size_t k = 1; k < triangles.size(); ++k) {
    require(triangles[k] <= triangles[k - 1], "the counts of levels of detail must not rise");
  }
  std::vector<Mesh> levels;
  levels.reserve(triangles.size());
  while (levels.size() < triangles.size() && triangles[levels.size()] >= mesh.triangle_count()) levels.push_back(mesh);
  if (levels.size() == triangles.size()) return levels;
  EdgeCollapse edges(mesh, std::numeric_limits<float>::infinity(), progress);
  while (levels.size() < triangles.size()) {
    edges.run(triangles[levels.size()], progress);
    levels.push_back(shaded_like(mesh, edges.mesh(progress)));
  }
  return levels;
}

}  // namespace meristem
