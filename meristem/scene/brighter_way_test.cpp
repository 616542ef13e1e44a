// SPDX-License-Identifier: Apache-2.0
#include "meristem/scene/brighter_way.h"

#include <gtest/gtest.h>

#include "tests/support/walled_scene.h"

namespace meristem::brighter_way_test {

constexpr double kNear = 1e-6;

void expect_near(DVec3 a, DVec3 b) { EXPECT_LT(glm::length(a - b), kNear) << a.x << ' ' << a.y << ' ' << a.z; }

TEST(BrighterWay, LeadsTowardTheSunInTheOpen) {
  expect_near(brighter_way(scene_under(kSouth), Vec3(1, 2, 3), 1), DVec3(unit_vector(kSouth)));
  expect_near(brighter_way(scene_under(kSouth), Vec3(1, 2, 3), 0.25), 0.25 * DVec3(unit_vector(kSouth)));
}

TEST(BrighterWay, LeadsAwayFromAWallAtRightAnglesToTheLight) {
  const Scene scene = walled_scene(kSouth);
  const DVec3 way = brighter_way(scene, Vec3(0, 1, 0), 0.25);
  EXPECT_NEAR(glm::length(way), 1, kNear);
  EXPECT_NEAR(glm::dot(way, DVec3(scene.light.sun[0].toward)), 0, kNear);
  EXPECT_LT(way.z, 0);
  EXPECT_GT(way.y, 0);
  EXPECT_NEAR(way.x, 0, kNear);
}

TEST(BrighterWay, WeighsTheLightsByTheirStrength) {
  Scene scene;
  scene.light.sun = {{Vec3(1, 0, 0), 0.75}, {Vec3(-1, 0, 0), 0.25}};
  expect_near(brighter_way(scene, Vec3(0), 1), DVec3(0.5, 0, 0));
}

TEST(BrighterWay, LeadsTowardLampsByTheSquareOfTheirDistance) {
  Scene scene;
  scene.light.sun.clear();
  scene.light.lamps = {{Vec3(2, 0, 0), 1}};
  expect_near(brighter_way(scene, Vec3(0), 1), DVec3(0.25, 0, 0));
}

TEST(BrighterWay, IsNoneInTheDark) {
  Scene scene;
  scene.light.sun.clear();
  expect_near(brighter_way(scene, Vec3(0), 1), DVec3(0));
}

}  // namespace meristem::brighter_way_test
