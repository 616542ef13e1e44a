// SPDX-License-Identifier: Apache-2.0
#include "meristem/output/picture/lamplight.h"

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

}  // namespace meristem::lamplight_test
