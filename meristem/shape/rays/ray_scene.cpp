// SPDX-License-Identifier: Apache-2.0
// Computes surfaces, normals and texture mappings at the hits of rays. RayTrees finds the hits, and the attributes of
// the three vertices are interpolated here.
#include "meristem/shape/rays/ray_scene.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "meristem/shape/rays/ray_trees.h"

namespace meristem {

namespace {

/// Returns the matrix that turns local normals into outer normals of any length: the cofactors, without the sign of a
/// mirror. In floats, because it is computed at every hit.
Mat3 normal_matrix(const Mat3& axes) {
  const Mat3 cofactors(glm::cross(axes[1], axes[2]), glm::cross(axes[2], axes[0]), glm::cross(axes[0], axes[1]));
  return glm::dot(axes[0], cofactors[0]) < 0 ? -cofactors : cofactors;
}

/// Returns the weights of a triangle's three vertices.
Vec3 vertex_weights(Vec2 barycentric) { return {1 - barycentric.x - barycentric.y, barycentric.x, barycentric.y}; }

Vec2 uv_at(const Mesh& mesh, const std::array<std::uint32_t, 3>& triangle, Vec3 weights) {
  return weights.x * mesh.uvs[triangle[0]] + weights.y * mesh.uvs[triangle[1]] + weights.z * mesh.uvs[triangle[2]];
}

}  // namespace

RayScene::RayScene(const MeshScene& scene, Progress& progress, const RaySceneOptions& options)
    : scene_(scene),
      trees_(std::make_unique<const RayTrees>(scene, options.copied_triangles, options.large_from, progress)) {}

RayScene::~RayScene() = default;

std::uint64_t RayScene::bytes() const { return trees_->bytes(); }

std::optional<RayHit> RayScene::first_hit(const Ray& ray) const { return trees_->first_hit(ray); }

bool RayScene::is_blocked(const Ray& ray, float within) const { return trees_->is_blocked(ray, within); }

float RayScene::clearance(Vec3 position) {
  // Floats resolve a position 10 m away to a micrometre.
  return 2e-5F * (0.1F + std::max({std::abs(position.x), std::abs(position.y), std::abs(position.z)}));
}

SurfacePoint RayScene::surface_point(const RayHit& hit) const {
  const MeshInstances& part = scene_.meshes[hit.part];
  const Mesh& mesh = *part.mesh;
  const Frame frame = part.frame(hit.instance);
  const auto& triangle = mesh.triangles[hit.triangle];
  const Vec3 weights = vertex_weights(hit.barycentric);
  const Vec3 a = mesh.positions[triangle[0]];
  const Vec3 b = mesh.positions[triangle[1]];
  const Vec3 c = mesh.positions[triangle[2]];
  const Vec3 local = weights.x * a + weights.y * b + weights.z * c;
  const Vec3 local_face = glm::cross(b - a, c - a);
  const Mat3 to_outer_normal = normal_matrix(frame.axes);

  SurfacePoint point;
  point.position = frame.point(local);
  point.face_normal = normalized_or(to_outer_normal * local_face, kUp);
  point.normal = point.face_normal;
  point.smooth_offset = Vec3(0);
  if (mesh.normals.empty()) return point;
  Vec3 blended(0);
  Vec3 offset(0);
  for (int k = 0; k < 3; ++k) {
    const Vec3 normal = mesh.normals[triangle[k]];
    blended += weights[k] * normal;
    // Each vertex's tangent plane lifts the point, which compensates the flatness of the triangle on convex surfaces.
    const float below = std::min(0.0F, glm::dot(local - mesh.positions[triangle[k]], normal));
    offset -= weights[k] * below * normal;
  }
  point.normal = normalized_or(to_outer_normal * blended, point.face_normal);
  point.smooth_offset = frame.vector(offset);
  return point;
}

Vec3 RayScene::face_normal(const RayHit& hit) const {
  const MeshInstances& part = scene_.meshes[hit.part];
  const auto& triangle = part.mesh->triangles[hit.triangle];
  const Vec3 a = part.mesh->positions[triangle[0]];
  const Vec3 face = glm::cross(part.mesh->positions[triangle[1]] - a, part.mesh->positions[triangle[2]] - a);
  return normalized_or(normal_matrix(part.frame(hit.instance).axes) * face, kUp);
}

TextureMapping RayScene::texture_mapping(const RayHit& hit) const {
  TextureMapping position;
  const MeshInstances& part = scene_.meshes[hit.part];
  const Mesh& mesh = *part.mesh;
  if (mesh.uvs.empty()) return position;
  const Frame frame = part.frame(hit.instance);
  const auto& triangle = mesh.triangles[hit.triangle];
  const Vec3 weights = vertex_weights(hit.barycentric);
  position.uv = uv_at(mesh, triangle, weights);

  // The scale of the texture: the triangle's area in uv divided by its area in the world.
  const Vec3 to_b = frame.vector(mesh.positions[triangle[1]] - mesh.positions[triangle[0]]);
  const Vec3 to_c = frame.vector(mesh.positions[triangle[2]] - mesh.positions[triangle[0]]);
  const Vec2 uv_to_b = mesh.uvs[triangle[1]] - mesh.uvs[triangle[0]];
  const Vec2 uv_to_c = mesh.uvs[triangle[2]] - mesh.uvs[triangle[0]];
  const float area = glm::length(glm::cross(to_b, to_c));
  const float uv_area = uv_to_b.x * uv_to_c.y - uv_to_b.y * uv_to_c.x;
  if (area > 0) position.uvs_per_metre = std::sqrt(std::abs(uv_area) / area);

  // The directions in which u and v rise, from the mesh's tangents, or else from the triangle's own uvs.
  // Pictures of large scenes free the tangents, and must not depend on whether they were freed.
  if (!mesh.tangents.empty() && !mesh.normals.empty() && !trees_->is_large()) {
    Vec4 tangent(0);
    Vec3 normal(0);
    for (int k = 0; k < 3; ++k) {
      tangent += weights[k] * mesh.tangents[triangle[k]];
      normal += weights[k] * mesh.normals[triangle[k]];
    }
    const float handedness = tangent.w < 0 ? -1.0F : 1.0F;
    position.along_u = normalized_or(frame.vector(Vec3(tangent)), Vec3(0));
    position.along_v = normalized_or(frame.vector(handedness * glm::cross(normal, Vec3(tangent))), Vec3(0));
  } else if (uv_area != 0) {
    const float sign = uv_area < 0 ? -1.0F : 1.0F;
    position.along_u = normalized_or(sign * (uv_to_c.y * to_b - uv_to_b.y * to_c), Vec3(0));
    position.along_v = normalized_or(sign * (uv_to_b.x * to_c - uv_to_c.x * to_b), Vec3(0));
  }
  return position;
}

}  // namespace meristem
