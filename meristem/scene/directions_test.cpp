// SPDX-License-Identifier: Apache-2.0
#include "meristem/scene/directions.h"

#include <gtest/gtest.h>

#include "meristem/scene/scene.h"

namespace meristem::directions_test {

constexpr SkyDirection kMorning{kPi / 2, kPi / 6};

void expect_near(Vec3 found, Vec3 expected) {
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(found[k], expected[k], 1e-5) << k;
}

Scene scene_under(std::vector<DirectionalLight> sun, SkyDirection shown) {
  Scene scene;
  scene.light.sun = std::move(sun);
  scene.sun = shown;
  return scene;
}

TEST(Directions, OnePositionOfTheSunIsTheWayToTheLastBit) {
  const Scene scene = scene_under({DirectionalLight{unit_vector(kMorning)}}, kMorning);
  EXPECT_EQ(scene.directions().toward_light({1, 2, 3}), unit_vector(kMorning));
  EXPECT_EQ(Scene().directions().toward_light({1, 2, 3}), kUp);
}

TEST(Directions, OverADayItIsTheMiddleOfTheSunsPositions) {
  const std::vector<DirectionalLight> day = sun_of_day(radians(50), 172, 1);
  const Vec3 found = scene_under(day, kMorning).directions().toward_light(Vec3(0));
  EXPECT_NEAR(found.x, 0, 1e-6);  // symmetric about noon
  EXPECT_GT(found.z, 0.1);        // toward the south
  EXPECT_GT(found.y, 0.5);
}

TEST(Directions, ASunBelowTheHorizonPullsNothing) {
  const SkyDirection night{kPi, -0.4};
  EXPECT_EQ(scene_under({}, night).directions().toward_light(Vec3(0)), kUp);
  Scene cloudy = scene_under({}, night);
  cloudy.light.sky = even_sky(1);
  EXPECT_EQ(cloudy.directions().toward_light(Vec3(0)), kUp);
  // Under clouds by day, the light comes from the sun behind them.
  cloudy.sun = kMorning;
  EXPECT_EQ(cloudy.directions().toward_light(Vec3(0)), unit_vector(kMorning));
}

TEST(Directions, ALampPullsByNightAndTheNearestMost) {
  Scene night = scene_under({}, {kPi, -0.4});
  night.light.lamps = {{.position = {3, 2, 0}}};
  expect_near(night.directions().toward_light({0, 2, 0}), {1, 0, 0});
  night.light.lamps.push_back({.position = {-1, 2, 0}});
  EXPECT_LT(night.directions().toward_light({0, 2, 0}).x, 0);
  EXPECT_NE(night.directions().key_at({0, 2, 0}), night.directions().key_at({2, 2, 0}));
}

TEST(Directions, ByDayALampPullsByItsStrength) {
  Scene day;
  day.light.lamps = {{.position = {2, 0, 0}, .strength = 4}};
  // At two metres, the lamp is as strong as the light from the zenith.
  expect_near(day.directions().toward_light(Vec3(0)), glm::normalize(Vec3(1, 1, 0)));
  EXPECT_EQ(Scene().directions().key_at({0, 2, 0}), Scene().directions().key_at({2, 2, 0}));
}

}  // namespace meristem::directions_test
