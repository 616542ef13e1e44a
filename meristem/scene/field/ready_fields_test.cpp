// SPDX-License-Identifier: Apache-2.0
#include "meristem/scene/field/ready_fields.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "meristem/scene/directions.h"

namespace meristem::ready_fields_test {

constexpr double kForEver = std::numeric_limits<double>::infinity();

void expect_near(Vec3 found, Vec3 expected) {
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(found[k], expected[k], 1e-5) << k;
}

TEST(PointField, LeadsToItsPointAndIsHalfAsStrongAtItsReach) {
  const PointField far({0, 2, 0}, kForEver);
  expect_near(far.at({3, 2, 0}), {-1, 0, 0});
  expect_near(far.at({0, -100, 0}), {0, 1, 0});
  expect_near(PointField({0, 2, 0}, 4).at({4, 2, 0}), {-0.5, 0, 0});
  EXPECT_EQ(far.at({0, 2, 0}), Vec3(0));
}

TEST(CylinderField, IsInwardOutsideAndOutwardInsideAndNothingOnTheSurface) {
  const CylinderField pole({}, 0.5, 0.25);
  expect_near(pole.at({2, 7, 0}), {-1, 0, 0});
  expect_near(pole.at({0, -7, 0.25}), {0, 0, 1});
  expect_near(pole.at({0.3F, 0, 0.4F}), {0, 0, 0});
  expect_near(pole.at({0.625F, 0, 0}), {-0.5, 0, 0});
  EXPECT_EQ(pole.at({0, 1, 0}), Vec3(0));
}

TEST(VortexField, GoesRoundItsAxisCounterClockwise) {
  const VortexField vortex({}, 0.5);
  expect_near(vortex.at({2, 5, 0}), {0, 0, -1});
  expect_near(vortex.at({0, 5, -2}), {-1, 0, 0});
  expect_near(vortex.at({0.25F, 0, 0}), {0, 0, -0.5});
  EXPECT_EQ(vortex.at({0, 3, 0}), Vec3(0));
}

TEST(WindField, GustsHaveAMeanOfNothingAndDriftWithTheWind) {
  const WindGusts gusts{.share = 0.5, .size = 2, .key = RandomKey(3)};
  const WindField wind({1, 0, 0}, gusts);
  DVec3 sum(0);
  for (int k = 0; k < 4000; ++k) sum += DVec3(wind.at({0.37F * k, 1.3F, 0.7F}));
  EXPECT_NEAR(sum.x / 4000, 1, 0.05);
  EXPECT_NEAR(sum.y / 4000, 0, 0.05);
  WindGusts later = gusts;
  later.drift = 3;
  expect_near(WindField({1, 0, 0}, later).at({4.2F, 1, 0.3F}), wind.at({1.2F, 1, 0.3F}));
  EXPECT_EQ(WindField({1, 0, 0}, {}).at({1, 2, 3}), Vec3(1, 0, 0));
}

TEST(PlacedField, IsTurnedMovedAndScaledInItsPlacesAlone) {
  const auto pole = std::make_shared<CylinderField>(FieldAxis{}, 0.5, 0.25);
  Frame frame{2.0F * rotation({0, 0, 1}, kPi / 2), {0, 10, 0}};  // axis along -x, radius 1
  const PlacedField placed(pole, frame, 3);
  expect_near(placed.at({7, 15, 0}), {0, -3, 0});
  expect_near(placed.at({-7, 10, 0.5F}), {0, 0, 3});
  expect_near(placed.at({0, 11.25F, 0}), {0, -1.5, 0});
}

TEST(Sense, FieldsAddToTheScenesOwnOrTakeItsPlace) {
  const auto east = std::make_shared<UniformField>(Vec3(2, 0, 0));
  const FieldSense scene(kUp);
  EXPECT_EQ(scene.at({1, 2, 3}).toward, kUp);
  EXPECT_EQ(scene.given_at({1, 2, 3}), Vec3(0));
  const FieldSense replaced = scene.with(east, false);
  EXPECT_TRUE(replaced.is_uniform());
  expect_near(replaced.at(Vec3(0)).toward, {1, 0, 0});
  EXPECT_FLOAT_EQ(replaced.at(Vec3(0)).strength, 2);
  const FieldSense added = scene.with(east, true).with(std::make_shared<UniformField>(Vec3(0, 0, 2)), true);
  expect_near(added.at(Vec3(0)).vector(), {2, 1, 2});
  expect_near(added.given_at(Vec3(0)), {2, 0, 2});
  expect_near(replaced.with(east, true).at(Vec3(0)).vector(), {4, 0, 0});
  const FieldSense point = scene.with(std::make_shared<PointField>(Vec3(0), kForEver), true);
  EXPECT_FALSE(point.is_uniform());
  expect_near(point.at({0, -5, 0}).vector(), {0, 2, 0});
  EXPECT_EQ(point.at({0, 5, 0}).toward, Vec3(0));  // one field pulls up, the other down
  EXPECT_EQ(point.at({0, 5, 0}).strength, 0);
}

TEST(Directions, FieldsTellPositionsApart) {
  const Directions plain;
  const Directions uniform =
      plain.with(plain.light_sense().with(std::make_shared<UniformField>(Vec3(1, 0, 0)), false), plain.gravity_sense());
  EXPECT_EQ(uniform.key_at({1, 2, 3}), uniform.key_at({3, 2, 1}));
  EXPECT_NE(uniform.key_at({1, 2, 3}), plain.key_at({1, 2, 3}));
  const Directions vortex = plain.with(
      plain.light_sense(), plain.gravity_sense().with(std::make_shared<VortexField>(FieldAxis{}, 0.1), true));
  EXPECT_NE(vortex.key_at({1, 2, 0}), vortex.key_at({2, 2, 0}));
}

TEST(Pulling, TwoTurnsOfStrengthOneAreOneOfStrengthTwo) {
  EXPECT_EQ(share_pulled(0.3, 1), 0.3);
  EXPECT_NEAR(share_pulled(0.3, 2), 1 - 0.7 * 0.7, 1e-12);
  EXPECT_NEAR(share_pulled(-0.3, 2), -(1 - 0.7 * 0.7), 1e-12);
  EXPECT_EQ(share_pulled(0.3, 0), 0);
  EXPECT_EQ(share_pulled(1, 0.5), 1);
}

}  // namespace meristem::ready_fields_test
