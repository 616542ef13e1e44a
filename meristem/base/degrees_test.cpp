// SPDX-License-Identifier: Apache-2.0
#include "meristem/base/degrees.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace meristem::degrees_test {

using math::cos_deg;
using math::sin_deg;
using math::tan_deg;

constexpr long double kRadiansPerDegree = 0.017453292519943295769236907684886127L;

double unit_in_last_place(double x) {
  return std::nextafter(std::abs(x), std::numeric_limits<double>::infinity()) - std::abs(x);
}

TEST(Degrees, QuartersAndThirdsAreExact) {
  for (int turn = -5; turn <= 5; ++turn) {
    const double full = 360.0 * turn;
    EXPECT_EQ(sin_deg(full), 0);
    EXPECT_EQ(sin_deg(full + 30), 0.5);
    EXPECT_EQ(sin_deg(full + 90), 1);
    EXPECT_EQ(sin_deg(full + 180), 0);
    EXPECT_EQ(sin_deg(full + 270), -1);
    EXPECT_EQ(cos_deg(full), 1);
    EXPECT_EQ(cos_deg(full + 60), 0.5);
    EXPECT_EQ(cos_deg(full + 90), 0);
    EXPECT_EQ(cos_deg(full + 180), -1);
    EXPECT_EQ(cos_deg(full + 270), 0);
    EXPECT_EQ(tan_deg(full + 45), 1);
  }
}

TEST(Degrees, ZerosHaveNoSign) {
  EXPECT_FALSE(std::signbit(sin_deg(180)));
  EXPECT_FALSE(std::signbit(sin_deg(-180)));
  EXPECT_FALSE(std::signbit(cos_deg(90)));
}

/// Sine at the precision of long double; degrees are brought near zero exactly before they become radians.
long double precise_sine(double degrees) {
  int quarters = 0;
  const long double rest = std::remquo(static_cast<long double>(degrees), 90.0L, &quarters) * kRadiansPerDegree;
  const long double value = (quarters & 1) != 0 ? std::cos(rest) : std::sin(rest);
  return (quarters & 2) != 0 ? -value : value;
}

TEST(Degrees, ErrorsStayBelowThreeUnitsInTheLastPlace) {
  for (int k = -200'000; k <= 200'000; ++k) {
    const double angle = k * 0.00451;
    const long double sine = precise_sine(angle);
    ASSERT_LE(std::abs(sin_deg(angle) - sine), 3 * unit_in_last_place(static_cast<double>(sine))) << angle;
    const double fraction = k * 0x1p-8;  // exact, plus 90 too
    const long double cosine = precise_sine(fraction + 90);
    ASSERT_LE(std::abs(cos_deg(fraction) - cosine), 3 * unit_in_last_place(static_cast<double>(cosine))) << fraction;
  }
}

TEST(Degrees, LargeAnglesLoseWholeTurnsExactly) {
  for (const double turns : {1e6, 1e9, 3e12, 1e13}) {
    EXPECT_EQ(sin_deg(360 * turns + 30), 0.5);
    EXPECT_EQ(cos_deg(-360 * turns + 60), 0.5);
  }
  EXPECT_EQ(sin_deg(1e300), sin_deg(std::fmod(1e300, 360)));
}

TEST(Degrees, NearAndReducedAnglesAgreeAtTheBorder) {
  const double beyond = std::nextafter(math::kNearDegrees, 1e300);
  EXPECT_EQ(math::near_sin_deg(math::kNearDegrees), sin_deg(std::fmod(math::kNearDegrees, 360)));
  EXPECT_NEAR(sin_deg(beyond), sin_deg(math::kNearDegrees), 1e-5);
}

TEST(Degrees, InfinitiesAndNanGiveNan) {
  for (const double x : {HUGE_VAL, -HUGE_VAL, std::nan("")}) {
    EXPECT_TRUE(std::isnan(sin_deg(x)));
    EXPECT_TRUE(std::isnan(cos_deg(x)));
    EXPECT_TRUE(std::isnan(tan_deg(x)));
  }
}

RC_GTEST_PROP(Degrees, SineIsOddAndCosineIsEven, (int thousandths)) {
  const double angle = thousandths / 1000.0;
  RC_ASSERT(sin_deg(-angle) == -sin_deg(angle));
  RC_ASSERT(cos_deg(-angle) == cos_deg(angle));
}

}  // namespace meristem::degrees_test
