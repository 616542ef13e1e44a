// SPDX-License-Identifier: Apache-2.0
#include "meristem/shape/implicit/implicit_body.h"

#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include "meristem/base/random.h"

namespace meristem::implicit_body_test {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

DVec3 random_position(const RandomKey& key, std::uint64_t index, double reach) {
  const RandomKey at = key.child(index);
  return {at.uniform(0, -reach, reach), at.uniform(1, -reach, reach), at.uniform(2, -reach, reach)};
}

double nearest_of(const std::vector<DVec3>& surface, DVec3 position) {
  double nearest = kInfinity;
  for (const DVec3 point : surface) nearest = std::min(nearest, squared_length(point - position));
  return std::sqrt(nearest);
}

/// Expects that values at random positions are distances to the surface, negative inside. The points of the surface are
/// at most `step` metres apart.
void expect_distances(const ImplicitBody& body, const std::vector<DVec3>& surface, double step, double reach,
                      const std::function<bool(DVec3)>& is_inside) {
  for (const DVec3 point : surface) ASSERT_NEAR(body.value(point), 0, 1e-9);
  const RandomKey key(3);
  for (std::uint64_t k = 0; k < 60; ++k) {
    const DVec3 position = random_position(key, k, reach);
    const double value = body.value(position);
    const double nearest = nearest_of(surface, position);
    EXPECT_LE(std::abs(value), nearest + 1e-9) << position.x << " " << position.y << " " << position.z;
    EXPECT_GE(value * value, nearest * nearest - step * step) << position.x << " " << position.y << " " << position.z;
    EXPECT_EQ(value < 0, is_inside(position)) << position.x << " " << position.y << " " << position.z;
  }
}

std::vector<DVec3> ellipsoid_points(DVec3 radii, int rows) {
  std::vector<DVec3> points;
  for (int i = 0; i <= rows; ++i) {
    for (int j = 0; j < 2 * rows; ++j) {
      const double a = kPi * i / rows;
      const double b = kPi * j / rows;
      points.push_back(radii * DVec3(std::sin(a) * std::cos(b), std::cos(a), std::sin(a) * std::sin(b)));
    }
  }
  return points;
}

/// Returns a profile in the half-plane (across, along), revolved about y.
std::vector<DVec3> revolved(const std::vector<std::array<double, 2>>& profile, int columns) {
  std::vector<DVec3> points;
  for (const auto& [across, along] : profile) {
    for (int j = 0; j < columns; ++j) {
      const double angle = 2 * kPi * j / columns;
      points.emplace_back(across * std::cos(angle), along, across * std::sin(angle));
    }
  }
  return points;
}

Vec3 vec(double x, double y, double z) { return {static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)}; }

TEST(ImplicitBody, ValuesOfASphereAreDistances) {
  const ImplicitBody ball = ImplicitBody::sphere({1, 2, 3}, 0.5);
  EXPECT_DOUBLE_EQ(ball.value({1, 2, 3}), -0.5);
  EXPECT_DOUBLE_EQ(ball.value({1, 2.5, 3}), 0);
  EXPECT_DOUBLE_EQ(ball.value({4, 2, 7}), 4.5);
}

TEST(ImplicitBody, ValuesOfACapsuleAreDistances) {
  const ImplicitBody capsule = ImplicitBody::capsule({0, 0, 0}, {0, 2, 0}, 0.25);
  EXPECT_DOUBLE_EQ(capsule.value({1, 1, 0}), 0.75);
  EXPECT_DOUBLE_EQ(capsule.value({0, 3, 0}), 0.75);
  EXPECT_DOUBLE_EQ(capsule.value({0, 1.5, 0}), -0.25);
  EXPECT_DOUBLE_EQ(capsule.value({0, -3, 4}), 4.75);
}

TEST(ImplicitBody, ValuesOfARoundConeAreDistances) {
  // A point of a ball around the axis counts if it lies in no other ball.
  const auto radius = [](double along) { return 0.8 - 0.3 * along; };
  const auto by_balls = [&](double across, double along) {
    double min = kInfinity;
    for (int k = 0; k <= 1000; ++k) {
      min = std::min(min, std::hypot(across, along - 0.002 * k) - radius(0.002 * k));
    }
    return min;
  };
  std::vector<std::array<double, 2>> profile;
  const double flank = std::asin(0.3);
  for (int k = 0; k <= 100; ++k) {
    const double below = -kPi / 2 + (kPi / 2 + flank) * 0.01 * k;
    const double above = flank + (kPi / 2 - flank) * 0.01 * k;
    profile.push_back({0.8 * std::cos(below), 0.8 * std::sin(below)});
    profile.push_back({0.2 * std::cos(above), 2 + 0.2 * std::sin(above)});
    profile.push_back({radius(0.02 * k) * std::cos(flank), 0.02 * k + radius(0.02 * k) * std::sin(flank)});
  }
  for (const ImplicitBody& cone : {ImplicitBody::round_cone({0, 0, 0}, 0.8, {0, 2, 0}, 0.2),
                                   ImplicitBody::round_cone({0, 2, 0}, 0.2, {0, 0, 0}, 0.8)}) {
    expect_distances(cone, revolved(profile, 100), 0.06, 3,
                     [&](DVec3 p) { return by_balls(std::hypot(p.x, p.z), p.y) < 0; });
  }
}

TEST(ImplicitBody, AConeOfABallThatHoldsTheOtherIsThatBall) {
  const ImplicitBody ball = ImplicitBody::sphere({1, 0, 0}, 2);
  const RandomKey key(5);
  for (const ImplicitBody& cone :
       {ImplicitBody::round_cone({1, 0, 0}, 2, {1, 1, 0}, 0.5), ImplicitBody::round_cone({1, 1, 0}, 0.5, {1, 0, 0}, 2),
        ImplicitBody::round_cone({1, 0, 0}, 2, {1, 0, 0}, 0), ImplicitBody::round_cone({1, 0, 0}, 2, {1, 2, 0}, 0)}) {
    for (std::uint64_t k = 0; k < 50; ++k) {
      const DVec3 position = random_position(key, k, 5);
      EXPECT_NEAR(cone.value(position), ball.value(position), 1e-12);
    }
  }
}

TEST(ImplicitBody, AConeWhoseBallsNearlyHoldEachOtherIsContinuous) {
  const RandomKey key(6);
  for (const double share : {1e-3, 1e-6, 1e-9, 1e-12, 1e-15}) {
    const ImplicitBody cone = ImplicitBody::round_cone({0, 0, 0}, 1, {0, 0.5 * (1 + share), 0}, 0.5);
    for (std::uint64_t k = 0; k < 50; ++k) {
      const DVec3 position = random_position(key, k, 2);
      EXPECT_NEAR(cone.value(position), glm::length(position) - 1, 4 * share + 1e-12);
    }
  }
}

TEST(ImplicitBody, ValuesOfAFlatConeAreDistances) {
  for (const double top : {0.3, 0.8, 2.5, 0.0}) {
    std::vector<std::array<double, 2>> profile;
    for (int k = 0; k <= 100; ++k) {
      const double share = 0.01 * k;
      profile.push_back({0.8 * share, -1});
      profile.push_back({top * share, 1});
      profile.push_back({0.8 + (top - 0.8) * share, -1 + 2 * share});
    }
    const std::vector<DVec3> surface = revolved(profile, 60);
    const auto is_inside = [&](DVec3 p) {
      return std::abs(p.y) < 1 && std::hypot(p.x, p.z) < 0.8 + (top - 0.8) * 0.5 * (p.y + 1);
    };
    expect_distances(ImplicitBody::flat_cone({0, -1, 0}, 0.8, {0, 1, 0}, top), surface, 0.16, 3, is_inside);
    expect_distances(ImplicitBody::flat_cone({0, 1, 0}, top, {0, -1, 0}, 0.8), surface, 0.16, 3, is_inside);
  }
}

TEST(ImplicitBody, ValuesOfABoxAreDistancesInItsFrame) {
  Frame frame = frame_along({1, 0, 0}, {0, 0, 1}, {0, 1, 0});
  frame.axes[1] *= 2.0F;  // the frame's scale counts
  const ImplicitBody box = ImplicitBody::box(frame, {0.5F, 1, 0.25F});
  EXPECT_NEAR(box.value({1, 0, 0}), -0.25, 1e-6);
  EXPECT_NEAR(box.value({1, 0, 1.9}), -0.1, 1e-6);
  EXPECT_NEAR(box.value({1, 0, 2.5}), 0.5, 1e-6);
  EXPECT_NEAR(box.value({1.5 + 3, 0.25 + 4, 2}), 5, 1e-6);
  EXPECT_NEAR(box.value({1 - 0.5 - 2, 0.25 + 3, -2 - 6}), 7, 1e-6);
}

TEST(ImplicitBody, ValuesOfAnEllipsoidAreDistances) {
  for (const DVec3 radii : {DVec3(1, 2, 0.5), DVec3(0.5, 0.5, 2), DVec3(2, 0.5, 2), DVec3(1, 1, 1)}) {
    expect_distances(ImplicitBody::ellipsoid({}, Vec3(radii)), ellipsoid_points(radii, 60), 0.12, 3,
                     [&](DVec3 p) { return squared_length(p / radii) < 1; });
  }
}

TEST(ImplicitBody, AnEllipsoidIsSureOnItsAxesAndPlanes) {
  const DVec3 radii(0.5, 1, 2);
  const ImplicitBody ellipsoid = ImplicitBody::ellipsoid({}, Vec3(radii));
  EXPECT_DOUBLE_EQ(ellipsoid.value({0, 0, 0}), -0.5);
  for (int k = 0; k < 3; ++k) {
    DVec3 position{0};
    position[k] = radii[k] + 3;
    EXPECT_NEAR(ellipsoid.value(position), 3, 1e-12) << k;
    EXPECT_NEAR(ellipsoid.value(-position), 3, 1e-12) << k;
    position[k] = radii[k];
    EXPECT_NEAR(ellipsoid.value(position), 0, 1e-12) << k;
  }
  // Positions on each symmetry plane, and beside it by a tiny number.
  const std::vector<DVec3> surface = ellipsoid_points(radii, 60);
  const RandomKey key(8);
  for (std::uint64_t k = 0; k < 100; ++k) {
    DVec3 position = random_position(key, k, 2.5);
    position[static_cast<int>(k % 3)] = 0;
    const double value = ellipsoid.value(position);
    const double nearest = nearest_of(surface, position);
    EXPECT_NEAR(value * value, nearest * nearest, 0.02);
    EXPECT_LE(std::abs(value), nearest + 1e-9);
    for (const double beside : {1e-300, 1e-20, 1e-16, 1e-9, -1e-17}) {
      position[static_cast<int>(k % 3)] = beside;
      EXPECT_NEAR(ellipsoid.value(position), value, 1e-8) << k << " " << beside;
    }
  }
}

TEST(ImplicitBody, AnEllipsoidOfEqualRadiiIsASphere) {
  const ImplicitBody ball = ImplicitBody::ellipsoid({}, {2, 2, 2});
  for (const DVec3 position : {DVec3(0, 3, 0), DVec3(0, 0, 3), DVec3(3, 0, 0), DVec3(0, 1, 1), DVec3(0, 0.5, 0),
                               DVec3(1e-17, 0, 1), DVec3(0, 0, 0), DVec3(1, 2, 3)}) {
    EXPECT_NEAR(ball.value(position), glm::length(position) - 2, 1e-12)
        << position.x << " " << position.y << " " << position.z;
  }
}

TEST(ImplicitBody, AFlatEllipsoidIsSureFarAway) {
  const ImplicitBody leaf = ImplicitBody::ellipsoid({}, {1, 1e-3F, 1});
  EXPECT_NEAR(leaf.value({1000, 0, 0}), 999, 1e-6);
  EXPECT_NEAR(leaf.value({0, 1000, 0}), 1000 - 1e-3, 1e-6);
  EXPECT_NEAR(leaf.value({600, 1e-12, 800}), 999, 1e-6);
  EXPECT_NEAR(leaf.value({0.5, 0, 0}), -1e-3 * std::sqrt(0.75), 1e-6);
}

TEST(ImplicitBody, OperationsAreThoseOfSets) {
  const ImplicitBody a = ImplicitBody::sphere({0, 0, 0}, 1);
  const ImplicitBody b = ImplicitBody::box({.origin = {0.8F, 0, 0}}, {0.5F, 0.5F, 0.5F});
  const RandomKey key(9);
  for (std::uint64_t k = 0; k < 200; ++k) {
    const DVec3 position = random_position(key, k, 1.5);
    const bool in_a = a.value(position) < 0;
    const bool in_b = b.value(position) < 0;
    EXPECT_EQ(ImplicitBody(a).unite(b).value(position) < 0, in_a || in_b);
    EXPECT_EQ(ImplicitBody(a).intersect(b).value(position) < 0, in_a && in_b);
    EXPECT_EQ(ImplicitBody(a).subtract(b).value(position) < 0, in_a && !in_b);
    for (const BlendKind kind : {BlendKind::poly, BlendKind::root, BlendKind::pasko}) {
      EXPECT_EQ(ImplicitBody(a).blend(b, kind, 0).value(position), ImplicitBody(a).unite(b).value(position));
    }
  }
}

TEST(ImplicitBody, BlendsAreTheirFormulas) {
  const double w = 0.6;
  const ImplicitBody a = ImplicitBody::sphere({-0.9, 0, 0}, 1);
  const ImplicitBody b = ImplicitBody::sphere({0.9, 0, 0}, 0.8);
  const RandomKey key(10);
  for (std::uint64_t k = 0; k < 300; ++k) {
    const DVec3 position = random_position(key, k, 2);
    const double f = a.value(position);
    const double g = b.value(position);
    const double sharp = std::min(f, g);
    const double poly = ImplicitBody(a).blend(b, BlendKind::poly, w).value(position);
    EXPECT_LE(poly, sharp);
    EXPECT_GE(poly, sharp - w / 4 - 1e-12);
    if (std::abs(f - g) >= w) {
      EXPECT_EQ(poly, sharp);
    } else {
      EXPECT_LT(poly, sharp);
    }
    EXPECT_NEAR(ImplicitBody(a).blend(b, BlendKind::root, w).value(position),
                0.5 * (f + g - std::sqrt((f - g) * (f - g) + w * w)), 1e-12);
    EXPECT_NEAR(ImplicitBody(a).blend(b, BlendKind::pasko, w).value(position),
                sharp - w / 4 / (1 + f * f / (w * w) + g * g / (w * w)), 1e-12);
  }
  // A quarter of the width where both are equal.
  const double equal = a.value({0, 0.5, 0});
  EXPECT_NEAR(ImplicitBody(a).blend(ImplicitBody::sphere({0.9, 0, 0}, 1), BlendKind::poly, w).value({0, 0.5, 0}),
              equal - w / 4, 1e-12);
}

TEST(ImplicitBody, FoldsInTheOrderInWhichItIsWritten) {
  const std::array<double, 3> values{0.1, 0.2, 0.35};  // at the origin
  std::array<ImplicitBody, 3> balls;
  for (int k = 0; k < 3; ++k) balls[k] = ImplicitBody::sphere({1 + values[k], 0, 0}, 1);
  const auto poly = [](double a, double b) { return distance::blend_poly(a, b, 0.5, 0.5); };
  const auto [a, b, c] = values;
  const auto folded = [&](int i, int j, int k) {
    return ImplicitBody(balls[i]).blend(balls[j], BlendKind::poly, 0.5).blend(balls[k], BlendKind::poly, 0.5).value({});
  };
  EXPECT_NEAR(folded(0, 1, 2), poly(poly(a, b), c), 1e-12);
  EXPECT_NEAR(folded(0, 2, 1), poly(poly(a, c), b), 1e-12);
  EXPECT_GT(std::abs(folded(0, 1, 2) - folded(0, 2, 1)), 1e-3);
  const ImplicitBody pair = ImplicitBody(balls[1]).blend(balls[2], BlendKind::poly, 0.5);
  EXPECT_NEAR(ImplicitBody(balls[0]).subtract(pair).value({}), std::max(a, -poly(b, c)), 1e-12);
}

TEST(ImplicitBody, IsWhollyInItsBoundsAndReach) {
  const RandomKey key(11);
  for (const BlendKind kind : {BlendKind::poly, BlendKind::root, BlendKind::pasko}) {
    ImplicitBody body;
    for (std::uint64_t k = 0; k < 6; ++k) {
      const DVec3 from = random_position(key, 10 * k, 1);
      const DVec3 to = random_position(key, 10 * k + 1, 1);
      Frame frame = frame_along(Vec3(from), key.direction(10 * k + 2), key.direction(10 * k + 3));
      body.blend(k % 3 == 0   ? ImplicitBody::flat_cone(from, 0.3, to, 0.1)
                 : k % 3 == 1 ? ImplicitBody::round_cone(from, 0.3, to, 0.1)
                              : ImplicitBody::ellipsoid(frame, {0.1F, 0.5F, 0.3F}),
                 kind, 0.2 + 0.1 * static_cast<double>(k));
    }
    const DVec3 low = body.low() - body.reach();
    const DVec3 high = body.high() + body.reach();
    for (std::uint64_t k = 0; k < 2000; ++k) {
      const DVec3 position = random_position(key.child("outside"), k, 4);
      const bool is_in = glm::all(glm::greaterThan(position, low)) && glm::all(glm::lessThan(position, high));
      if (!is_in) {
        EXPECT_GE(body.value(position), 0) << static_cast<int>(kind);
      }
    }
  }
}

TEST(ImplicitBody, HasTheLeastBoxOfEachSolid) {
  const Frame turned = frame_along({}, glm::normalize(Vec3(1, 2, 3)), {0, 0, 1});
  const auto solids = {ImplicitBody::flat_cone({0, 0, 0}, 0.5, {1, 1, 0}, 0.2),
                       ImplicitBody::box(turned, {1, 0.5F, 0.2F}), ImplicitBody::ellipsoid(turned, {1, 0.5F, 0.2F}),
                       ImplicitBody::capsule({}, {1, 2, 3}, 0.1)};
  for (const ImplicitBody& solid : solids) {
    const DVec3 middle = 0.5 * (solid.low() + solid.high());
    for (int axis = 0; axis < 3; ++axis) {
      // Planes touch the box from both sides: all values outside are positive, and just inside of them some value is
      // not.
      double outside = kInfinity;
      double inside = kInfinity;
      const DVec3 size = solid.high() - solid.low();
      for (int k = 0; k < 120 * 120; ++k) {
        DVec3 position = middle;
        position[(axis + 1) % 3] += size[(axis + 1) % 3] * ((k % 120) / 119.0 - 0.5);
        position[(axis + 2) % 3] += size[(axis + 2) % 3] * ((k / 120) / 119.0 - 0.5);
        position[axis] = solid.high()[axis] + 1e-6;
        outside = std::min(outside, solid.value(position));
        position[axis] = solid.high()[axis] - 0.01;
        inside = std::min(inside, solid.value(position));
      }
      EXPECT_GT(outside, 0) << axis;
      EXPECT_LT(inside, 0) << axis;
    }
  }
}

TEST(ImplicitBody, NothingIsOutsideEverywhere) {
  const ImplicitBody ball = ImplicitBody::sphere({}, 1);
  EXPECT_EQ(ImplicitBody().value({1, 2, 3}), kInfinity);
  EXPECT_TRUE(ImplicitBody().is_empty());
  EXPECT_EQ(ImplicitBody().unite(ball).value({}), -1);
  EXPECT_EQ(ImplicitBody().blend(ball, BlendKind::root, 1).value({}), -1);
  EXPECT_EQ(ImplicitBody(ball).unite({}).value({}), -1);
  EXPECT_EQ(ImplicitBody(ball).subtract({}).value({}), -1);
  EXPECT_TRUE(ImplicitBody(ball).intersect({}).is_empty());
  EXPECT_TRUE(ImplicitBody().intersect(ball).is_empty());
  EXPECT_TRUE(ImplicitBody().subtract(ball).is_empty());
}

TEST(ImplicitBody, JoinsWithItself) {
  ImplicitBody body = ImplicitBody::sphere({}, 1);
  EXPECT_EQ(body.unite(body).value({}), -1);
  EXPECT_EQ(body.solids().size(), 2U);
  EXPECT_EQ(body.blend(body, BlendKind::poly, 0.4).value({}), -1.1);
  EXPECT_EQ(body.subtract(body).value({}), 1.1);
}

TEST(ImplicitBody, RejectsSizesThatAreNone) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double bad : {0.0, -1.0, nan, kInfinity}) {
    EXPECT_THROW(ImplicitBody::sphere({}, bad), std::invalid_argument) << bad;
    EXPECT_THROW(ImplicitBody::box({}, vec(1, bad, 1)), std::invalid_argument) << bad;
    EXPECT_THROW(ImplicitBody::ellipsoid({}, vec(1, 1, bad)), std::invalid_argument) << bad;
  }
  for (const double bad : {-1.0, nan, kInfinity}) {
    EXPECT_THROW(ImplicitBody::round_cone({}, bad, {0, 1, 0}, 1), std::invalid_argument) << bad;
    EXPECT_THROW(ImplicitBody::round_cone({}, 1, {0, 1, 0}, bad), std::invalid_argument) << bad;
    EXPECT_THROW(ImplicitBody::flat_cone({}, bad, {0, 1, 0}, 1), std::invalid_argument) << bad;
    EXPECT_THROW(ImplicitBody::flat_cone({}, 1, {0, 1, 0}, bad), std::invalid_argument) << bad;
    EXPECT_THROW(ImplicitBody::sphere({}, 1).blend(ImplicitBody::sphere({}, 1), BlendKind::poly, bad),
                 std::invalid_argument)
        << bad;
  }
  EXPECT_THROW(ImplicitBody::flat_cone({}, 1, {}, 1), std::invalid_argument);
  EXPECT_THROW(ImplicitBody::round_cone({}, 0, {0, 1, 0}, 0), std::invalid_argument);
  for (const double bad : {nan, kInfinity}) {
    EXPECT_THROW(ImplicitBody::sphere({bad, 0, 0}, 1), std::invalid_argument);
    EXPECT_THROW(ImplicitBody::capsule({}, {0, bad, 0}, 1), std::invalid_argument);
    EXPECT_THROW(ImplicitBody::box({.origin = vec(0, 0, bad)}, Vec3(1)), std::invalid_argument);
    EXPECT_THROW(ImplicitBody::ellipsoid({.origin = vec(0, 0, bad)}, Vec3(1)), std::invalid_argument);
  }
}

}  // namespace meristem::implicit_body_test
