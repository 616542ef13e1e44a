// SPDX-License-Identifier: Apache-2.0
#include "meristem/scene/crown/crown.h"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "meristem/base/random.h"
#include "meristem/scene/crown/combined_crown.h"
#include "meristem/scene/crown/placed_crown.h"
#include "meristem/scene/crown/profile_crown.h"
#include "meristem/scene/crown/solid_crowns.h"

namespace meristem::crown_test {

// Two points make a straight spline: a cylinder or a cone.
const ProfileCrown::Profile kCylinder{{0.5F, 1}, {0.5F, 3}};
const ProfileCrown::Profile kRoundCrown{{0, 0.4F}, {0.96F, 1.42F}, {1.6F, 2.61F}, {0, 3.8F}};

// Calls `see` with points spread over a cube around the origin.
template <class See>
void for_points_around(float reach, See see) {
  const RandomKey key(3);
  for (std::uint64_t k = 0; k < 20'000; ++k) {
    const DVec3 share(key.uniform(k, 0), key.uniform(k, 1), key.child(1).uniform(k));
    see(Vec3((2.0 * share - 1.0) * static_cast<double>(reach)));
  }
}

void expect_bounds_hold(const Crown& crown, float reach) {
  const Box box = crown.bounds();
  std::size_t inside = 0;
  for_points_around(reach, [&](Vec3 point) {
    if (!crown.contains(point)) return;
    ++inside;
    ASSERT_TRUE(glm::clamp(point, box.low, box.high) == point) << point.x << ' ' << point.y << ' ' << point.z;
  });
  EXPECT_GT(inside, 50U);
}

TEST(ProfileCrown, ThreePointsMakeTheNaturalSpline) {
  // The natural spline through (0, 0), (1, 1), (2, 0) is f(y) = 1.5 y - 0.5 y^3 up to the middle, and mirrored beyond.
  const ProfileCrown crown(ProfileCrown::Profile{{0, 0}, {1, 1}, {0, 2}});
  for (const double y : {0.1, 0.4, 0.9}) {
    EXPECT_NEAR(crown.radius_at(y), 1.5 * y - 0.5 * y * y * y, 1e-6);
    EXPECT_NEAR(crown.radius_at(2 - y), crown.radius_at(y), 1e-6);
  }
}

TEST(ProfileCrown, RadiusIsZeroOutsideAndWhereTheSplineIsNegative) {
  const ProfileCrown crown(ProfileCrown::Profile{{0, 0}, {1, 1}, {0, 2}, {0, 3}, {1, 4}});
  EXPECT_EQ(crown.radius_at(-0.1), 0);
  EXPECT_EQ(crown.radius_at(4.1), 0);
  EXPECT_EQ(crown.radius_at(2.5), 0);
  EXPECT_GT(crown.radius_at(0.5), 0);
  EXPECT_FALSE(crown.contains({0.1F, 2.5F, 0}));
}

TEST(ProfileCrown, BoundsHoldWhereTheSplineSwingsOut) {
  const ProfileCrown crown(ProfileCrown::Profile{{0, -1}, {2, -0.5F}, {2, 0.5F}, {0, 1}});
  EXPECT_GT(crown.radius_at(0), 2.1);
  expect_bounds_hold(crown, 3);
  EXPECT_GE(crown.bounds().high.x, crown.radius_at(0));
  EXPECT_LT(crown.bounds().high.x, 1.02 * crown.radius_at(0));
}

TEST(ProfileCrown, OneProfileIsTheSameAllAround) {
  const ProfileCrown crown(kRoundCrown);
  const ProfileCrown four(ProfileCrown::Sides{{0, kRoundCrown}, {1, kRoundCrown}, {3, kRoundCrown}, {4, kRoundCrown}});
  for (double azimuth = -7; azimuth < 7; azimuth += 0.37) {
    EXPECT_EQ(crown.radius_at(2, azimuth), crown.radius_at(2));
    EXPECT_NEAR(four.radius_at(2, azimuth), crown.radius_at(2), 1e-12);
  }
}

TEST(ProfileCrown, RadiusGoesEvenlyFromAzimuthToAzimuthAndOnToTheFirst) {
  const auto wide = [](float radius) { return ProfileCrown::Profile{{radius, 0}, {radius, 2}}; };
  const ProfileCrown crown(
      ProfileCrown::Sides{{radians(300), wide(3)}, {radians(60), wide(1)}, {radians(150), wide(2)}});
  const auto at = [&](double degrees) { return crown.radius_at(1, radians(degrees)); };
  EXPECT_NEAR(at(60), 1, 1e-9);
  EXPECT_NEAR(at(105), 1.5, 1e-9);
  EXPECT_NEAR(at(225), 2.5, 1e-9);
  EXPECT_NEAR(at(330), 2.5, 1e-9);
  EXPECT_NEAR(at(0), 2, 1e-9);
  EXPECT_NEAR(at(30), 1.5, 1e-9);
  for (double degrees = 0; degrees < 360; degrees += 7) {
    EXPECT_NEAR(at(degrees), at(degrees + 720), 1e-9);
    EXPECT_NEAR(at(degrees), at(degrees - 360), 1e-9);
  }
  expect_bounds_hold(crown, 4);
}

TEST(ProfileCrown, AzimuthsGoFromNorthOverEast) {
  const auto wide = [](float radius) { return ProfileCrown::Profile{{radius, 0}, {radius, 2}}; };
  const ProfileCrown crown(
      ProfileCrown::Sides{{0, wide(1)}, {radians(90), wide(2)}, {radians(180), wide(3)}, {radians(270), wide(4)}});
  EXPECT_TRUE(crown.contains({0, 1, -0.99F}));
  EXPECT_FALSE(crown.contains({0, 1, -1.01F}));
  EXPECT_TRUE(crown.contains({1.99F, 1, 0}));
  EXPECT_FALSE(crown.contains({2.01F, 1, 0}));
  EXPECT_TRUE(crown.contains({0, 1, 2.99F}));
  EXPECT_FALSE(crown.contains({0, 1, 3.01F}));
  EXPECT_TRUE(crown.contains({-3.99F, 1, 0}));
  EXPECT_FALSE(crown.contains({-4.01F, 1, 0}));
}

TEST(ProfileCrown, RejectsFallingHeightsEmptyProfilesAndDoubledAzimuths) {
  using Profile = ProfileCrown::Profile;
  EXPECT_THROW(ProfileCrown(Profile{}), std::invalid_argument);
  EXPECT_THROW(ProfileCrown(Profile{{1, 0}}), std::invalid_argument);
  EXPECT_THROW(ProfileCrown(Profile{{1, 0}, {1, 2}, {0, 1}}), std::invalid_argument);
  EXPECT_THROW(ProfileCrown(Profile{{1, 0}, {1, 0}}), std::invalid_argument);
  EXPECT_THROW(ProfileCrown(ProfileCrown::Sides{}), std::invalid_argument);
  EXPECT_THROW(ProfileCrown(ProfileCrown::Sides{{0.5, kCylinder}, {0.5, kCylinder}}), std::invalid_argument);
  EXPECT_TRUE(ProfileCrown(Profile{{0, 0}, {0, 1}}).bounds().is_empty());
}

TEST(EllipsoidCrown, ContainsWhatIsWithinItsRadii) {
  const EllipsoidCrown crown({1, 3, 0}, {1, 2, 0.5F});
  EXPECT_TRUE(crown.contains({1, 3, 0}));
  EXPECT_TRUE(crown.contains({1, 4.99F, 0}));
  EXPECT_FALSE(crown.contains({1, 5.01F, 0}));
  EXPECT_TRUE(crown.contains({1.99F, 3, 0}));
  EXPECT_FALSE(crown.contains({1, 3, 0.51F}));
  EXPECT_FALSE(crown.contains({1.8F, 4.8F, 0}));
  expect_bounds_hold(crown, 6);
  EXPECT_FALSE(EllipsoidCrown(Vec3(0), {1, 0, 1}).contains(Vec3(0)));
}

TEST(ConeCrown, NarrowsToItsApex) {
  const ConeCrown crown({0, 1, 0}, 1, 2);
  EXPECT_TRUE(crown.contains({0.99F, 1, 0}));
  EXPECT_FALSE(crown.contains({0, 0.99F, 0}));
  EXPECT_TRUE(crown.contains({0, 2, 0.49F}));
  EXPECT_FALSE(crown.contains({0, 2, 0.51F}));
  EXPECT_TRUE(crown.contains({0, 3, 0}));
  EXPECT_FALSE(crown.contains({0, 3.01F, 0}));
  expect_bounds_hold(crown, 4);
}

TEST(CylinderCrown, IsAsWideAboveAsBelow) {
  const CylinderCrown crown({1, 1, 0}, 0.5, 2);
  EXPECT_TRUE(crown.contains({1.49F, 1, 0}));
  EXPECT_TRUE(crown.contains({1, 3, -0.49F}));
  EXPECT_FALSE(crown.contains({1.36F, 2, 0.36F}));
  EXPECT_FALSE(crown.contains({1, 3.01F, 0}));
  expect_bounds_hold(crown, 4);
}

TEST(PyramidCrown, HasASquareAtEachHeight) {
  const PyramidCrown crown({0, 1, 0}, 2, 2);
  EXPECT_TRUE(crown.contains({0.99F, 1, -0.99F}));
  EXPECT_TRUE(crown.contains({0.49F, 2, 0.49F}));
  EXPECT_FALSE(crown.contains({0.51F, 2, 0}));
  EXPECT_TRUE(crown.contains({0, 3, 0}));
  EXPECT_FALSE(crown.contains({0, 0.99F, 0}));
  expect_bounds_hold(crown, 4);
}

TEST(HalfSpaceCrown, EndsAtItsPlaneAlone) {
  const HalfSpaceCrown crown({0, 1, 0}, {0, 3, 0});
  EXPECT_TRUE(crown.contains({1000, 1, -1000}));
  EXPECT_FALSE(crown.contains({0, 1.01F, 0}));
  EXPECT_TRUE(is_endless(crown));
  const CombinedCrown cut(CombineKind::intersect, {std::make_shared<BoxCrown>(Box{Vec3(-1), Vec3(2)}),
                                                   std::make_shared<HalfSpaceCrown>(crown)});
  EXPECT_FALSE(is_endless(cut));
  EXPECT_TRUE(cut.is_convex());
}

TEST(Crown, ReachesToItsBoundary) {
  const EllipsoidCrown ball(Vec3(0), Vec3(1));
  EXPECT_NEAR(ball.reach(Vec3(0), {4, 0, 0}), 0.25F, 1e-4);
  EXPECT_TRUE(ball.contains(ball.reach(Vec3(0), {0, 4, 0}) * Vec3(0, 4, 0)));
  EXPECT_EQ(ball.reach(Vec3(0), {0, 0.99F, 0}), 1);
  EXPECT_EQ(ball.reach({0, 2, 0}, Vec3(0)), 0);
}

TEST(Crown, ReachesTheFirstGapOfACrownThatIsNotConvex) {
  const auto ball = [](float x) { return std::make_shared<EllipsoidCrown>(Vec3(x, 0, 0), Vec3(1)); };
  const CombinedCrown two(CombineKind::unite, {ball(0), ball(3)});
  EXPECT_FALSE(two.is_convex());
  EXPECT_NEAR(two.reach(Vec3(0), {3, 0, 0}), 1.0F / 3, 1e-4);
}

TEST(PlacedCrown, MovesItsCrown) {
  const PlacedCrown moved(std::make_shared<EllipsoidCrown>(Vec3(0), Vec3(1)), Frame{2.0F * Mat3(1), {10, 0, 0}});
  EXPECT_TRUE(moved.contains({11.9F, 0, 0}));
  EXPECT_FALSE(moved.contains({0, 0, 0}));
  EXPECT_NEAR(moved.bounds().high.x, 12, 1e-3);
}

TEST(CombinedCrown, ContainsWhatSetTheorySays) {
  const auto a = std::make_shared<EllipsoidCrown>(Vec3(0), Vec3(1));
  const auto b = std::make_shared<BoxCrown>(Box{Vec3(0), Vec3(1.5F)});
  const auto c = std::make_shared<EllipsoidCrown>(Vec3(0.5F, 0, 0), Vec3(0.6F));
  const CombinedCrown any(CombineKind::unite, {a, b, c});
  const CombinedCrown all(CombineKind::intersect, {a, b, c});
  const CombinedCrown without(CombineKind::subtract, {a, b, c});
  for_points_around(2, [&](Vec3 point) {
    const bool in_a = a->contains(point);
    const bool in_b = b->contains(point);
    const bool in_c = c->contains(point);
    ASSERT_EQ(any.contains(point), in_a || in_b || in_c);
    ASSERT_EQ(all.contains(point), in_a && in_b && in_c);
    ASSERT_EQ(without.contains(point), in_a && !in_b && !in_c);
  });
  expect_bounds_hold(any, 2);
  expect_bounds_hold(all, 1.2F);
  expect_bounds_hold(without, 2);
}

TEST(CombinedCrown, CrownsThatDoNotMeetIntersectInNothing) {
  const auto a = std::make_shared<EllipsoidCrown>(Vec3(0), Vec3(1));
  const auto b = std::make_shared<EllipsoidCrown>(Vec3(3, 0, 0), Vec3(1));
  const CombinedCrown none(CombineKind::intersect, {a, b});
  EXPECT_TRUE(none.bounds().is_empty());
  EXPECT_FALSE(none.contains({1, 0, 0}));
  const CombinedCrown nested(CombineKind::unite, {std::make_shared<CombinedCrown>(none), a});
  EXPECT_TRUE(nested.contains({0.5F, 0, 0}));
  EXPECT_EQ(nested.bounds().low.x, a->bounds().low.x);
}

TEST(PlacedCrown, HoldsWhatItsCrownHoldsBeforeItTurns) {
  const auto crown = std::make_shared<ProfileCrown>(kRoundCrown);
  const Mat3 axes = 0.4F * Mat3(Vec3(0, 0, 1), Vec3(0.6F, 0.8F, 0), Vec3(-0.8F, 0.6F, 0));
  const PlacedCrown turned(crown, Frame{axes});
  for_points_around(4, [&](Vec3 point) {
    if (turned.contains(axes * point) != crown->contains(point)) {
      // Only rounding may cause a difference.
      EXPECT_NE(crown->contains(0.9999F * point), crown->contains(1.0001F * point));
    }
  });
  expect_bounds_hold(turned, 1.7F);
}

TEST(CombinedCrown, RejectsNothingToCombine) {
  EXPECT_THROW(CombinedCrown(CombineKind::unite, {}), std::invalid_argument);
  EXPECT_THROW(CombinedCrown(CombineKind::unite, {nullptr}), std::invalid_argument);
}

}  // namespace meristem::crown_test
