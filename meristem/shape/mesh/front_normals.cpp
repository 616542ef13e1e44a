// SPDX-License-Identifier: Apache-2.0
// Corrects normals that do not come from the triangles, but for example from a body's function. On coarse triangles
// they can be off by more than a right angle. A normal behind a triangle is replaced by the mean of the faces around
// it. It is then turned toward the face from which it leans away most, until it leans away from none.
//
// Based on: F. Rosenblatt: The perceptron (Psychological Review 65, 1958).
#include "meristem/shape/mesh/front_normals.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "meristem/base/vec.h"

namespace meristem {

namespace {

constexpr double kFront = 0.02;  // minimum cosine between a normal and its triangles; below it the normal is replaced
constexpr int kTurns = 200;

DVec3 face_normal(const Mesh& mesh, const std::array<std::uint32_t, 3>& triangle) {
  const DVec3 at(mesh.positions[triangle[0]]);
  const DVec3 front = glm::cross(DVec3(mesh.positions[triangle[1]]) - at, DVec3(mesh.positions[triangle[2]]) - at);
  const double length = glm::length(front);
  return length > 0 ? front / length : DVec3(0);
}

constexpr std::size_t kLooksBetweenChecks = 65536;

struct Corner {
  std::uint32_t vertex;
  DVec3 face;
};

/// Returns a direction in front of these faces, or the best one that was found.
DVec3 in_front_of(std::span<const Corner> corners, DVec3 otherwise) {
  DVec3 sum{0};
  for (const Corner& corner : corners) sum += corner.face;
  DVec3 best = otherwise;
  double best_cosine = -1;
  for (int turn = 0; turn < kTurns; ++turn) {
    const double length = glm::length(sum);
    double min = 2;
    DVec3 behind{0};
    for (const Corner& corner : corners) {
      const double cosine = length > 0 ? glm::dot(corner.face, sum) / length : -1;
      if (cosine >= min) continue;
      min = cosine;
      behind = corner.face;
    }
    if (length > 0 && min > best_cosine) {
      best_cosine = min;
      best = sum / length;
    }
    if (best_cosine > kFront) break;
    sum += behind;
  }
  return best;
}

}  // namespace

void turn_to_front(Mesh& mesh, Progress& progress) {
  std::vector<std::uint8_t> is_behind(mesh.vertex_count(), 0);
  std::size_t looked_at = 0;
  for (const std::array<std::uint32_t, 3>& triangle : mesh.triangles) {
    if (looked_at++ % kLooksBetweenChecks == 0) progress.check();
    const DVec3 face = face_normal(mesh, triangle);
    for (const std::uint32_t vertex : triangle) {
      if (!(glm::dot(face, DVec3(mesh.normals[vertex])) > kFront)) is_behind[vertex] = 1;
    }
  }
  std::vector<Corner> corners;
  for (const std::array<std::uint32_t, 3>& triangle : mesh.triangles) {
    if (looked_at++ % kLooksBetweenChecks == 0) progress.check();
    for (const std::uint32_t vertex : triangle) {
      if (is_behind[vertex] != 0) corners.push_back({vertex, face_normal(mesh, triangle)});
    }
  }
  std::stable_sort(corners.begin(), corners.end(),
                   [](const Corner& a, const Corner& b) { return a.vertex < b.vertex; });
  for (std::size_t first = 0; first < corners.size();) {
    const std::uint32_t vertex = corners[first].vertex;
    std::size_t end = first;
    while (end < corners.size() && corners[end].vertex == vertex) ++end;
    const DVec3 otherwise(mesh.normals[vertex]);
    mesh.normals[vertex] = Vec3(in_front_of(std::span(corners).subspan(first, end - first), otherwise));
    first = end;
  }
}

}  // namespace meristem
