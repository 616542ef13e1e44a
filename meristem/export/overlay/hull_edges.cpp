// SPDX-License-Identifier: Apache-2.0
// Finds the edges of a convex hull. The sides of all triangles are sorted by their ends, so that both sides of an edge
// are neighbours. An edge is kept if the planes of its two triangles differ.
#include "meristem/export/overlay/hull_edges.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace meristem {

namespace {

constexpr double kFlat = 0.99999;  // cosine between normals of triangles that count as one plane: 0.26 degrees

/// One side of a triangle, with its ends in ascending order.
struct Edge {
  std::array<std::uint32_t, 2> ends;
  DVec3 normal;  // normal of the triangle
};

/// Returns the sides of all triangles, sorted so that the two sides of an edge are neighbours.
std::vector<Edge> sorted_edges(const Mesh& hull) {
  std::vector<Edge> edges;
  edges.reserve(3 * hull.triangles.size());
  for (const auto& corners : hull.triangles) {
    const DVec3 a(hull.positions[corners[0]]);
    const DVec3 across = glm::cross(DVec3(hull.positions[corners[1]]) - a, DVec3(hull.positions[corners[2]]) - a);
    const double length = glm::length(across);
    const DVec3 normal = length > 0 ? across / length : DVec3(0);
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax({corners[k], corners[(k + 1) % 3]});
      edges.push_back({{low, high}, normal});
    }
  }
  std::stable_sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) { return a.ends < b.ends; });
  return edges;
}

}  // namespace

std::vector<HullEdge> hull_edges(const Mesh& hull) {
  const std::vector<Edge> edges = sorted_edges(hull);
  std::vector<HullEdge> kept;
  for (std::size_t k = 0; k + 1 < edges.size(); k += 2) {
    if (glm::dot(edges[k].normal, edges[k + 1].normal) > kFlat) continue;
    kept.push_back({hull.positions[edges[k].ends[0]], hull.positions[edges[k].ends[1]]});
  }
  return kept;
}

}  // namespace meristem
