// SPDX-License-Identifier: Apache-2.0
#include "meristem/output/picture/lamplight.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "meristem/base/colour.h"

namespace meristem::lamplight_test {

constexpr int kSamples = 4096;

/// Returns the mean irradiance that the drawn rays give to a position.
Vec3 mean_irradiance(const Lamplight& lamps, Vec3 position, float nearest = 0) {
  DVec3 sum(0);
  for (std::uint32_t s = 0; s < kSamples; ++s) {
    SampleStream samples(3, s, kSamples);
    lamps.for_each_ray(position, nearest, samples, [&](const Lamplight::Ray& ray) { sum += DVec3(ray.irradiance); });
  }
  return Vec3(sum / static_cast<double>(kSamples));
}

TEST(Lamplight, IsTheMiddaySunAMetreAwayFromAStrengthOf1) {
  const Lamplight lamps({{.position = {0, 1, 0}, .strength = 1}});
  EXPECT_NEAR(luminance(lamps.irradiance({0, 0, 0})), 2.45, 0.05) << "100 klux";
  EXPECT_GT(lamps.irradiance(Vec3(0)).r, lamps.irradiance(Vec3(0)).b) << "warm";
  EXPECT_NEAR(lamps.irradiance({0, -1, 0}).g, lamps.irradiance({0, 0, 0}).g / 4, 1e-6);
}

TEST(Lamplight, DrawsLampsByTheirLight) {
  std::vector<Lamp> lamps;
  for (int k = 0; k < 7; ++k) lamps.push_back({.position = {static_cast<float>(k), 2, 1}, .strength = 0.1 + 0.2 * k});
  const Lamplight light(lamps);
  const Vec3 position(1.5F, 0, 0);
  const Vec3 expected = light.irradiance(position);
  EXPECT_NEAR(mean_irradiance(light, position).g, expected.g, 1e-5 * expected.g) << "every ray has the light of all";
  int first = 0;
  for (std::uint32_t s = 0; s < kSamples; ++s) {
    SampleStream samples(3, s, kSamples);
    light.for_each_ray(position, 0, samples, [&](const Lamplight::Ray& ray) {
      if (glm::dot(ray.toward, glm::normalize(lamps[0].position - position)) > 0.999F) ++first;
    });
  }
  const Vec3 share = Lamplight({lamps[0]}).irradiance(position) / expected;
  EXPECT_NEAR(first, kSamples * share.g, 10);
}

TEST(Lamplight, OfTwoLampsComesInTwoRays) {
  const Lamplight lamps({{.position = {0, 1, 0}}, {.position = {2, 1, 0}}});
  SampleStream samples(3, 1, 16);
  int rays = 0;
  lamps.for_each_ray(Vec3(0), 0, samples, [&](const Lamplight::Ray&) { ++rays; });
  EXPECT_EQ(rays, 2);
  EXPECT_NEAR(mean_irradiance(lamps, Vec3(0)).g, lamps.irradiance(Vec3(0)).g, 1e-5);
}

TEST(Lamplight, IsBoundedNearTheLamp) {
  const Lamplight lamps({{.position = {0, 1, 0}}});
  const float at_10_cm = lamps.irradiance({0, 0.9F, 0}).g;
  EXPECT_NEAR(lamps.irradiance({0, 1, 0}).g, at_10_cm, 1e-3);
  const float as_from_half_a_metre = lamps.irradiance({0, 0.5F, 0}).g;
  EXPECT_NEAR(mean_irradiance(lamps, {0, 0.8F, 0}, 0.5F).g, as_from_half_a_metre, 1e-4 * as_from_half_a_metre);
}

TEST(Lamplight, HasTheHueOfItsColourWhateverItsBrightness) {
  const Lamplight dark({{.position = {0, 1, 0}, .colour = Vec3(0.1F, 0.2F, 0.4F)}});
  const Lamplight bright(
      {{.position = {0, 1, 0}, .colour = srgb_from_linear(4.0F * linear_from_srgb({0.1F, 0.2F, 0.4F}))}});
  const Vec3 light = dark.irradiance(Vec3(0));
  EXPECT_LT(glm::distance(light, bright.irradiance(Vec3(0))), 1e-3F * glm::length(light));
  EXPECT_GT(light.b, 3 * light.g);
  const Vec3 warm = Lamplight({{.position = {0, 1, 0}}}).irradiance(Vec3(0));
  EXPECT_NEAR(light.r + light.g + light.b, warm.r + warm.g + warm.b, 0.01) << "as much light as the usual lamp";
}

TEST(Lamplight, OfASpotStaysInItsCone) {
  const Lamplight lamps({{.position = {0, 1, 0}, .target = Vec3(0), .angle = kPi / 2}});
  const Lamplight all_round({{.position = {0, 1, 0}}});
  EXPECT_EQ(lamps.irradiance({0.5F, 0, 0}), all_round.irradiance({0.5F, 0, 0})) << "27° off the axis";
  EXPECT_EQ(lamps.irradiance({1.2F, 0, 0}), Vec3(0)) << "50° off the axis";
  EXPECT_EQ(lamps.irradiance({0, 2, 0}), Vec3(0)) << "behind the lamp";
}

TEST(Lamplight, OfManySpotsIsDrawnFromThoseThatShineHere) {
  std::vector<Lamp> lamps(4, Lamp{.position = {0, 1, 0}, .target = Vec3(0, 2, 0)});
  lamps.insert(lamps.begin() + 1, Lamp{.position = {0, 1, 0}, .target = Vec3(0)});
  const Lamplight light(lamps);
  EXPECT_NEAR(mean_irradiance(light, Vec3(0)).g, Lamplight({{.position = {0, 1, 0}}}).irradiance(Vec3(0)).g, 1e-3);
  EXPECT_EQ(mean_irradiance(Lamplight(std::vector<Lamp>(3, lamps[0])), Vec3(0)), Vec3(0));
}

TEST(Lamplight, ComesFromAllPointsOfALargeLamp) {
  const Lamplight lamps({{.position = {0, 2, 0}, .target = Vec3(0), .angle = kPi, .radius = 0.5}});
  float farthest = 0;
  for (std::uint32_t s = 0; s < kSamples; ++s) {
    SampleStream samples(3, s, kSamples);
    lamps.for_each_ray(Vec3(0), 0, samples, [&](const Lamplight::Ray& ray) {
      const Vec3 point = ray.distance * ray.toward;
      EXPECT_NEAR(point.y, 2, 1e-4) << "a disc that faces its target";
      farthest = std::max(farthest, glm::length(Vec2(point.x, point.z)));
    });
  }
  EXPECT_NEAR(farthest, 0.5, 0.01);
}

}  // namespace meristem::lamplight_test
