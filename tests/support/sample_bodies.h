// SPDX-License-Identifier: Apache-2.0
// Closed bodies for scenes of tests.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "meristem/scene/obstacle/closed_mesh.h"

namespace meristem {

/// Returns a sphere around the origin: an octahedron whose triangles are split into four `splits` times.
inline TriangleMesh sphere_mesh(int splits, double radius = 1) {
  TriangleMesh mesh;
  mesh.positions = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  mesh.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  for (int k = 0; k < splits; ++k) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
      const auto [found, is_new] = middles.try_emplace(std::minmax(a, b), mesh.positions.size());
      if (is_new) mesh.positions.push_back(glm::normalize(mesh.positions[a] + mesh.positions[b]));
      return found->second;
    };
    std::vector<std::array<std::uint32_t, 3>> split;
    for (const auto& [a, b, c] : mesh.triangles) {
      const std::uint32_t ab = middle(a, b);
      const std::uint32_t bc = middle(b, c);
      const std::uint32_t ca = middle(c, a);
      split.insert(split.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    mesh.triangles = std::move(split);
  }
  for (DVec3& position : mesh.positions) position *= radius;
  return mesh;
}

/// Returns an upright prism over a polygon. `outline` has the pairs (x, -z), counter-clockwise seen from above;
/// `filling` has the triangles of the polygon.
inline TriangleMesh prism_mesh(const std::vector<std::array<double, 2>>& outline,
                               const std::vector<std::array<std::uint32_t, 3>>& filling, double low, double high) {
  TriangleMesh mesh;
  const auto count = static_cast<std::uint32_t>(outline.size());
  for (const double height : {low, high}) {
    for (const auto& [x, north] : outline) mesh.positions.emplace_back(x, height, -north);
  }
  for (const auto& [a, b, c] : filling) {
    mesh.triangles.push_back({a + count, b + count, c + count});
    mesh.triangles.push_back({a, c, b});
  }
  for (std::uint32_t k = 0; k < count; ++k) {
    const std::uint32_t next = (k + 1) % count;
    mesh.triangles.push_back({k, next, next + count});
    mesh.triangles.push_back({k, next + count, k + count});
  }
  return mesh;
}

inline TriangleMesh moved(TriangleMesh mesh, DVec3 by) {
  for (DVec3& position : mesh.positions) position += by;
  return mesh;
}

inline void turn_over(TriangleMesh& mesh) {
  for (auto& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
}

/// Returns both bodies in one mesh.
inline TriangleMesh joined(TriangleMesh a, const TriangleMesh& b) {
  const auto offset = static_cast<std::uint32_t>(a.positions.size());
  a.positions.insert(a.positions.end(), b.positions.begin(), b.positions.end());
  for (const auto& [p, q, r] : b.triangles) a.triangles.push_back({p + offset, q + offset, r + offset});
  return a;
}

}  // namespace meristem
