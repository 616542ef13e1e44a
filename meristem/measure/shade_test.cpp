// SPDX-License-Identifier: Apache-2.0
#include "meristem/measure/shade.h"

#include <cmath>
#include <memory>
#include <numeric>
#include <utility>

#include <gtest/gtest.h>

#include "meristem/base/parallel.h"
#include "meristem/plant/plant.h"
#include "meristem/shape/assembly/make_mesh_scene.h"
#include "meristem/shape/solid/primitives.h"

namespace meristem::shade_test {

Obstacles boxes(const std::vector<std::pair<DVec3, DVec3>>& corners) {
  std::vector<Obstacle> bodies;
  for (const auto& [low, high] : corners) bodies.push_back({.mesh = box_mesh(low, high)});
  return Obstacles(std::move(bodies));
}

/// Returns the meshes of a plant with one organ.
MeshScene scene_of(const Mesh& mesh, Vec3 origin, const Material& material = {}) {
  Plant plant;
  plant.materials = {material};
  plant.prototypes = {{"organ", 0, std::make_shared<const Mesh>(mesh)}};
  plant.organs.push_back({.frame = {.origin = origin}});
  Progress progress;
  return make_mesh_scene(plant, {}, progress);
}

ShadeOfSurface measured(const ShadeSurface& surface, const std::vector<SkyDirection>& sun, const MeshScene& plants = {},
                        const Obstacles& obstacles = {}) {
  Progress progress;
  return measure_shade(surface, sun, plants, obstacles, progress);
}

/// The sun in the south at an altitude in degrees.
SkyDirection south(double altitude) { return {kPi, radians(altitude)}; }

/// Returns a level square of 2 m. u grows with x.
Mesh level_square() {
  Mesh mesh;
  mesh.positions = {{-1, 0, 1}, {1, 0, 1}, {1, 0, -1}, {-1, 0, -1}};
  mesh.uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

TEST(Shade, ABallsShadowOnTheGroundIsItsDiscOverTheSineOfTheAltitude) {
  const MeshScene ball = scene_of(make_sphere(1, 64), {0, 3, 0});
  const ShadeSurface ground = ground_surface({-10, -10}, {10, 10}, 0, {}, 0.1);
  for (const double altitude : {90.0, 60.0, 35.0}) {
    const ShadeOfSurface shade = measured(ground, {south(altitude)}, ball);
    EXPECT_NEAR(shade.moments[0].shade * ground.area, kPi / std::sin(radians(altitude)), 0.04) << altitude;
    EXPECT_EQ(shade.moments[0].shade_without_plants, 0) << altitude;
    EXPECT_NEAR(shade.moments[0].cosine, std::sin(radians(altitude)), 1e-6) << altitude;
  }
}

TEST(Shade, AWallsShadowIsItsHeightOverTheTangentLong) {
  // A wall along x through the origin, 0.2 m thick, 2 m high, and ground north of it.
  const Obstacles wall = boxes({{{-20, 0, 0}, {20, 2, 0.2}}});
  const ShadeSurface ground = ground_surface({-1, -8}, {1, 0}, 0, wall, 0.05);
  for (const double altitude : {30.0, 45.0, 70.0}) {
    const double length = 2 / std::tan(radians(altitude));
    const ShadeOfSurface shade = measured(ground, {south(altitude)}, {}, wall);
    EXPECT_NEAR(shade.moments[0].shade * 8, length, 0.03) << altitude;
    EXPECT_EQ(shade.moments[0].shade, shade.moments[0].shade_without_plants);
  }
}

TEST(Shade, AFacadeBehindABigBoxLiesInFullShade) {
  const Obstacles houses = boxes({{{-5, 0, -10}, {5, 6, -5}}, {{-50, 0, 5}, {50, 40, 10}}});
  const ShadeSurface facade = facade_surface(houses, 0, FacadeSide::south, {}, 0.5);
  EXPECT_NEAR(facade.area, 60, 1e-6);
  for (const Vec3 normal : facade.normals) EXPECT_NEAR(normal.z, 1, 1e-6);
  const ShadeOfSurface shade = measured(facade, {south(30), south(85)}, {}, houses);
  EXPECT_EQ(shade.moments[0].shade_without_plants, 1);
  EXPECT_EQ(shade.moments[0].direct, 0);
  EXPECT_EQ(shade.moments[1].shade_without_plants, 0);  // above the box
  EXPECT_NEAR(shade.moments[1].direct, std::cos(radians(85)), 1e-6);
}

TEST(Shade, WhatLooksAwayFromTheSunLiesInShade) {
  const Obstacles house = boxes({{{-5, 0, -5}, {5, 6, 5}}});
  const auto share = [&](FacadeSide side, SkyDirection sun) {
    return measured(facade_surface(house, 0, side, {}, 0.5), {sun}, {}, house).moments[0].shade;
  };
  EXPECT_EQ(share(FacadeSide::south, south(30)), 0);
  EXPECT_EQ(share(FacadeSide::north, south(30)), 1);
  EXPECT_EQ(share(FacadeSide::roof, south(30)), 0);
  EXPECT_NEAR(share(FacadeSide::walls, {kPi * 3 / 4, radians(30)}), 0.5, 0.01);  // the south and east walls face the
                                                                                 // sun
}

TEST(Shade, APlantTakesLightOnlyWhereObstaclesLeaveSome) {
  const Obstacles wall = boxes({{{-20, 0, 0}, {20, 2, 0.2}}});
  const ShadeSurface ground = ground_surface({-3, -6}, {3, 0}, 0, wall, 0.1);
  const MeshScene ball = scene_of(make_sphere(0.5, 64), {0, 3, -2});
  const ShadeOfSurface both = measured(ground, {south(45)}, ball, wall);
  const ShadeOfSurface without = measured(ground, {south(45)}, {}, wall);
  EXPECT_EQ(both.moments[0].shade_without_plants, without.moments[0].shade);
  EXPECT_EQ(both.of_point_without_plants, without.of_point);
  // The ball's shadow falls beyond the wall's shadow, which is 2 m long.
  EXPECT_NEAR((both.moments[0].shade - without.moments[0].shade) * ground.area, kPi / 4 / std::sin(radians(45)), 0.05);
}

TEST(Shade, HolesOfTexturesLetLightPass) {
  Texture texture;
  texture.colour = {64, 1, std::vector<std::uint8_t>(std::size_t{4} * 64, 255)};
  for (std::size_t x = 0; x < 32; ++x) texture.colour.rgba[4 * x + 3] = 0;
  texture.masked = true;
  const MeshScene leaf = scene_of(level_square(), {0, 1, 0},
                                  {.two_sided = true, .texture = std::make_shared<const Texture>(std::move(texture))});
  const ShadeSurface ground = ground_surface({-2, -2}, {2, 2}, 0, {}, 0.1);
  EXPECT_NEAR(measured(ground, {south(90)}, leaf).moments[0].shade * ground.area, 2, 0.11);
}

TEST(Shade, PanelsLookWhereTheyAreTurned) {
  const PanelField field{.position = {1, 2, 3}, .width = 4, .length = 2, .tilt = radians(30), .azimuth = radians(135)};
  const ShadeSurface panels = panel_surface(field, 0.5);
  EXPECT_EQ(panels.columns, 8);
  EXPECT_EQ(panels.rows, 4);
  EXPECT_EQ(panels.positions.size(), 32U);
  EXPECT_DOUBLE_EQ(panels.area, 8);
  const SkyDirection facing{radians(135), radians(60)};  // at right angles to the panels
  EXPECT_NEAR(measured(panels, {facing}).moments[0].cosine, 1, 1e-6);
  EXPECT_EQ(measured(panels, {{radians(315), radians(25)}}).moments[0].shade, 1);  // from behind
  // The first row is the lowest. The first column is at the left as seen from the southeast, which is the southwest
  // end.
  EXPECT_LT(panels.positions.front().y, panels.positions.back().y);
  EXPECT_LT(panels.positions[0].x, panels.positions[7].x);
  EXPECT_GT(panels.positions[0].z, panels.positions[7].z);
}

TEST(Shade, NightIsShadeAndCountsForNoPoint) {
  const ShadeSurface ground = ground_surface({0, 0}, {1, 1}, 0, {}, 0.5);
  const ShadeOfSurface shade = measured(ground, {south(-5), south(40)});
  EXPECT_EQ(shade.moments[0].shade, 1);
  EXPECT_EQ(shade.moments[0].cosine, 0);
  EXPECT_EQ(shade.moments[1].shade, 0);
  for (const double share : shade.of_point) EXPECT_EQ(share, 0);
}

TEST(Shade, GroundUnderAHouseDoesNotCount) {
  const Obstacles house = boxes({{{-1, -1, -1}, {1, 6, 1}}});
  const ShadeSurface ground = ground_surface({-2, -2}, {2, 2}, 0, house, 0.5);
  EXPECT_EQ(ground.has_point.size(), 64U);
  EXPECT_EQ(ground.positions.size(), 48U);
  EXPECT_NEAR(ground.area, 12, 1e-9);
  EXPECT_EQ(measured(ground, {south(90)}, {}, house).moments[0].shade, 0);
}

TEST(Shade, WallsBelowTheGroundAndWithinOthersDoNotCount) {
  const Obstacles sunk = boxes({{{0, -2, 0}, {4, 2, 4}}});
  EXPECT_NEAR(facade_surface(sunk, 0, FacadeSide::south, {}, 0.1).area, 8, 0.2);
  const Obstacles joined_houses = boxes({{{0, 0, 0}, {4, 2, 4}}, {{1, 0, 3}, {3, 2, 6}}});
  EXPECT_NEAR(facade_surface(joined_houses, 0, FacadeSide::south, {}, 0.05).area, 4, 0.1);
}

TEST(Shade, AMeshTurnedInsideOutHasTheSameWalls) {
  Obstacle body{.mesh = box_mesh({0, 0, 0}, {4, 2, 4})};
  for (auto& triangle : body.mesh.triangles) std::swap(triangle[1], triangle[2]);
  const Obstacles turned({body});
  const ShadeSurface south_wall = facade_surface(turned, 0, FacadeSide::south, {}, 0.5);
  ASSERT_FALSE(south_wall.positions.empty());
  for (std::size_t k = 0; k < south_wall.positions.size(); ++k) {
    EXPECT_NEAR(south_wall.positions[k].z, 4, 1e-6);
    EXPECT_NEAR(south_wall.normals[k].z, 1, 1e-6);
  }
}

TEST(Shade, AnAzimuthChoosesTheWallsOfATurnedHouse) {
  Obstacle body{.mesh = box_mesh({-2, 0, -2}, {2, 3, 2})};
  const glm::dmat3 turn(rotation(kUp, radians(-40)));  // clockwise from above
  for (DVec3& position : body.mesh.positions) position = turn * position;
  const Obstacles house({body});
  const ShadeSurface wall = facade_surface(house, 0, FacadeSide::walls, radians(220), 0.5);
  EXPECT_NEAR(wall.area, 12, 1e-5);
  const Vec3 expected = unit_vector({radians(220), 0});
  for (const Vec3 normal : wall.normals) EXPECT_NEAR(glm::dot(normal, expected), 1, 1e-5);
}

// The result does not change if everything, sun and plants, turns about the vertical.
TEST(Shade, TurningTheWorldChangesNothing) {
  const MeshScene ball = scene_of(make_sphere(1, 64), {1, 2, 0});
  const PanelField field{.position = {0, 1, 0}, .width = 3, .length = 3, .tilt = radians(20), .azimuth = kPi};
  const double first = measured(panel_surface(field, 0.05), {{radians(100), radians(40)}}, ball).moments[0].shade;
  PanelField turned = field;
  turned.azimuth += kPi / 2;
  const MeshScene turned_ball = scene_of(make_sphere(1, 64), {0, 2, 1});
  const double second =
      measured(panel_surface(turned, 0.05), {{radians(190), radians(40)}}, turned_ball).moments[0].shade;
  EXPECT_GT(first, 0.1);
  EXPECT_NEAR(first, second, 0.005);
}

TEST(Shade, TheSameBytesOnAnyNumberOfThreads) {
  const MeshScene ball = scene_of(make_sphere(1, 32), {0, 2, 0});
  const ShadeSurface ground = ground_surface({-3, -3}, {3, 3}, 0, {}, 0.1);
  std::vector<SkyDirection> sun;
  for (int k = 1; k < 150; ++k) sun.push_back({0.04 * k, 0.01 * k});
  const auto run = [&](int threads) {
    const ThreadLimit limit(threads);
    return measured(ground, sun, ball);
  };
  const ShadeOfSurface one = run(1);
  for (const int threads : {2, 3, 8}) {
    const ShadeOfSurface many = run(threads);
    EXPECT_EQ(many.of_point, one.of_point);
    for (std::size_t k = 0; k < sun.size(); ++k) {
      EXPECT_EQ(many.moments[k].shade, one.moments[k].shade);
      EXPECT_EQ(many.moments[k].direct, one.moments[k].direct);
    }
  }
}

TEST(Shade, MomentsAndPointsTellTheSameSum) {
  const MeshScene ball = scene_of(make_sphere(1, 32), {0, 2, 0});
  const ShadeSurface ground = ground_surface({-3, -3}, {3, 3}, 0, {}, 0.3);
  const ShadeOfSurface shade = measured(ground, {south(80), south(50), south(20)}, ball);
  double by_moment = 0;
  for (const ShadeMoment& moment : shade.moments) by_moment += moment.shade / 3;
  const double by_point = std::accumulate(shade.of_point.begin(), shade.of_point.end(), 0.0);
  EXPECT_NEAR(by_moment, by_point / static_cast<double>(shade.of_point.size()), 1e-12);
}

TEST(Shade, RefusesTooManyRaysAndCanBeStopped) {
  const ShadeSurface ground = ground_surface({0, 0}, {100, 100}, 0, {}, 0.1);
  EXPECT_THROW(measured(ground, std::vector<SkyDirection>(300, south(40))), std::invalid_argument);
  Progress progress;
  progress.cancel();
  EXPECT_THROW(measure_shade(ground, {south(40)}, {}, {}, progress), Cancelled);
}

}  // namespace meristem::shade_test
