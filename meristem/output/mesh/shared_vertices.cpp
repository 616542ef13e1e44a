// SPDX-License-Identifier: Apache-2.0
#include "meristem/output/mesh/shared_vertices.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace meristem {

namespace {

constexpr std::uint32_t kUnnumbered = 0xffffffff;

/// Returns the numbers of a vertex that are compared: its position and, if `by_uvs`, its texture coordinates.
std::array<float, 5> key_of(const Mesh& mesh, std::uint32_t vertex, bool by_uvs) {
  const Vec3 at = mesh.positions[vertex];
  const Vec2 uv = by_uvs ? mesh.uvs[vertex] : Vec2(0);
  return {at.x, at.y, at.z, uv.x, uv.y};
}

}  // namespace

SharedVertices share_vertices(const Mesh& mesh, bool by_uvs) {
  by_uvs = by_uvs && !mesh.uvs.empty();
  const auto count = static_cast<std::uint32_t>(mesh.vertex_count());
  std::vector<std::uint32_t> sorted(count);
  std::iota(sorted.begin(), sorted.end(), 0U);
  std::sort(sorted.begin(), sorted.end(), [&](std::uint32_t a, std::uint32_t b) {
    const auto key_a = key_of(mesh, a, by_uvs);
    const auto key_b = key_of(mesh, b, by_uvs);
    return key_a != key_b ? key_a < key_b : a < b;
  });
  // The first vertex of each group, for all vertices of the group.
  std::vector<std::uint32_t> first_equal(count);
  for (std::uint32_t k = 0; k < count; ++k) {
    const bool is_equal = k > 0 && key_of(mesh, sorted[k], by_uvs) == key_of(mesh, sorted[k - 1], by_uvs);
    first_equal[sorted[k]] = is_equal ? first_equal[sorted[k - 1]] : sorted[k];
  }
  SharedVertices shared;
  shared.number.assign(count, kUnnumbered);
  for (std::uint32_t v = 0; v < count; ++v) {
    if (first_equal[v] == v) {
      shared.number[v] = static_cast<std::uint32_t>(shared.first.size());
      shared.first.push_back(v);
    } else {
      shared.number[v] = shared.number[first_equal[v]];
    }
  }
  return shared;
}

bool is_flat_shaded(const Mesh& mesh) {
  if (mesh.triangle_count() < 2 || mesh.normals.size() != 3 * mesh.triangle_count()) return false;
  for (std::uint32_t t = 0; t < mesh.triangle_count(); ++t) {
    const std::uint32_t v = 3 * t;
    if (mesh.triangles[t] != std::array{v, v + 1, v + 2}) return false;
    if (mesh.normals[v] != mesh.normals[v + 1] || mesh.normals[v] != mesh.normals[v + 2]) return false;
  }
  return true;
}

}  // namespace meristem
