// SPDX-License-Identifier: Apache-2.0
// Compares frames, meshes and normals with tolerances, to decide how a part moves between two keys.
#include "meristem/shape/moving/moving_likeness.h"

#include <cmath>

namespace meristem {

namespace {

constexpr float kTurned = 0.94F;          // cosine of 20 degrees: from this turn on, normals move with their faces
constexpr double kTurnedShare = 0.01;     // share of vertices
constexpr float kShear = 4e-6F;           // tolerance of a glTF node
constexpr float kPlaceOnPicture = 0.02F;  // share of a picture's width

}  // namespace

bool are_one_frame(const Frame& a, const Frame& b) { return a.axes == b.axes && a.origin == b.origin; }

bool is_rigid_frame(const Frame& frame) {
  const Mat3& axes = frame.axes;
  const Vec3 length(glm::length(axes[0]), glm::length(axes[1]), glm::length(axes[2]));
  if (!(length.x > 0 && length.y > 0 && length.z > 0) || glm::determinant(axes) < 0) return false;
  return std::abs(glm::dot(axes[0], axes[1])) <= kShear * length.x * length.y &&
         std::abs(glm::dot(axes[1], axes[2])) <= kShear * length.y * length.z &&
         std::abs(glm::dot(axes[2], axes[0])) <= kShear * length.z * length.x;
}

bool are_of_one_form(const Mesh& a, const Mesh& b) {
  if (&a == &b) return true;
  if (a.vertex_count() != b.vertex_count() || a.normals.size() != b.normals.size()) return false;
  if (a.triangles == b.triangles) return true;
  if (a.uvs.empty() || a.uvs.size() != b.uvs.size() || a.triangle_count() != b.triangle_count()) return false;
  for (std::size_t k = 0; k < a.uvs.size(); ++k) {
    if (glm::distance(a.uvs[k], b.uvs[k]) > kPlaceOnPicture) return false;
  }
  return true;
}

bool are_turned(const Frame& a, const Frame& b) {
  const Vec3 some = glm::normalize(Vec3(1, 2, 3));
  const Vec3 other = glm::normalize(Vec3(2, -3, 1));
  return glm::dot(a.normal(some), b.normal(some)) < kTurned || glm::dot(a.normal(other), b.normal(other)) < kTurned;
}

bool are_turned(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  std::size_t turned = 0;
  for (std::size_t k = 0; k < a.size(); ++k) turned += glm::dot(a[k], b[k]) < kTurned ? 1 : 0;
  return static_cast<double>(turned) > kTurnedShare * static_cast<double>(a.size());
}

}  // namespace meristem
