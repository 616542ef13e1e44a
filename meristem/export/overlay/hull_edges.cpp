// SPDX-License-Identifier: Apache-2.0
// Finds the edges of a convex hull. The sides of all triangles are sorted by their ends, so that both sides of an edge
// are neighbours. An edge is kept if the planes of its two triangles differ.
#include "meristem/export/overlay/hull_edges.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>

#include "meristem/measure/convex_hull.h"
#include "meristem/measure/tree_form.h"
#include "meristem/plant/split_trees.h"

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

namespace {

/// Returns the hull of the stems of one individual, above the lowest node of all stems but the first.
Mesh hull_of_stems(const std::vector<const Stem*>& stems, const Progress& progress) {
  float low = std::numeric_limits<float>::infinity();
  for (std::size_t k = 1; k < stems.size(); ++k) {
    for (const Vec3 position : stems[k]->skeleton.position) low = std::min(low, position.y);
  }
  std::vector<Vec3> points;
  for (const Stem* const stem : stems) {
    for (const Vec3 position : stem->skeleton.position) {
      if (position.y >= low) points.push_back(position);
    }
  }
  return convex_hull(points, &progress);
}

}  // namespace

std::vector<Mesh> crown_hulls(const Plant& plant, const Progress& progress) {
  std::vector<Mesh> hulls;
  std::map<std::uint32_t, std::vector<const Stem*>> unforked;  // by individual
  std::map<std::uint32_t, bool> forks;
  for (const Stem& stem : plant.stems) {
    unforked[stem.individual()].push_back(&stem);
    for (const Skeleton& tree : split_trees(stem.skeleton)) {
      progress.check();
      Mesh hull = measure_form(tree, NodeChildren(tree), &progress).crown_hull;
      if (hull.triangles.empty()) continue;
      forks[stem.individual()] = true;
      hulls.push_back(std::move(hull));
    }
  }
  for (const auto& [individual, stems] : unforked) {
    if (stems.size() < 2 || forks[individual]) continue;
    progress.check();
    Mesh hull = hull_of_stems(stems, progress);
    if (!hull.triangles.empty()) hulls.push_back(std::move(hull));
  }
  return hulls;
}

}  // namespace meristem
