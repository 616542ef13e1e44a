// SPDX-License-Identifier: Apache-2.0
#include "meristem/measure/organ_light.h"

#include <cmath>
#include <limits>
#include <memory>

#include <gtest/gtest.h>

#include "meristem/base/parallel.h"
#include "meristem/base/random.h"
#include "meristem/measure/surface_points.h"
#include "meristem/shape/assembly/make_mesh_scene.h"
#include "meristem/shape/rays/ray_scene.h"
#include "meristem/shape/solid/primitives.h"
#include "tests/support/sample_scenes.h"

namespace meristem::organ_light_test {

/// Returns a level square of one metre about the origin. u grows along x.
std::shared_ptr<const Mesh> square() {
  Mesh mesh;
  mesh.positions = {{-0.5F, 0, 0.5F}, {0.5F, 0, 0.5F}, {0.5F, 0, -0.5F}, {-0.5F, 0, -0.5F}};
  mesh.uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return std::make_shared<const Mesh>(std::move(mesh));
}

/// A picture whose left half, up to u = 0.5, is holes.
std::shared_ptr<const Texture> half_holes() {
  Texture texture;
  texture.colour = {64, 1, std::vector<std::uint8_t>(4 * 64, 255)};
  for (int x = 0; x < 32; ++x) texture.colour.rgba[4 * x + 3] = 0;
  texture.masked = true;
  return std::make_shared<const Texture>(std::move(texture));
}

/// Organs of materials 0 (a leaf), 1 (a leaf with holes), 2 (a fruit).
Plant plant_of(const std::vector<std::shared_ptr<const Mesh>>& meshes) {
  Plant plant;
  plant.materials.resize(3);
  plant.materials[0].two_sided = true;
  plant.materials[1].two_sided = true;
  plant.materials[1].texture = half_holes();
  for (std::uint32_t k = 0; k < meshes.size(); ++k) plant.prototypes.push_back({"organ", k, meshes[k]});
  return plant;
}

void add_organ(Plant& plant, std::uint32_t prototype, Vec3 origin, const Mat3& axes = Mat3(1)) {
  plant.organs.push_back({.frame = {axes, origin}, .prototype = prototype});
}

std::vector<LitOrgan> measured(const Plant& plant, const Scene& scene = {}) {
  Progress progress;
  return measure_organ_light(plant, {}, make_mesh_scene(plant, {}, progress), scene, progress);
}

TEST(OrganLight, AFreeLeafGetsAllLightAndTakesUpTheCosine) {
  Plant plant = plant_of({square()});
  add_organ(plant, 0, {0, 0, 0});
  add_organ(plant, 0, {5, 0, 0}, rotation({1, 0, 0}, kPi / 3));
  add_organ(plant, 0, {9, 0, 0}, rotation({1, 0, 0}, kPi));
  const std::vector<LitOrgan> lit = measured(plant);
  const double taken_up[] = {1, 0.5, 1};
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(lit[k].area, 1, 1e-6);
    EXPECT_EQ(lit[k].exposure, 1) << k;
    EXPECT_NEAR(lit[k].irradiance, taken_up[k], 1e-6) << k;
  }
}

TEST(OrganLight, ALeafShadesWhatIsBelowIt) {
  Plant plant = plant_of({square()});
  add_organ(plant, 0, {0, 2, 0});
  add_organ(plant, 0, {0, 1, 0});
  add_organ(plant, 0, {0.75F, 1.5F, 0});  // a quarter lies below the first
  const std::vector<LitOrgan> lit = measured(plant);
  EXPECT_EQ(lit[0].exposure, 1);
  EXPECT_EQ(lit[1].exposure, 0);
  EXPECT_EQ(lit[1].irradiance, 0);
  EXPECT_NEAR(lit[2].exposure, 0.75, 0.04);
}

TEST(OrganLight, HolesLetLightThrough) {
  Plant plant = plant_of({square(), square()});
  add_organ(plant, 1, {0, 2, 0});
  add_organ(plant, 0, {0, 1, 0});
  EXPECT_NEAR(measured(plant)[1].exposure, 0.5, 0.04);
}

TEST(OrganLight, HolesThemselvesGetNone) {
  Plant plant = plant_of({square(), square()});
  add_organ(plant, 1, {0, 1, 0});
  add_organ(plant, 0, {-0.51F, 2, 0});  // above the half that is holes
  EXPECT_EQ(measured(plant)[0].exposure, 1);
  plant.organs[1].frame.origin.x = 0.49F;  // above the opaque half
  EXPECT_EQ(measured(plant)[0].exposure, 0);
}

TEST(OrganLight, ABallShadesItsOwnHalf) {
  Plant plant = plant_of({square(), square(), std::make_shared<const Mesh>(make_sphere(0.5, 32))});
  add_organ(plant, 2, {3, 1, 4});
  const std::vector<LitOrgan> lit = measured(plant);
  EXPECT_NEAR(lit[0].exposure, 0.5, 0.04);
  // A ball shows a disc to the light, and the disc has a quarter of the area of the ball's surface.
  EXPECT_NEAR(lit[0].irradiance, 0.25, 0.02);
}

TEST(OrganLight, ObstaclesShade) {
  Plant plant = plant_of({square()});
  add_organ(plant, 0, {0, 0, 0});
  Scene scene;
  scene.obstacles = Obstacles({{.mesh = box_mesh({-1, 2, -1}, {0, 3, 1})}});
  EXPECT_NEAR(measured(plant, scene)[0].exposure, 0.5, 0.04);
}

TEST(OrganLight, StemsShade) {
  Plant plant = plant_of({square()});
  add_organ(plant, 0, {0, 0, 0});
  Stem stem;
  stem.skeleton.add_node(kNoNode, {-3, 4, 0}, 0);
  stem.skeleton.add_node(0, {3, 4, 0}, 0);
  stem.skeleton.radius = {2, 2};
  plant.stems = {stem};
  EXPECT_EQ(measured(plant)[0].exposure, 0);
}

TEST(OrganLight, LightsCountByTheirStrength) {
  Plant plant = plant_of({square()});
  add_organ(plant, 0, {0, 0, 0});
  Scene scene;
  // Three quarters of the light come from the east at 30°, where a wall stops it. A quarter comes from the zenith.
  scene.light.sun = {{.toward = {std::sqrt(0.75F), 0.5F, 0}, .strength = 0.75}};
  scene.light.sky = {{.toward = kUp, .strength = 0.25}};
  EXPECT_NEAR(measured(plant, scene)[0].exposure, 1, 1e-9);
  EXPECT_NEAR(measured(plant, scene)[0].irradiance, 0.75 * 0.5 + 0.25, 1e-6);
  scene.obstacles = Obstacles({{.mesh = box_mesh({4, -9, -99}, {5, 99, 99})}});
  EXPECT_NEAR(measured(plant, scene)[0].exposure, 0.25, 1e-9);
}

TEST(OrganLight, WhatIsBeyondALampShadesNothing) {
  Plant plant = plant_of({square()});
  add_organ(plant, 0, {0, 0, 0});
  add_organ(plant, 0, {0, 3, 0});
  Scene scene;
  scene.light.sun = {};
  scene.light.lamps = {{.position = {0, 2, 0}, .strength = 5}};
  scene.obstacles = Obstacles({{.mesh = box_mesh({-9, 4, -9}, {9, 5, 9})}});
  for (const LitOrgan& lit : measured(plant, scene)) EXPECT_EQ(lit.exposure, 1);
  // The lamp shines from below, so the lower square shades the upper one.
  scene.light.lamps[0].position.y = 3.5F;
  const std::vector<LitOrgan> lit = measured(plant, scene);
  EXPECT_EQ(lit[0].exposure, 0);
  EXPECT_EQ(lit[1].exposure, 1);
}

TEST(OrganLight, WithoutLightThereIsNone) {
  Plant plant = plant_of({square()});
  add_organ(plant, 0, {0, 0, 0});
  Scene scene;
  scene.light.sun = {};
  EXPECT_EQ(measured(plant, scene)[0].exposure, 0);
  scene.light.lamps = {{.position = {0, 2, 0}, .strength = 0}};
  EXPECT_EQ(measured(plant, scene)[0].irradiance, 0);
}

TEST(OrganLight, FlattenedOrgansAndPlantsWithoutAnyGetNothing) {
  EXPECT_TRUE(measured({}).empty());
  Plant plant = plant_of({square()});
  add_organ(plant, 0, {0, 0, 0}, Mat3(0));
  EXPECT_EQ(measured(plant)[0].exposure, 0);
}

/// Returns leaves in a ball, turned in all directions.
Plant foliage(std::uint64_t leaves) {
  Plant plant = plant_of({square()});
  const RandomKey key(4);
  for (std::uint64_t k = 0; k < leaves; ++k) {
    const Frame frame = frame_along({}, key.child("way").direction(k), key.child("upper").direction(k));
    const auto out = static_cast<float>(2 * std::cbrt(key.uniform(k)));
    add_organ(plant, 0, out * key.child("place").direction(k), 0.3F * frame.axes);
  }
  return plant;
}

Scene noon_and_lamp() {
  Scene scene;
  scene.light.sun = sun_of_day(radians(51.5), 126, 4);
  scene.light.lamps = {{.position = {3, 1, 0}, .strength = 2}};
  return scene;
}

TEST(OrganLight, AgreesWithRaysThatAreTestedOtherwise) {
  const Plant plant = foliage(300);
  const Scene scene = noon_and_lamp();
  Progress progress;
  const MeshScene meshes = make_mesh_scene(plant, {}, progress);
  const Mesh all = flattened(meshes);
  Obstacle leaves;
  for (const Vec3 position : all.positions) leaves.mesh.positions.emplace_back(position);
  leaves.mesh.triangles = all.triangles;
  const Obstacles obstacles({leaves});
  const SurfacePoints places(all);
  const RandomKey key(8);
  double sent = 0;
  double arrived = 0;
  constexpr std::uint64_t kPlaces = 20'000;
  for (std::uint64_t k = 0; k < kPlaces; ++k) {
    const Vec3 point = places.position(places.at(key.uniform(k), key.uniform(k, 1)));
    double sent_here = 0;
    double arrived_here = 0;
    scene.light.for_each_ray(point, [&](const LightRay& ray) {
      sent_here += ray.strength;
      const Vec3 start = point + 1e-3F * ray.toward;
      if (!obstacles.first_hit(start, ray.toward, ray.distance - 1e-3)) arrived_here += ray.strength;
    });
    arrived += arrived_here / sent_here;
    sent += 1;
  }
  // Both use some 20,000 samples. Shares that are all 0 or 1 would have errors of 0.0035 in each mean.
  const LitOrgan mean = mean_leaf_light(plant, measured(plant, scene));
  EXPECT_NEAR(mean.exposure, arrived / sent, 0.02);
  EXPECT_GT(mean.exposure, 0.1);
  EXPECT_LT(mean.exposure, 0.9);
}

TEST(OrganLight, WhatLeavesTakeUpIsMissingOnTheGround) {
  const Plant plant = foliage(300);
  Scene scene;
  scene.light.sun = {{.toward = glm::normalize(Vec3(0.4F, 1, 0.2F))}};
  const LitOrgan leaves = mean_leaf_light(plant, measured(plant, scene));
  // Samples the plant's shadow on a plane that faces the light, with a grid of rays.
  Progress progress;
  const MeshScene meshes = make_mesh_scene(plant, {}, progress);
  const RayScene rays(meshes, progress);
  const Vec3 light = scene.light.sun[0].toward;
  const Frame plane = frame_along(-5.0F * light, light, kUp);
  constexpr int kSide = 300;
  constexpr float kStep = 5.0F / kSide;
  int shaded = 0;
  for (int k = 0; k < kSide * kSide; ++k) {
    const Vec3 point(kStep * (k % kSide + 0.5F) - 2.5F, 0, kStep * (k / kSide + 0.5F) - 2.5F);
    shaded += rays.is_blocked({plane.point(point), light}) ? 1 : 0;
  }
  EXPECT_NEAR(leaves.area * leaves.irradiance, double{kStep} * kStep * shaded, 0.02 * kStep * kStep * shaded);
}

TEST(OrganLight, ATurnedPlantUnderATurnedSunGetsTheSame) {
  Plant plant = foliage(200);
  Scene scene;
  scene.light.sun = sun_of_day(radians(51.5), 126, 2);
  const LitOrgan before = mean_leaf_light(plant, measured(plant, scene));
  const Mat3 turn = rotation(kUp, 1.0);
  for (Organ& organ : plant.organs) organ.frame = Frame{.axes = turn} * organ.frame;
  for (DirectionalLight& sun : scene.light.sun) sun.toward = turn * sun.toward;
  const LitOrgan after = mean_leaf_light(plant, measured(plant, scene));
  EXPECT_NEAR(after.exposure, before.exposure, 1e-3);
  EXPECT_NEAR(after.irradiance, before.irradiance, 1e-3);
}

TEST(OrganLight, TheSameNumbersOnAnyNumberOfThreads) {
  const Plant plant = foliage(300);
  const auto numbers = [&](int threads) {
    const ThreadLimit limit(threads);
    std::vector<double> all;
    for (const LitOrgan& lit : measured(plant, noon_and_lamp())) {
      all.insert(all.end(), {lit.area, lit.exposure, lit.irradiance});
    }
    return all;
  };
  const std::vector<double> one = numbers(1);
  for (const int threads : {2, 3, 8}) EXPECT_EQ(numbers(threads), one);
}

TEST(OrganLight, StopsWhenCancelled) {
  const Plant plant = foliage(10);
  Progress progress;
  const MeshScene meshes = make_mesh_scene(plant, {}, progress);
  progress.cancel();
  EXPECT_THROW(measure_organ_light(plant, {}, meshes, {}, progress), Cancelled);
}

TEST(LeafLight, IsTheMeanByAreaOfTwoSidedOrgans) {
  Plant plant = plant_of({square(), square(), square()});
  for (std::uint32_t k = 0; k < 3; ++k) add_organ(plant, k, {});
  const LitOrgan mean = mean_leaf_light(plant, {{1, 0.8, 0.4}, {3, 0.4, 0.2}, {100, 1, 1}});
  EXPECT_DOUBLE_EQ(mean.area, 4);
  EXPECT_DOUBLE_EQ(mean.exposure, 0.5);
  EXPECT_DOUBLE_EQ(mean.irradiance, 0.25);
  EXPECT_EQ(mean_leaf_light({}, {}).exposure, 0);
}

}  // namespace meristem::organ_light_test
