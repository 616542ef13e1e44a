// SPDX-License-Identifier: Apache-2.0
#include "meristem/plant/plant.h"

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "examples.h"
#include "meristem/plant/skeleton.h"
#include "meristem/scene/crown/solid_crowns.h"
#include "meristem/scene/light/light.h"
#include "meristem/scene/obstacle/obstacles.h"
#include "meristem/scene/scene.h"
#include "meristem/shape/assembly/make_mesh_scene.h"
#include "meristem/shape/scene/mesh_scene.h"
#include "meristem/shape/solid/primitives.h"

using namespace meristem;

namespace {

// Example of Skeleton: a stem of three nodes, and its length by a loop from root to tip.
void skeleton() {
  Skeleton stem;
  const NodeIndex root = stem.add_node(kNoNode, {0, 0, 0}, 0);
  const NodeIndex middle = stem.add_node(root, {0, 1, 0}, 1);
  stem.add_node(middle, {0.6F, 1.8F, 0}, 2);
  stem.radius = {0.03F, 0.02F, 0.01F};

  float length = 0;
  for (NodeIndex node = 0; node < stem.node_count(); ++node) {
    if (stem.is_root(node)) continue;
    length += glm::distance(stem.position[node], stem.position[stem.parent[node]]);
  }
  expect(std::abs(length - 2) < 1e-6F);
  expect(tip_distance(stem)[root] == length);
}

// Example of NodeChildren: the forks of a skeleton.
void children() {
  Skeleton fork;
  const NodeIndex root = fork.add_node(kNoNode, {0, 0, 0}, 0);
  fork.add_node(root, {-0.5F, 1, 0}, 1);
  fork.add_node(root, {0.5F, 1, 0}, 1);
  const NodeChildren children(fork);
  expect(children.of(root).size() == 2);
}

// Example of Plant: a stem and a fruit at its tip, put together by hand.
void plant() {
  Plant made;
  made.materials.resize(2);
  Stem& stem = made.stems.emplace_back();
  stem.parts[0].component = "stem";
  const NodeIndex root = stem.skeleton.add_node(kNoNode, {0, 0, 0}, 0);
  stem.skeleton.add_node(root, {0, 1, 0}, 1);
  stem.skeleton.radius = {0.02F, 0.01F};

  made.prototypes.push_back(
      {.component = "fruit", .material = 1, .mesh = std::make_shared<const Mesh>(make_sphere(0.05, 12))});
  Organ fruit;
  fruit.frame.origin = {0, 1, 0};
  made.organs.push_back(fruit);

  Progress progress;
  const MeshScene scene = make_mesh_scene(made, SizeLimits(), progress);
  expect(scene.meshes.size() == 2);
}

// Example of Obstacles: what a ray meets at a wall.
void obstacles() {
  std::vector<Obstacle> bodies(1);
  bodies[0].mesh = box_mesh({1, 0, -3}, {1.2, 2, 3});  // metres: a wall in the east, 2 m high
  const Obstacles walls(std::move(bodies));

  const auto hit = walls.first_hit({0, 1, 0}, {1, 0, 0}, std::numeric_limits<double>::infinity());
  expect(hit && std::abs(hit->distance - 1) < 1e-6);
  expect(walls.contain({1.1F, 1, 0}));
  expect(!walls.cross({0, 3, 0}, {2, 3, 0}));  // above the wall
}

// Example of Scene: a wall, and the sun of a midsummer day at 51.5° north.
void scene() {
  Scene garden;
  std::vector<Obstacle> bodies(1);
  bodies[0].mesh = box_mesh({-3, 0, 1}, {3, 2, 1.2});
  garden.obstacles = Obstacles(std::move(bodies));
  garden.latitude = radians(51.5);
  garden.light.sun = sun_of_day(*garden.latitude, 172, 1);  // every hour of 21 June
  garden.light.sky = {};

  double strength = 0;
  for (const DirectionalLight& hour : garden.light.sun) strength += hour.strength;
  expect(std::abs(strength - 1) < 1e-9);
  expect(garden.light.mean_direction().z > 0);  // from the south
}

// Example of EllipsoidCrown: a crown 2 m high, with its middle 1.8 m above the ground.
void ellipsoid_crown() {
  const EllipsoidCrown crown({0, 1.8F, 0}, {1, 1, 1});
  expect(crown.contains({0, 2.7F, 0}));
  expect(!crown.contains({0, 0.7F, 0}));
}

}  // namespace

void plant_examples() {
  skeleton();
  children();
  plant();
  obstacles();
  scene();
  ellipsoid_crown();
}
