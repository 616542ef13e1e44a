// SPDX-License-Identifier: Apache-2.0
#include "meristem/scene/light/sky.h"

#include <cmath>

#include <gtest/gtest.h>

namespace meristem::sky_test {

float luminance(Vec3 light) { return 0.2126F * light.r + 0.7152F * light.g + 0.0722F * light.b; }

Sky sky_at(double altitude_deg) { return Sky({radians(180), radians(altitude_deg)}); }

TEST(Sky, LightsAWhiteSurfaceFacingTheSunAt45DegreesToAboutOne) {
  const Sky sky = sky_at(45);
  // The surface sees most of the dome, and half of it at twice the steepness. The dome's light on level ground is close
  // enough.
  const float radiance = luminance(sky.sun_irradiance() + sky.dome_irradiance()) / static_cast<float>(kPi);
  EXPECT_NEAR(radiance, 1, 0.05);
}

TEST(Sky, DomeIrradianceIsTheIntegralOfItsRadiance) {
  const Sky sky = sky_at(30);
  DVec3 sum(0);
  constexpr int kSteps = 400;
  for (int i = 0; i < kSteps; ++i) {
    const double altitude = (i + 0.5) / kSteps * kPi / 2;
    for (int j = 0; j < kSteps; ++j) {
      const double azimuth = (j + 0.5) / kSteps * 2 * kPi;
      const double weight = std::sin(altitude) * std::cos(altitude) * (kPi / 2 / kSteps) * (2 * kPi / kSteps);
      sum += weight * DVec3(sky.radiance(unit_vector({azimuth, altitude})));
    }
  }
  EXPECT_NEAR(sum.r, sky.dome_irradiance().r, 0.02 * sum.r);
  EXPECT_NEAR(sum.g, sky.dome_irradiance().g, 0.02 * sum.g);
  EXPECT_NEAR(sum.b, sky.dome_irradiance().b, 0.02 * sum.b);
}

TEST(Sky, IsBlueOverheadAndPalerAtTheHorizon) {
  const Sky sky = sky_at(50);
  const Vec3 zenith = sky.radiance(kUp);
  const Vec3 horizon = sky.radiance({0, 0, -1});
  EXPECT_GT(zenith.b, 2 * zenith.r);
  EXPECT_GT(horizon.r / horizon.b, 1.3F * zenith.r / zenith.b);
}

TEST(Sky, IsBrightestAboutTheSun) {
  const Sky sky = sky_at(40);
  const float at_sun = luminance(sky.radiance(sky.sun_direction()));
  for (int azimuth_deg = 0; azimuth_deg < 360; azimuth_deg += 15) {
    for (int altitude_deg = 5; altitude_deg < 90; altitude_deg += 10) {
      EXPECT_LE(luminance(sky.radiance(unit_vector({radians(azimuth_deg), radians(altitude_deg)}))), at_sun);
    }
  }
}

TEST(Sky, SunReddensAndDimsTowardsTheHorizon) {
  double last_redness = 0;
  double last_brightness = 1e9;
  for (const double altitude_deg : {80.0, 45.0, 20.0, 8.0, 2.0}) {
    const Vec3 sun = sky_at(altitude_deg).sun_irradiance();
    EXPECT_GT(sun.r / sun.b, last_redness) << altitude_deg;
    EXPECT_LT(luminance(sun), last_brightness) << altitude_deg;
    last_redness = sun.r / sun.b;
    last_brightness = luminance(sun);
  }
}

TEST(Sky, LeavesOnlyADimDomeAfterSunset) {
  const Sky sky = sky_at(-5);
  EXPECT_EQ(sky.sun_irradiance(), Vec3(0));
  EXPECT_GT(luminance(sky.dome_irradiance()), 0);
  EXPECT_LT(luminance(sky.dome_irradiance()), 0.1F * luminance(sky_at(5).dome_irradiance()));
}

TEST(Sky, DoesNotJumpAtSunset) {
  for (const double altitude_deg : {-1.0, -0.5, 0.0, 0.5, 1.0}) {
    const Vec3 before = sky_at(altitude_deg - 0.005).radiance({1, 0.3F, 1});
    const Vec3 after = sky_at(altitude_deg + 0.005).radiance({1, 0.3F, 1});
    EXPECT_LT(glm::length(after - before), 0.25F * glm::length(after)) << altitude_deg;
  }
}

TEST(Sky, HasTheHorizonsLightBelowIt) {
  const Sky sky = sky_at(30);
  EXPECT_EQ(sky.radiance({3, 0, 4}), sky.radiance({3, -2, 4}));
}

}  // namespace meristem::sky_test
