// SPDX-License-Identifier: Apache-2.0
#include "meristem/base/frame.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/matrix.hpp>
#include <gtest/gtest.h>

#include "meristem/base/random.h"

namespace meristem::frame_test {

constexpr float kTolerance = 1e-6F;
constexpr std::uint64_t kPairs = 2000;

testing::AssertionResult are_near(Vec3 got, Vec3 want, float tolerance = kTolerance) {
  if (glm::length(got - want) <= tolerance) return testing::AssertionSuccess();
  return testing::AssertionFailure() << "(" << got.x << ", " << got.y << ", " << got.z << ") instead of (" << want.x
                                     << ", " << want.y << ", " << want.z << ")";
}

/// Succeeds if the columns are unit, orthogonal and right-handed.
testing::AssertionResult is_rotation(const Mat3& m) {
  const Mat3 product = glm::transpose(m) * m;
  for (int k = 0; k < 3; ++k) {
    if (auto column = are_near(product[k], Mat3(1)[k]); !column) return column << ", column " << k;
  }
  return std::abs(glm::determinant(m) - 1) <= kTolerance
             ? testing::AssertionSuccess()
             : testing::AssertionFailure() << "determinant " << glm::determinant(m);
}

TEST(Rotation, TurnsCounterClockwiseSeenAgainstTheAxis) {
  const Mat3 quarter = rotation(kUp, kPi / 2);
  EXPECT_TRUE(are_near(quarter * Vec3(0, 0, 1), Vec3(1, 0, 0)));
  EXPECT_TRUE(are_near(quarter * Vec3(1, 0, 0), Vec3(0, 0, -1)));
  EXPECT_TRUE(are_near(quarter * kUp, kUp));
}

TEST(Rotation, AnglesAboutOneAxisAdd) {
  for (std::uint64_t k = 0; k < kPairs; ++k) {
    const Vec3 axis = RandomKey(1).direction(k);
    const double a = RandomKey(2).uniform(k, -10, 10);
    const double b = RandomKey(3).uniform(k, -10, 10);
    const Mat3 together = rotation(axis, a) * rotation(axis, b);
    ASSERT_TRUE(is_rotation(together));
    for (int column = 0; column < 3; ++column) {
      EXPECT_TRUE(are_near(together[column], rotation(axis, a + b)[column]));
    }
  }
}

TEST(RotationBetween, TakesOneToTheOtherByTheSmallestTurn) {
  for (std::uint64_t k = 0; k < kPairs; ++k) {
    const Vec3 from = RandomKey(4).direction(k);
    const Vec3 to = RandomKey(5).direction(k);
    const Mat3 m = rotation_between(from, to);
    ASSERT_TRUE(is_rotation(m));
    EXPECT_TRUE(are_near(m * from, to));
    // The smallest turn does not move a vector at right angles to both.
    const Vec3 axis = normalized_or(glm::cross(from, to), kUp);
    EXPECT_TRUE(are_near(m * axis, axis));
  }
}

TEST(RotationBetween, IsARotationForEqualNearlyOppositeAndOppositeVectors) {
  for (std::uint64_t k = 0; k < kPairs; ++k) {
    const Vec3 from = RandomKey(6).direction(k);
    for (const float bend : {0.0F, 1e-7F, 1e-6F, 1e-4F}) {
      const Vec3 nearly_opposite = normalized_or(-from + bend * RandomKey(7).direction(k), kUp);
      const Mat3 m = rotation_between(from, nearly_opposite);
      ASSERT_TRUE(is_rotation(m));
      EXPECT_TRUE(are_near(m * from, nearly_opposite));
    }
    EXPECT_TRUE(are_near(rotation_between(from, from) * RandomKey(8).direction(k), RandomKey(8).direction(k)));
  }
  EXPECT_EQ(rotation_between(kUp, -kUp), rotation_between(kUp, -kUp));
}

TEST(RotationToward, ClosesItsShareOfTheAngle) {
  const Vec3 from = glm::normalize(Vec3(1, 0.2F, -0.4F));
  const Vec3 to = glm::normalize(Vec3(-0.3F, 1, 0.5F));
  const auto angle = [](Vec3 a, Vec3 b) { return std::acos(std::clamp(glm::dot(a, b), -1.0F, 1.0F)); };
  const double whole = angle(from, to);
  for (const double share : {0.0, 0.3, 1.0}) {
    const Vec3 turned = rotation_toward(from, to, share, kUp) * from;
    EXPECT_NEAR(angle(turned, to), (1 - share) * whole, 1e-3);
    const Vec3 away = rotation_toward(from, to, -share, kUp) * from;
    EXPECT_NEAR(angle(away, -to), (1 - share) * (kPi - whole), 1e-3);
  }
  EXPECT_LT(glm::distance(rotation_toward(kUp, -kUp, 0.5, {1, 0, 0}) * kUp, Vec3(0, 0, 1)), 1e-6F);
}

TEST(AnyPerpendicular, IsUnitAndAtRightAnglesEverywhere) {
  const auto check = [](Vec3 direction) {
    const Vec3 side = any_perpendicular(direction);
    EXPECT_NEAR(glm::dot(side, direction), 0, kTolerance);
    EXPECT_NEAR(glm::length(side), 1, kTolerance);
  };
  for (std::uint64_t k = 0; k < kPairs; ++k) {
    const Vec3 direction = RandomKey(9).direction(k);
    check(direction);
    for (const float bend : {1e-7F, 1e-5F, 1e-3F}) check(normalized_or(-kUp + bend * direction, kUp));
  }
  check(kUp);
  check(-kUp);
}

TEST(AnyPerpendicular, IsContinuousAwayFromStraightDown) {
  for (std::uint64_t k = 0; k < kPairs; ++k) {
    const Vec3 direction = RandomKey(10).direction(k);
    if (direction.y < -0.9F) continue;
    const Vec3 near = normalized_or(direction + 1e-3F * RandomKey(11).direction(k), kUp);
    EXPECT_TRUE(are_near(any_perpendicular(near), any_perpendicular(direction), 0.05F));
  }
}

TEST(FrameAlong, HeadsAlongTheVectorWithItsUpperFaceAsNearAsCanBe) {
  for (std::uint64_t k = 0; k < kPairs; ++k) {
    const Vec3 heading = RandomKey(12).direction(k);
    const Vec3 upper = RandomKey(13).direction(k);
    const Frame frame = frame_along(Vec3(1, 2, 3), 5.0F * heading, 0.01F * upper);
    ASSERT_TRUE(is_rotation(frame.axes));
    EXPECT_EQ(frame.origin, Vec3(1, 2, 3));
    EXPECT_TRUE(are_near(frame.heading(), heading));
    EXPECT_NEAR(glm::dot(frame.right(), upper), 0, kTolerance);
    EXPECT_GE(glm::dot(frame.upper(), upper), 0);
  }
}

TEST(FrameAlong, FindsAFrameForVectorsWithoutDirection) {
  const Vec3 nan(std::numeric_limits<float>::quiet_NaN());
  for (const Vec3 heading : {Vec3(0), nan, kUp, -kUp, Vec3(1e-30F, 0, 0)}) {
    for (const Vec3 upper : {Vec3(0), nan, kUp, -kUp, Vec3(1e-8F, 1, 0)}) {
      EXPECT_TRUE(is_rotation(frame_along(Vec3(0), heading, upper).axes));
    }
  }
}

TEST(Frame, DefaultIsTheWorldsOwn) {
  const Frame world;
  EXPECT_EQ(world.heading(), kUp);
  EXPECT_EQ(world.right(), Vec3(1, 0, 0));
  EXPECT_EQ(world.upper(), Vec3(0, 0, 1));
  EXPECT_EQ(world.point(Vec3(1, 2, 3)), Vec3(1, 2, 3));
}

TEST(Frame, ProductsMapPointsOneAfterTheOther) {
  const Frame outer{rotation(Vec3(1, 0, 0), 0.7), Vec3(1, 2, 3)};
  const Frame inner{2.0F * rotation(kUp, -1.1), Vec3(-4, 0, 1)};
  const Vec3 position(0.3F, -0.2F, 0.5F);
  EXPECT_TRUE(are_near((outer * inner).point(position), outer.point(inner.point(position))));
  EXPECT_TRUE(are_near((outer * inner).vector(position), outer.vector(inner.vector(position))));
}

TEST(Frame, NormalsStayAtRightAnglesAndOutsideUnderUnevenScalesAndMirrors) {
  const Vec3 a(1, 0.5F, -0.25F);
  const Vec3 b(-0.5F, 2, 1);
  const Vec3 normal = glm::normalize(glm::cross(a, b));
  for (const Vec3 scale : {Vec3(1, 1, 1), Vec3(3, 0.1F, 1), Vec3(-1, 1, 1), Vec3(-2, -1, 5), Vec3(-1, -1, -1)}) {
    Frame frame{rotation(glm::normalize(Vec3(1, 2, 3)), 1.3), Vec3(5, 6, 7)};
    for (int k = 0; k < 3; ++k) frame.axes[k] *= scale[k];
    const Vec3 turned = frame.normal(normal);
    EXPECT_NEAR(glm::length(turned), 1, kTolerance);
    EXPECT_NEAR(glm::dot(turned, frame.vector(a)), 0, 1e-5);
    EXPECT_NEAR(glm::dot(turned, frame.vector(b)), 0, 1e-5);
    // A point outside of the surface is mapped to a point outside.
    EXPECT_GT(glm::dot(turned, frame.vector(normal)), 0);
  }
}

TEST(NormalizedOr, FallsBackWhereThereIsNoDirection) {
  const Vec3 fallback(0, 0, 1);
  const float infinity = std::numeric_limits<float>::infinity();
  EXPECT_EQ(normalized_or(Vec3(0), fallback), fallback);
  EXPECT_EQ(normalized_or(Vec3(1e-21F, 0, 0), fallback), fallback);
  EXPECT_EQ(normalized_or(Vec3(infinity, 0, 0), fallback), fallback);
  EXPECT_EQ(normalized_or(Vec3(0, std::nanf(""), 0), fallback), fallback);
  EXPECT_TRUE(are_near(normalized_or(Vec3(3, 0, 4), fallback), Vec3(0.6F, 0, 0.8F)));
  EXPECT_TRUE(are_near(normalized_or(Vec3(1e-19F, 0, 0), fallback), Vec3(1, 0, 0)));
  EXPECT_TRUE(are_near(normalized_or(Vec3(3e38F, 0, 3e38F), fallback), Vec3(std::sqrt(0.5F), 0, std::sqrt(0.5F))));
}

}  // namespace meristem::frame_test
