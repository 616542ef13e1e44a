// SPDX-License-Identifier: Apache-2.0
// Computes flat normals (one per face) or smooth normals (weighted means per vertex).
#include "meristem/shape/mesh/shading.h"

#include "meristem/base/frame.h"

namespace meristem {

namespace {

constexpr std::size_t kTrianglesBetweenChecks = 65536;

}  // namespace

Mesh flat_shaded(const Mesh& mesh, Progress& progress) {
  Mesh flat;
  flat.positions.reserve(3 * mesh.triangle_count());
  flat.normals.reserve(3 * mesh.triangle_count());
  flat.triangles.reserve(mesh.triangle_count());
  if (!mesh.uvs.empty()) flat.uvs.reserve(3 * mesh.triangle_count());
  for (const std::array<std::uint32_t, 3>& triangle : mesh.triangles) {
    if (flat.triangles.size() % kTrianglesBetweenChecks == 0) progress.check();
    const auto first = static_cast<std::uint32_t>(flat.vertex_count());
    const Vec3 a = mesh.positions[triangle[0]];
    const Vec3 front = glm::cross(mesh.positions[triangle[1]] - a, mesh.positions[triangle[2]] - a);
    for (const std::uint32_t vertex : triangle) {
      flat.positions.push_back(mesh.positions[vertex]);
      flat.normals.push_back(normalized_or(front, kUp));
      if (!mesh.uvs.empty()) flat.uvs.push_back(mesh.uvs[vertex]);
    }
    flat.triangles.push_back({first, first + 1, first + 2});
  }
  return flat;
}

// The weight of a corner is the sine of its angle divided by the lengths of its sides. Based on: N. Max: Weights for
// Computing Vertex Normals from Facet Normals (1999).
Mesh smooth_shaded(const Mesh& mesh) {
  std::vector<DVec3> sums(mesh.vertex_count(), DVec3(0));
  for (const std::array<std::uint32_t, 3>& triangle : mesh.triangles) {
    // Each side from its corner to the next, for both of its ends.
    std::array<DVec3, 3> side;
    std::array<double, 3> square;
    for (std::size_t k = 0; k < 3; ++k) {
      side[k] = DVec3(mesh.positions[triangle[(k + 1) % 3]]) - DVec3(mesh.positions[triangle[k]]);
      square[k] = squared_length(side[k]);
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t before = (k + 2) % 3;
      const double squares = square[k] * square[before];
      if (squares > 0) sums[triangle[k]] += glm::cross(side[k], -side[before]) / squares;
    }
  }
  Mesh smooth = mesh;
  smooth.tangents.clear();
  smooth.normals.resize(mesh.vertex_count());
  for (std::size_t v = 0; v < sums.size(); ++v) {
    const double length = glm::length(sums[v]);
    smooth.normals[v] = length > 0 ? Vec3(sums[v] / length) : kUp;
  }
  return smooth;
}

}  // namespace meristem
