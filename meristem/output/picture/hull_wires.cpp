// SPDX-License-Identifier: Apache-2.0
#include "meristem/output/picture/hull_wires.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <utility>

#include "meristem/measure/tree_form.h"
#include "meristem/plant/split_trees.h"
#include "meristem/shape/solid/primitives.h"

namespace meristem {

namespace {

constexpr float kThickness = 1.0F / 400;  // of a wire, against the hull's longest side
constexpr double kFlat = 0.99999;         // cosine between normals of triangles that count as one plane: 0.26 degrees
constexpr Vec3 kColour{0.75F, 0.26F, 0.1F};  // sRGB

/// One side of a triangle, its ends in rising order.
struct Edge {
  std::array<std::uint32_t, 2> ends;
  DVec3 normal;  // of the triangle
};

/// Both triangles' sides of an edge stand next to each other.
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

void add_wires(const Skeleton& tree, const Progress& progress, std::vector<Frame>& wires) {
  const std::vector<Frame> more = hull_wires(measure_form(tree, Children(tree), &progress).crown_hull);
  wires.insert(wires.end(), more.begin(), more.end());
}

}  // namespace

std::vector<Frame> hull_wires(const Mesh& hull) {
  Box box;
  for (const Vec3 position : hull.positions) box.add(position);
  if (box.is_empty()) return {};
  const Vec3 size = box.size();
  const float radius = 0.5F * kThickness * std::max({size.x, size.y, size.z});
  const std::vector<Edge> edges = sorted_edges(hull);
  std::vector<Frame> wires;
  for (std::size_t k = 0; k + 1 < edges.size(); k += 2) {
    if (glm::dot(edges[k].normal, edges[k + 1].normal) > kFlat) continue;
    const Vec3 from = hull.positions[edges[k].ends[0]];
    const Vec3 way = hull.positions[edges[k].ends[1]] - from;
    const float length = glm::length(way);
    Frame wire = frame_along(from, way, kUp);
    wire.axes[0] *= radius;
    wire.axes[1] *= length;
    wire.axes[2] *= radius;
    wires.push_back(wire);
  }
  return wires;
}

MeshScene with_crown_hulls(const MeshScene& meshes, const Plant& plant, const Progress& progress) {
  std::vector<Frame> wires;
  for (const Stem& stem : plant.stems) {
    for (const Skeleton& tree : split_trees(stem.skeleton)) add_wires(tree, progress, wires);
  }
  MeshScene scene = meshes;
  if (wires.empty()) return scene;
  const auto material = static_cast<std::uint32_t>(scene.materials.size());
  scene.materials.push_back({.name = "hull", .colour = kColour, .roughness = 1});
  scene.meshes.push_back({.component = "hull",
                          .mesh = std::make_shared<const Mesh>(make_cylinder(1, 1, 6)),
                          .material = material,
                          .frames = std::move(wires),
                          .tints = {}});
  return scene;
}

}  // namespace meristem
