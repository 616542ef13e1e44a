// SPDX-License-Identifier: Apache-2.0
// Turns the bodies of a scene into meshes for pictures and files. Each face gets its own vertices, so that it is shaded
// flat.
#include "meristem/output/picture/obstacle_meshes.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "meristem/shape/mesh/shading.h"

namespace meristem {

namespace {

/// Vertices are floats relative to one vertex of the body, so that no digits are lost far from the origin.
MeshInstances instances_of(const Obstacle& body, std::uint32_t material) {
  const Vec3 origin(body.mesh.positions[0]);
  Mesh mesh;
  mesh.triangles = body.mesh.triangles;
  mesh.positions.reserve(body.mesh.positions.size());
  for (const DVec3 position : body.mesh.positions) mesh.positions.emplace_back(position - DVec3(origin));
  return {.component = "obstacles",
          .mesh = std::make_shared<const Mesh>(std::move(mesh)),
          .material = material,
          .frames = {Frame{.origin = origin}},
          .tints = {},
          .individuals = {kNoIndividual}};
}

Material material_of(const Obstacle& body) {
  return {.name = body.name.empty() ? "obstacle" : body.name, .colour = body.colour, .roughness = 1};
}

}  // namespace

bool has_visible(const Obstacles& obstacles) {
  return std::any_of(obstacles.bodies().begin(), obstacles.bodies().end(),
                     [](const Obstacle& body) { return !body.is_hidden; });
}

MeshScene obstacle_meshes(const Obstacles& obstacles, Progress& progress) {
  MeshScene scene;
  const std::vector<Obstacle>& bodies = obstacles.bodies();
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    if (bodies[k].is_hidden || bodies[k].mesh.triangles.empty()) continue;
    MeshInstances made = instances_of(bodies[k], static_cast<std::uint32_t>(scene.materials.size()));
    made.component = fmt::format("scene.obstacles[{}]", k);
    made.mesh = std::make_shared<const Mesh>(flat_shaded(*made.mesh, progress));
    scene.materials.push_back(material_of(bodies[k]));
    scene.meshes.push_back(std::move(made));
  }
  return scene;
}

MeshScene with_obstacles(MeshScene plants, const Obstacles& obstacles) {
  MeshScene scene = std::move(plants);
  for (const Obstacle& body : obstacles.bodies()) {
    if (body.is_hidden || body.mesh.triangles.empty()) continue;
    const auto material = static_cast<std::uint32_t>(scene.materials.size());
    scene.materials.push_back(material_of(body));
    scene.meshes.push_back(instances_of(body, material));
  }
  return scene;
}

}  // namespace meristem
