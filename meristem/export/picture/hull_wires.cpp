// SPDX-License-Identifier: Apache-2.0
// Draws the convex hulls of crowns as wires: one cylinder per edge of the hull.
#include "meristem/export/picture/hull_wires.h"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <utility>

#include "meristem/export/overlay/hull_edges.h"
#include "meristem/shape/solid/primitives.h"

namespace meristem {

namespace {

constexpr float kThickness = 1.0F / 400;     // thickness of a wire, as a share of the hull's longest side
constexpr Vec3 kColour{0.75F, 0.26F, 0.1F};  // sRGB

}  // namespace

std::vector<Frame> hull_wires(const Mesh& hull) {
  Box box;
  for (const Vec3 position : hull.positions) box.add(position);
  if (box.is_empty()) return {};
  const Vec3 size = box.size();
  const float radius = 0.5F * kThickness * std::max({size.x, size.y, size.z});
  std::vector<Frame> wires;
  for (const auto& [from, to] : hull_edges(hull)) {
    const Vec3 way = to - from;
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
  for (const Mesh& hull : crown_hulls(plant, progress)) {
    const std::vector<Frame> more = hull_wires(hull);
    wires.insert(wires.end(), more.begin(), more.end());
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
