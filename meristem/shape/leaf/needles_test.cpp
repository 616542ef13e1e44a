// SPDX-License-Identifier: Apache-2.0
#include "meristem/shape/leaf/needles.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/support/check_mesh.h"

namespace meristem::needles_test {

constexpr MeshPromises kOpen{.closed = false, .outward = false};

/// Returns base and tip of each flat needle of a shoot without a twig.
std::vector<std::pair<Vec3, Vec3>> needles_of(const NeedleShoot& shoot) {
  const Mesh mesh = make_needles(shoot);
  std::vector<std::pair<Vec3, Vec3>> needles;
  for (std::size_t i = 0; i < mesh.vertex_count(); i += 4) {
    needles.emplace_back(mesh.positions[i], mesh.positions[i + 2]);
  }
  return needles;
}

float angle_to_shoot(const std::pair<Vec3, Vec3>& needle) {
  return std::acos(glm::normalize(needle.second - needle.first).y);
}

TEST(Needles, EachHasTwoTrianglesOrThree) {
  NeedleShoot shoot;
  shoot.count = 10;
  shoot.fascicle = 2;
  EXPECT_EQ(make_needles(shoot).triangle_count(), 10U * 2 * 2);
  shoot.sides = 3;
  EXPECT_EQ(make_needles(shoot).triangle_count(), 10U * 2 * 3);
  shoot.axis_radius = 0.001;
  EXPECT_EQ(make_needles(shoot).triangle_count(), 10U * 2 * 3 + 3);
}

TEST(Needles, RegularOnesHaveTheirLengthAndAngles) {
  NeedleShoot shoot;
  shoot.irregular = 0;
  shoot.count = 200;
  const auto needles = needles_of(shoot);
  for (const auto& [base, tip] : needles) EXPECT_NEAR(glm::distance(base, tip), shoot.length, 1e-6);
  EXPECT_NEAR(angle_to_shoot(needles.front()), shoot.base_angle, 0.01);
  EXPECT_NEAR(angle_to_shoot(needles.back()), shoot.tip_angle, 0.01);
}

TEST(Needles, StandOnTheShootAndAllAroundIt) {
  NeedleShoot shoot;
  shoot.count = 300;
  Vec3 sum(0);
  for (const auto& [base, tip] : needles_of(shoot)) {
    EXPECT_EQ(base.x, 0.0F);
    EXPECT_EQ(base.z, 0.0F);
    EXPECT_GE(base.y, 0.0F);
    EXPECT_LE(base.y, static_cast<float>(shoot.along));
    sum += glm::normalize(Vec3(tip.x, 0, tip.z));
  }
  EXPECT_LT(glm::length(sum) / 300, 0.02F);
}

TEST(Needles, CombingPressesThemIntoOnePlane) {
  NeedleShoot shoot;
  shoot.count = 100;
  const auto height = [&](double flatten) {
    shoot.flatten = flatten;
    float highest = 0;
    for (const auto& [base, tip] : needles_of(shoot)) highest = std::max(highest, std::abs(tip.z));
    return highest;
  };
  EXPECT_GT(height(0), 0.8 * shoot.length * std::sin(shoot.tip_angle));
  EXPECT_LT(height(1), 1e-6);
}

TEST(Needles, TwoOfABundleLeanToOppositeSides) {
  NeedleShoot shoot;
  shoot.count = 1;
  shoot.along = 0;
  shoot.fascicle = 2;
  shoot.irregular = 0;
  shoot.spread = 0.3;
  const auto needles = needles_of(shoot);
  const Vec3 a = glm::normalize(needles[0].second), b = glm::normalize(needles[1].second);
  EXPECT_NEAR(std::acos(glm::dot(a, b)), 2 * shoot.spread, 1e-3);
}

TEST(Needles, PositiveCurlBendsTipsAwayFromTheShoot) {
  NeedleShoot shoot;
  shoot.irregular = 0;
  const float straight = angle_to_shoot(needles_of(shoot).front());
  shoot.curl = 0.6;
  EXPECT_NEAR(angle_to_shoot(needles_of(shoot).front()), straight + 0.3F, 1e-3);
}

TEST(Needles, VariantsDifferAndOneIsAlwaysTheSame) {
  NeedleShoot shoot;
  const Mesh first = make_needles(shoot);
  EXPECT_EQ(first.positions, make_needles(shoot).positions);
  shoot.variant = 1;
  EXPECT_NE(first.positions, make_needles(shoot).positions);
}

RC_GTEST_PROP(Needles, AreSoundForAnyShape, ()) {
  const auto share = [] { return *rc::gen::inRange(0, 1001) / 1000.0; };
  NeedleShoot shoot;
  shoot.count = *rc::gen::inRange(1, 30);
  shoot.fascicle = *rc::gen::inRange(1, 8);
  shoot.along = *rc::gen::element(0.0, 0.1);
  shoot.base_angle = 3 * share();
  shoot.tip_angle = 3 * share();
  shoot.spread = share();
  shoot.curl = 2 * share() - 1;
  shoot.flatten = share();
  shoot.irregular = 0.9 * share();
  shoot.sides = *rc::gen::inRange(2, 4);
  shoot.axis_radius = *rc::gen::element(0.0, 0.001);
  RC_ASSERT(check_mesh(make_needles(shoot), kOpen));
}

TEST(Needles, RejectWhatMakesNone) {
  const auto rejects = [](const std::function<void(NeedleShoot&)>& change) {
    NeedleShoot shoot;
    change(shoot);
    EXPECT_THROW(make_needles(shoot), std::invalid_argument);
  };
  rejects([](NeedleShoot& shoot) { shoot.length = 0; });
  rejects([](NeedleShoot& shoot) { shoot.width = -1; });
  rejects([](NeedleShoot& shoot) { shoot.along = -1; });
  rejects([](NeedleShoot& shoot) { shoot.axis_radius = -1; });
  rejects([](NeedleShoot& shoot) { shoot.curl = std::numeric_limits<double>::infinity(); });
  rejects([](NeedleShoot& shoot) { shoot.flatten = 1.5; });
  rejects([](NeedleShoot& shoot) { shoot.irregular = -0.5; });
  rejects([](NeedleShoot& shoot) { shoot.count = 0; });
  rejects([](NeedleShoot& shoot) { shoot.fascicle = 0; });
  rejects([](NeedleShoot& shoot) { shoot.sides = 4; });
}

}  // namespace meristem::needles_test
