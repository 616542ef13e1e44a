// SPDX-License-Identifier: Apache-2.0
#include "meristem/scene/view.h"

#include <limits>

#include <gtest/gtest.h>

#include "meristem/base/math.h"

namespace meristem::view_test {

TEST(ViewSeenFrom, ReplacesThePlaceOfTheCameraAlone) {
  CameraView view;
  view.position = Vec3(1, 2, 3);
  view.target = Vec3(4, 5, 6);
  view.field_of_view = 1;
  const auto east = seen_from(view, 90, -89);
  ASSERT_TRUE(east);
  EXPECT_FALSE(east->position);
  EXPECT_EQ(east->azimuth, radians(90));
  EXPECT_EQ(east->altitude, radians(-89));
  EXPECT_EQ(east->target, view.target);
  EXPECT_EQ(east->field_of_view, 1);
}

TEST(ViewSeenFrom, KnowsNoOtherAngles) {
  EXPECT_TRUE(seen_from(CameraView(), -360, 89));
  EXPECT_FALSE(seen_from(CameraView(), 360.001, 0));
  EXPECT_FALSE(seen_from(CameraView(), 0, -89.001));
  EXPECT_FALSE(seen_from(CameraView(), std::numeric_limits<double>::quiet_NaN(), 0));
  EXPECT_FALSE(seen_from(CameraView(), 0, std::numeric_limits<double>::infinity()));
}

TEST(TurnedView, MovesTheCameraFromNorthOverEast) {
  CameraView view;
  view.position = Vec3(0, 2, -5);  // north of the root
  const CameraView east = turned(view, Vec3(0, 1, 0), kPi / 2);
  EXPECT_NEAR(glm::distance(*east.position, Vec3(5, 2, 0)), 0, 1e-5F);
  EXPECT_DOUBLE_EQ(east.azimuth, view.azimuth + kPi / 2);
  view.target = Vec3(1, 0, 0);
  EXPECT_NEAR(glm::distance(*turned(view, Vec3(9, 9, 9), kPi).position, Vec3(2, 2, 5)), 0, 1e-5F);
}

TEST(TurnedView, AWholeTurnIsNone) {
  CameraView view;
  view.position = Vec3(1, 2, 3);
  EXPECT_NEAR(glm::distance(*turned(view, Vec3(0), 2 * kPi).position, *view.position), 0, 1e-5F);
  EXPECT_FALSE(turned(CameraView(), Vec3(0), 1).position.has_value());
}

}  // namespace meristem::view_test
