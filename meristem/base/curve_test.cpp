// SPDX-License-Identifier: Apache-2.0
#include "meristem/base/curve.h"

#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace meristem::curve_test {

double second_derivative(const Curve& curve, double x, double step) {
  return (curve.slope(x + step) - curve.slope(x - step)) / (2 * step);
}

Curve uneven(CurveKind kind = CurveKind::spline) {
  return Curve({{-1, 2}, {-0.5F, 0.25F}, {0.75F, 1}, {1, -3}, {4, 0.5F}}, kind);
}

/// Returns one arch of the sine in `pieces` pieces. The second derivative of the arch is zero at both ends.
Curve sine_arch(int pieces) {
  std::vector<Vec2> points;
  for (int k = 0; k <= pieces; ++k) {
    const double x = k / static_cast<double>(pieces);
    points.emplace_back(x, std::sin(M_PI * x));
  }
  return Curve(points);
}

double worst_error_of_arch(int pieces) {
  const Curve curve = sine_arch(pieces);
  double worst = 0;
  for (int k = 0; k <= 1000; ++k) worst = std::max(worst, std::abs(curve(k / 1000.0) - std::sin(M_PI * k / 1000.0)));
  return worst;
}

TEST(Curve, GoesThroughItsPoints) {
  for (const CurveKind kind : {CurveKind::spline, CurveKind::linear}) {
    const Curve curve = uneven(kind);
    for (const Vec2 point : curve.points()) EXPECT_NEAR(curve(point.x), point.y, 1e-12);
  }
}

TEST(Curve, SplineThroughThreePointsHasItsClosedForm) {
  // y = 3/2 x - 1/2 x³ on [0, 1], and its mirror image.
  const Curve curve({{0, 0}, {1, 1}, {2, 0}});
  for (const double x : {0.0, 0.2, 0.5, 0.9, 1.0}) {
    EXPECT_NEAR(curve(x), 1.5 * x - 0.5 * x * x * x, 1e-15);
    EXPECT_NEAR(curve(2 - x), curve(x), 1e-15);
    EXPECT_NEAR(curve.slope(x), 1.5 - 1.5 * x * x, 1e-15);
  }
}

TEST(Curve, SplineThroughPointsOfALineIsThatLine) {
  const Curve curve({{0, 1}, {0.25F, 1.5F}, {3, 7}, {3.5F, 8}});
  for (double x = 0; x <= 3.5; x += 0.125) EXPECT_NEAR(curve(x), 1 + 2 * x, 1e-14);
  EXPECT_NEAR(Curve({{0, 0}, {2, 1}})(0.5), 0.25, 1e-15);
}

TEST(Curve, SplineHasZeroSecondDerivativeAtBothEnds) {
  const Curve curve = uneven();
  const double h = 1e-5;
  EXPECT_NEAR(second_derivative(curve, -1 + h, h), 0, 1e-3);
  EXPECT_NEAR(second_derivative(curve, 4 - h, h), 0, 1e-3);
}

TEST(Curve, SplineKeepsSlopeAndCurvatureAcrossPoints) {
  const Curve curve = uneven();
  const double h = 1e-5;
  for (const double x : {-0.5, 0.75, 1.0}) {
    EXPECT_NEAR(curve.slope(x - 1e-12), curve.slope(x + 1e-12), 1e-8);
    EXPECT_NEAR(second_derivative(curve, x - h, h), second_derivative(curve, x + h, h), 1e-2);
  }
}

TEST(Curve, SplineConvergesAtFourthOrder) {
  EXPECT_NEAR(worst_error_of_arch(4) / worst_error_of_arch(8), 16, 2);
  EXPECT_NEAR(worst_error_of_arch(8) / worst_error_of_arch(16), 16, 2);
}

TEST(Curve, LinearJoinsPointsByStraightLines) {
  const Curve curve({{0, 0}, {1, 2}, {3, 1}}, CurveKind::linear);
  EXPECT_DOUBLE_EQ(curve(0.25), 0.5);
  EXPECT_DOUBLE_EQ(curve(2), 1.5);
  EXPECT_DOUBLE_EQ(curve.slope(0), 2);
  EXPECT_DOUBLE_EQ(curve.slope(0.5), 2);
  EXPECT_DOUBLE_EQ(curve.slope(1), -0.5);  // slope of the piece to the right
  EXPECT_DOUBLE_EQ(curve.slope(3), 0);
}

TEST(Curve, KeepsItsEndValuesOutside) {
  for (const CurveKind kind : {CurveKind::spline, CurveKind::linear}) {
    const Curve curve = uneven(kind);
    EXPECT_EQ(curve(-100), 2);
    EXPECT_EQ(curve(std::numeric_limits<double>::infinity()), 0.5);
    EXPECT_EQ(curve.slope(-1.001), 0);
    EXPECT_EQ(curve.slope(4.001), 0);
  }
}

TEST(Curve, SinglePointIsAConstant) {
  const Curve curve({{0.5F, 3}});
  for (const double x : {-1.0, 0.5, 2.0}) {
    EXPECT_EQ(curve(x), 3);
    EXPECT_EQ(curve.slope(x), 0);
  }
  EXPECT_EQ(Curve()(7), 0);
}

TEST(Curve, EqualityCoversPointsAndKind) {
  EXPECT_EQ(uneven(), uneven());
  EXPECT_FALSE(uneven() == uneven(CurveKind::linear));
  EXPECT_FALSE(uneven() == Curve());
}

TEST(Curve, RejectsPointsThatAreNoFunction) {
  const float infinity = std::numeric_limits<float>::infinity();
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THROW(Curve(std::vector<Vec2>{}), std::invalid_argument);
  EXPECT_THROW(Curve({{0, nan}}), std::invalid_argument);
  EXPECT_THROW(Curve({{nan, 0}}), std::invalid_argument);
  EXPECT_THROW(Curve({{0, 0}, {infinity, 1}}), std::invalid_argument);
  EXPECT_THROW(Curve({{0, 0}, {0, 1}}), std::invalid_argument);
  EXPECT_THROW(Curve({{1, 0}, {0, 1}}), std::invalid_argument);
}

RC_GTEST_PROP(Curve, SplineSlopeIsTheDerivativeAnywhere, (const std::vector<std::uint8_t>& heights)) {
  RC_PRE(heights.size() >= 2U);
  std::vector<Vec2> points;
  for (const std::uint8_t height : heights) points.emplace_back(points.size() * 0.5F, height / 64.0F);
  const Curve curve(points);
  const double h = 1e-5;
  for (double x = 0.13; x < points.back().x - 0.1; x += 0.37) {
    const double difference = (curve(x + h) - curve(x - h)) / (2 * h);
    RC_ASSERT(std::abs(difference - curve.slope(x)) < 1e-4);
  }
}

RC_GTEST_PROP(Curve, SplineOfScaledPointsIsTheScaledSpline, (const std::vector<std::int8_t>& heights)) {
  RC_PRE(!heights.empty());
  std::vector<Vec2> points;
  std::vector<Vec2> scaled;
  for (const std::int8_t height : heights) {
    points.emplace_back(points.size(), height);
    scaled.emplace_back(4 * points.back().x, -2 * points.back().y);
  }
  const Curve curve(points);
  const Curve scaled_curve(scaled);
  for (double x = -0.5; x < static_cast<double>(points.size()); x += 0.25) {
    RC_ASSERT(std::abs(scaled_curve(4 * x) + 2 * curve(x)) < 1e-10);
  }
}

}  // namespace meristem::curve_test
