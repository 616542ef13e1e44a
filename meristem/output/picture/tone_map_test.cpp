// SPDX-License-Identifier: Apache-2.0
#include "meristem/output/picture/tone_map.h"

#include <gtest/gtest.h>

#include "meristem/base/colour.h"

namespace meristem::tone_map_test {

TEST(Colour, SrgbAndLinearLightAreInverse) {
  for (int i = 0; i <= 255; ++i) {
    const float value = static_cast<float>(i) / 255;
    EXPECT_NEAR(srgb_from_linear(linear_from_srgb(Vec3(value))).g, value, 1e-6);
  }
  EXPECT_EQ(linear_from_srgb(Vec3(0)), Vec3(0));
  EXPECT_EQ(linear_from_srgb(Vec3(1)), Vec3(1));
}

TEST(Colour, MiddleGreyOfSrgbIsAFifthOfTheLight) { EXPECT_NEAR(linear_from_srgb(Vec3(0.5F)).r, 0.21404, 1e-5); }

TEST(ToneMap, RisesFromBlackToWhiteWithoutTint) {
  EXPECT_EQ(tone_mapped(Vec3(0)), Vec3(0));
  float last = 0;
  for (float light = 0.01F; light < 5; light *= 1.1F) {
    const Vec3 colour = tone_mapped(Vec3(light));
    EXPECT_GT(colour.g, last);
    EXPECT_LE(colour.g, 1);
    EXPECT_NEAR(colour.r, colour.g, 1e-4);
    EXPECT_NEAR(colour.b, colour.g, 1e-4);
    last = colour.g;
  }
  EXPECT_GT(last, 0.99F);
}

TEST(ToneMap, ExposureMakesUpForMostOfTheDusk) {
  const Sky noon({0, radians(60)});
  const Sky dusk({0, radians(1)});
  const auto level = [](const Sky& sky) {
    return exposure(sky) * luminance(sky.dome_irradiance() + sky.sun_direction().y * sky.sun_irradiance());
  };
  EXPECT_GT(exposure(dusk), 2 * exposure(noon));
  EXPECT_LT(level(dusk), level(noon));
  EXPECT_GT(level(dusk), 0.25F * level(noon));
}

TEST(ToneMap, ExposureClosesForLampsByNightAndHardlyByDay) {
  const Sky night({0, radians(-40)});
  const Sky noon({0, radians(60)});
  EXPECT_LT(exposure(night, 0.1F), 0.1F * exposure(night));
  EXPECT_GT(exposure(noon, 0.1F), 0.9F * exposure(noon));
  EXPECT_EQ(exposure(noon, 0), exposure(noon));
}

}  // namespace meristem::tone_map_test
