// SPDX-License-Identifier: Apache-2.0
#include "meristem/base/colour.h"

#include <cmath>

#include <gtest/gtest.h>

namespace meristem::colour_test {

TEST(Colour, BlackAndWhiteStayAsTheyAre) {
  EXPECT_EQ(linear_from_srgb(Vec3(0)), Vec3(0));
  EXPECT_EQ(linear_from_srgb(Vec3(1)), Vec3(1));
  EXPECT_EQ(srgb_from_linear(Vec3(0)), Vec3(0));
  EXPECT_EQ(srgb_from_linear(Vec3(1)), Vec3(1));
}

// IEC 61966-2-1: 0.735 encodes half of the light, and values up to 0.04045 are proportional to light.
TEST(Colour, FollowsTheTransferFunctionOfSrgb) {
  EXPECT_NEAR(linear_from_srgb(Vec3(0.7353570F)).r, 0.5, 1e-6);
  EXPECT_NEAR(linear_from_srgb(Vec3(0.02F)).g, 0.02 / 12.92, 1e-8);
  EXPECT_NEAR(srgb_from_linear(Vec3(0.001F)).b, 0.01292, 1e-8);
}

TEST(Colour, EachChannelComesBack) {
  for (int k = 0; k <= 255; ++k) {
    const Vec3 colour(static_cast<float>(k) / 255, 0.5F, 1 - static_cast<float>(k) / 255);
    const Vec3 back = srgb_from_linear(linear_from_srgb(colour));
    for (int channel = 0; channel < 3; ++channel) EXPECT_NEAR(back[channel], colour[channel], 1e-6) << k;
    EXPECT_EQ(byte_from_srgb(back.r), k);
  }
}

TEST(Colour, ValuesOutsideAreClamped) {
  EXPECT_EQ(linear_from_srgb({-1, 2, 1}), Vec3(0, 1, 1));
  EXPECT_EQ(srgb_from_linear({-1, 2, 0}), Vec3(0, 1, 0));
  EXPECT_EQ(byte_from_srgb(-0.2F), 0);
  EXPECT_EQ(byte_from_srgb(1.2F), 255);
}

TEST(Colour, GreenLooksBrightestAndWhiteHasALuminanceOf1) {
  EXPECT_NEAR(luminance(Vec3(1)), 1, 1e-6);
  EXPECT_GT(luminance({0, 1, 0}), luminance({1, 0, 0}));
  EXPECT_GT(luminance({1, 0, 0}), luminance({0, 0, 1}));
}

}  // namespace meristem::colour_test
