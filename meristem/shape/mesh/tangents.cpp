// SPDX-License-Identifier: Apache-2.0
// Computes tangents. In a triangle, position is a linear function of the uvs, and its derivatives are the directions in
// which u and v rise. A vertex takes the mean over its triangles, weighted by area. The tangent is the part of this
// mean at right angles to the normal. Vertices are already split where uvs jump, so nothing is split here. Weights by
// angle, as in MikkTSpace, differ by less than a degree on tubes and blades and need an arc cosine for each corner.
//
// Based on: E. Lengyel: Mathematics for 3D Game Programming and Computer Graphics (2011), section 7.8.
#include "meristem/shape/mesh/tangents.h"

#include <cmath>
#include <utility>

#include "meristem/base/frame.h"
#include "meristem/base/parallel.h"

namespace meristem {

namespace {

constexpr std::size_t kVerticesPerBlock = 1 << 14;

/// Directions in which u and v rise, each as long as the triangle's area. Both are 0 if the uvs do not define them.
struct Rise {
  Vec3 u{0};
  Vec3 v{0};
};

Rise rise_in(const Mesh& mesh, const std::array<std::uint32_t, 3>& triangle) {
  const auto [a, b, c] = triangle;
  const Vec3 edge1 = mesh.positions[b] - mesh.positions[a];
  const Vec3 edge2 = mesh.positions[c] - mesh.positions[a];
  const Vec2 step1 = mesh.uvs[b] - mesh.uvs[a];
  const Vec2 step2 = mesh.uvs[c] - mesh.uvs[a];
  const float determinant = step1.x * step2.y - step2.x * step1.y;
  if (!(std::abs(determinant) > 0)) return {};
  const float weight = glm::length(glm::cross(edge1, edge2)) * (determinant < 0 ? -1.0F : 1.0F);
  return {weight * normalized_or(edge1 * step2.y - edge2 * step1.y, Vec3(0)),
          weight * normalized_or(edge2 * step1.x - edge1 * step2.x, Vec3(0))};
}

Vec4 tangent_of(Vec3 normal, const Rise& rise) {
  const Vec3 tangent = normalized_or(rise.u - normal * glm::dot(normal, rise.u), any_perpendicular(normal));
  const bool is_turned = glm::dot(glm::cross(normal, tangent), rise.v) < 0;
  return Vec4(tangent, is_turned ? -1.0F : 1.0F);
}

}  // namespace

void add_tangents(Mesh& mesh) {
  if (mesh.normals.empty() || mesh.uvs.empty()) return;
  // Add in the order of the triangles, because a parallel loop would add in a different order.
  std::vector<Rise> rises(mesh.vertex_count());
  for (const std::array<std::uint32_t, 3>& triangle : mesh.triangles) {
    const Rise rise = rise_in(mesh, triangle);
    for (const std::uint32_t vertex : triangle) {
      rises[vertex].u += rise.u;
      rises[vertex].v += rise.v;
    }
  }
  mesh.tangents.resize(mesh.vertex_count());
  parallel_for(mesh.vertex_count(), kVerticesPerBlock, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) mesh.tangents[v] = tangent_of(mesh.normals[v], rises[v]);
  });
}

std::shared_ptr<const Mesh> with_needed_tangents(std::shared_ptr<const Mesh> mesh, const Material& material) {
  if (!needs_tangents(material) || !mesh->tangents.empty()) return mesh;
  Mesh copy = *mesh;
  add_tangents(copy);
  return std::make_shared<const Mesh>(std::move(copy));
}

}  // namespace meristem
