// SPDX-License-Identifier: Apache-2.0
#include "meristem/scene/light/light.h"

#include <cmath>

#include <gtest/gtest.h>

namespace meristem::light_test {

constexpr double kDortmund = 51.51494;  // degrees north

double sum_of(const std::vector<DirectionalLight>& lights) {
  double sum = 0;
  for (const DirectionalLight& light : lights) sum += light.strength;
  return sum;
}

double altitude_deg(const DirectionalLight& light) { return degrees(sky_direction(light.toward).altitude); }

TEST(SunOfDay, HasFifteenWholeHoursOnDay126InDortmund) {
  const std::vector<DirectionalLight> sun = sun_of_day(radians(kDortmund), 126, 1);
  ASSERT_EQ(sun.size(), 15U);
  for (std::size_t k = 0; k < sun.size(); ++k) {
    const SkyDirection expected = sun_position(radians(kDortmund), 126, 5 + static_cast<double>(k));
    EXPECT_LT(glm::distance(sun[k].toward, unit_vector(expected)), 1e-6F);
    // Strengths are proportional to the altitude.
    EXPECT_NEAR(sun[k].strength / sun[7].strength, altitude_deg(sun[k]) / altitude_deg(sun[7]), 1e-5);
  }
  EXPECT_NEAR(altitude_deg(sun[7]), 55.03, 0.005);
  EXPECT_NEAR(sum_of(sun), 1, 1e-12);
}

TEST(SunOfDay, IsSymmetricAboutNoon) {
  const std::vector<DirectionalLight> sun = sun_of_day(radians(-20), 300, 0.7);
  ASSERT_EQ(sun.size() % 2, 1U);
  for (std::size_t k = 0; k < sun.size(); ++k) {
    const DirectionalLight& other = sun[sun.size() - 1 - k];
    EXPECT_LT(glm::distance(sun[k].toward, Vec3(-1, 1, 1) * other.toward), 1e-6F);
    EXPECT_NEAR(sun[k].strength, other.strength, 1e-12);
  }
}

TEST(SunOfDay, HasEveryHourOfThePolarDayOnceAndNoneOfThePolarNight) {
  EXPECT_EQ(sun_of_day(radians(80), 172, 1).size(), 24U);
  EXPECT_EQ(sun_of_day(radians(80), 172, 24).size(), 1U);
  EXPECT_TRUE(sun_of_day(radians(80), 355, 1).empty());
  EXPECT_TRUE(sun_of_day(radians(-80), 172, 1).empty());
}

TEST(SunOfDays, WeighsAllDaysByAltitudeTogether) {
  const std::vector<DirectionalLight> year = sun_of_days(radians(70), {172, 355, 265}, 2);
  const std::vector<DirectionalLight> summer = sun_of_day(radians(70), 172, 2);
  const std::vector<DirectionalLight> autumn = sun_of_day(radians(70), 265, 2);
  ASSERT_EQ(year.size(), summer.size() + autumn.size()) << "the polar night gives none";
  EXPECT_NEAR(sum_of(year), 1, 1e-12);
  const double a_degree = year[0].strength / altitude_deg(year[0]);
  for (std::size_t k = 0; k < year.size(); ++k) {
    EXPECT_EQ(year[k].toward, k < summer.size() ? summer[k].toward : autumn[k - summer.size()].toward);
    EXPECT_NEAR(year[k].strength, a_degree * altitude_deg(year[k]), 1e-6);
  }
}

TEST(EvenSky, LightsLevelGroundAsADomeDoes) {
  const std::vector<DirectionalLight> sky = even_sky(0.4);
  EXPECT_EQ(sky.size(), 40U);
  EXPECT_NEAR(sum_of(sky), 0.4, 1e-12);
  // Under a dome of uniform brightness, the share of light from below the altitude with sine s is s squared.
  double low = 0;
  for (const DirectionalLight& patch : sky) {
    EXPECT_NEAR(glm::length(patch.toward), 1, 1e-6);
    EXPECT_GT(patch.toward.y, 0);
    if (patch.toward.y < 0.7) low += patch.strength;
  }
  EXPECT_NEAR(low, 0.4 * 0.7 * 0.7, 1e-12);
}

TEST(EvenSky, IsTheSameFromAllFourSides) {
  const std::vector<DirectionalLight> sky = even_sky(1);
  for (const DirectionalLight& patch : sky) {
    const Vec3 turned(patch.toward.z, patch.toward.y, -patch.toward.x);
    bool has_turned = false;
    for (const DirectionalLight& other : sky) {
      has_turned = has_turned || (glm::distance(other.toward, turned) < 1e-6F && other.strength == patch.strength);
    }
    EXPECT_TRUE(has_turned);
  }
}

TEST(Lamp, FallsWithTheSquareOfTheDistance) {
  const Lamp lamp{.position = {1, 2, 3}, .strength = 0.5};
  const LightRay near = Light::ray_to(lamp, {1, 2, 2});
  EXPECT_DOUBLE_EQ(near.strength, 0.5);
  EXPECT_DOUBLE_EQ(near.distance, 1);
  EXPECT_EQ(near.toward, Vec3(0, 0, 1));
  EXPECT_DOUBLE_EQ(Light::ray_to(lamp, {1, -2, 3}).strength, 0.5 / 16);
  EXPECT_DOUBLE_EQ(Light::ray_to(lamp, lamp.position).strength, 50) << "as 10 cm away";
  EXPECT_DOUBLE_EQ(Light::ray_to(lamp, {1, 2, 2.95F}).strength, 50);
}

TEST(Lamp, OfASpotShinesIntoItsConeOnly) {
  const Lamp spot{.position = {0, 4, 0}, .strength = 2, .target = Vec3(0), .angle = radians(60)};
  EXPECT_DOUBLE_EQ(Light::ray_to(spot, Vec3(0)).strength, 2.0 / 16);
  const auto share_at = [&](double degrees_off) {
    return spot.share_toward({4 * std::tan(radians(degrees_off)), 0, 0});
  };
  EXPECT_EQ(share_at(26), 1);
  EXPECT_NEAR(share_at(28.5), 0.5, 0.02) << "in the middle of the edge";
  EXPECT_EQ(share_at(30.1), 0);
  EXPECT_EQ(spot.share_toward({0, 5, 0}), 0);
}

TEST(Light, VisitsSunSkyAndLamps) {
  Light light;
  light.sky = even_sky(0.5);
  light.lamps = {{.position = {0, 3, 0}, .strength = 9}};
  double sum = 0;
  int near = 0;
  light.for_each_ray({0, 0, 0}, [&](const LightRay& ray) {
    sum += ray.strength;
    if (std::isfinite(ray.distance)) ++near;
  });
  EXPECT_NEAR(sum, 1 + 0.5 + 1, 1e-12);
  EXPECT_EQ(near, 1);
}

TEST(Light, HasTheMeanDirectionOfWhatIsFar) {
  Light light;
  EXPECT_EQ(light.mean_direction(), kUp);
  light.sun = {{.toward = {1, 0, 0}, .strength = 0.3}, {.toward = {0, 1, 0}, .strength = 0.4}};
  EXPECT_LT(glm::distance(light.mean_direction(), Vec3(0.6F, 0.8F, 0)), 1e-6F);
  light.sky = even_sky(1);
  EXPECT_GT(light.mean_direction().y, 0.9F) << "the sky's own is the zenith";
  light.sun.clear();
  EXPECT_LT(glm::distance(light.mean_direction(), kUp), 1e-6F);
  light.sky.clear();
  EXPECT_EQ(light.mean_direction(), kUp) << "in the dark";
}

}  // namespace meristem::light_test
