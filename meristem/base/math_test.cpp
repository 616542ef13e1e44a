// SPDX-License-Identifier: Apache-2.0
#include "meristem/base/math.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include "meristem/base/hash.h"
#include "meristem/base/random.h"
#include "meristem/base/vec.h"

namespace meristem::math_test {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr int kSamples = 50'000;

/// Returns the difference of the two numbers in units in the last place of `want`.
double ulps_between(double got, long double want) {
  const auto rounded = static_cast<double>(want);
  if (got == rounded || (std::isnan(got) && std::isnan(rounded))) return 0;
  if (!std::isfinite(got) || !std::isfinite(rounded)) return kInfinity;
  int exponent = 0;
  std::frexp(rounded, &exponent);
  const long double unit = std::ldexp(1.0L, std::max(exponent - 53, -1074));
  return static_cast<double>(std::abs((got - want) / unit));
}

/// Returns the largest error of `function` relative to the long double `reference`, over arguments that `argument(key,
/// k)` returns.
template <class Function, class Reference, class Argument>
double worst_error(Function function, Reference reference, Argument argument) {
  double worst = 0;
  for (int k = 0; k < kSamples; ++k) {
    const double x = argument(RandomKey(1), static_cast<std::uint64_t>(k));
    worst = std::max(worst, ulps_between(function(x), reference(static_cast<long double>(x))));
  }
  return worst;
}

auto between(double low, double high) {
  return [=](RandomKey key, std::uint64_t k) { return key.uniform(k, low, high); };
}

/// Returns arguments of either sign, with binary exponents evenly between `low` and `high`.
auto of_every_size(double low, double high) {
  return [=](RandomKey key, std::uint64_t k) {
    const double size = std::exp2(low + (high - low) * key.uniform(k, 1U));
    return key.uniform(k) < 0.5 ? -size : size;
  };
}

auto positive(double low, double high) {
  return [=](RandomKey key, std::uint64_t k) { return std::abs(of_every_size(low, high)(key, k)); };
}

constexpr auto kSin = [](long double x) { return std::sin(x); };
constexpr auto kCos = [](long double x) { return std::cos(x); };
constexpr auto kTan = [](long double x) { return std::tan(x); };
constexpr auto kAsin = [](long double x) { return std::asin(x); };
constexpr auto kAcos = [](long double x) { return std::acos(x); };
constexpr auto kExp = [](long double x) { return std::exp(x); };
constexpr auto kLog = [](long double x) { return std::log(x); };

TEST(Math, SineCosineAndTangentKeepFourUnits) {
  EXPECT_LT(worst_error(math::sin, kSin, between(-10, 10)), 4);
  EXPECT_LT(worst_error(math::sin, kSin, between(-1e6, 1e6)), 4);
  EXPECT_LT(worst_error(math::sin, kSin, of_every_size(-1070, 19)), 4);
  EXPECT_LT(worst_error(math::cos, kCos, between(-10, 10)), 4);
  EXPECT_LT(worst_error(math::cos, kCos, between(-1e6, 1e6)), 4);
  EXPECT_LT(worst_error(math::tan, kTan, between(-10, 10)), 4);
  EXPECT_LT(worst_error(math::tan, kTan, between(-1e6, 1e6)), 4);
  EXPECT_LT(worst_error(math::tan, kTan, of_every_size(-1070, 19)), 4);
}

TEST(Math, SineKeepsItsDigitsAtMultiplesOfPi) {
  // The double nearest to n pi differs from n pi by the exact sine. Pi in two parts gives this difference to 100 bits.
  for (int turns = 1; turns < 300'000; turns += 7) {
    const double angle = turns * kPi;
    const double sine = math::sin(angle);
    EXPECT_LT(ulps_between(sine, std::sin(static_cast<long double>(angle))), 4) << turns;
    EXPECT_EQ(std::abs(math::cos(angle)), 1) << turns;
  }
}

TEST(Math, InverseFunctionsKeepFourUnits) {
  EXPECT_LT(worst_error(math::asin, kAsin, between(-1, 1)), 4);
  EXPECT_LT(worst_error(math::asin, kAsin, of_every_size(-1000, 0)), 4);
  EXPECT_LT(worst_error(math::acos, kAcos, between(-1, 1)), 4);
  const auto near_one = [](RandomKey key, std::uint64_t k) { return 1 - std::exp2(-52 * key.uniform(k)); };
  EXPECT_LT(worst_error(math::acos, kAcos, near_one), 4);
  double worst = 0;
  for (std::uint64_t k = 0; k < kSamples; ++k) {
    const double y = of_every_size(-400, 400)(RandomKey(2), k);
    const double x = of_every_size(-400, 400)(RandomKey(3), k);
    worst = std::max(worst, ulps_between(math::atan2(y, x), std::atan2(static_cast<long double>(y), x)));
  }
  EXPECT_LT(worst, 4);
}

TEST(Math, ExponentialAndLogarithmKeepFourUnits) {
  EXPECT_LT(worst_error(math::exp, kExp, between(-708, 709.7)), 4);
  EXPECT_LT(worst_error(math::exp, kExp, of_every_size(-1070, 3)), 4);
  EXPECT_LT(worst_error(math::exp, kExp, between(-745, -708)), 4);  // subnormal results
  EXPECT_LT(worst_error(math::log, kLog, positive(-1074, 1023)), 4);
  EXPECT_LT(worst_error(math::log, kLog, between(0.999, 1.001)), 4);
}

TEST(Math, PowerKeepsFourUnits) {
  const auto error_at = [](double x, double y) {
    return ulps_between(math::pow(x, y), std::pow(static_cast<long double>(x), static_cast<long double>(y)));
  };
  for (std::uint64_t k = 0; k < kSamples; ++k) {
    const double x = positive(-30, 30)(RandomKey(4), k);
    const double y = RandomKey(5).uniform(k, -20, 20);
    EXPECT_LT(error_at(x, y), 4) << x << " to the power " << y;
    EXPECT_LT(error_at(x, std::floor(y)), 4) << x << " to the power " << std::floor(y);
    const double near_one = 1 + 1e-6 * (RandomKey(6).uniform(k) - 0.5);
    EXPECT_LT(error_at(near_one, 1e6 * y), 4) << near_one << " to the power " << 1e6 * y;
  }
}

TEST(Math, WholePowersAndRootsAreExactWhereTheyFit) {
  for (int n = -300; n <= 300; ++n) {
    EXPECT_EQ(math::pow(n, 2), n * n);
    EXPECT_EQ(math::pow(n, 5), static_cast<double>(n) * n * n * n * n);
    EXPECT_EQ(math::pow(n * n, 0.5), std::abs(n));
  }
  for (int n = -64; n <= 64; ++n) EXPECT_EQ(math::pow(2, n), std::ldexp(1.0, n));
  EXPECT_EQ(math::pow(8, -1), 0.125);
  EXPECT_EQ(math::pow(-2, 3), -8);
  EXPECT_EQ(math::pow(2, -1074), std::ldexp(1.0, -1074));
}

TEST(Math, KnownValuesComeOutExactly) {
  EXPECT_EQ(math::sin(kPi / 2), 1);
  EXPECT_EQ(math::cos(0), 1);
  EXPECT_EQ(math::cos(kPi), -1);
  EXPECT_EQ(math::atan2(1, 1), kPi / 4);
  EXPECT_EQ(math::atan2(1, 0), kPi / 2);
  EXPECT_EQ(math::atan2(-1, 0), -kPi / 2);
  EXPECT_EQ(math::atan2(0, -1), kPi);
  EXPECT_EQ(math::atan2(0, 0), 0);
  EXPECT_EQ(math::atan2(kInfinity, kInfinity), kPi / 4);
  EXPECT_EQ(math::exp(0), 1);
  EXPECT_EQ(math::log(1), 0);
}

TEST(Math, ArcFunctionsTakeOverlongArgumentsForTheirEnds) {
  EXPECT_EQ(math::asin(1.5), kPi / 2);
  EXPECT_EQ(math::asin(-1.5), -kPi / 2);
  EXPECT_EQ(math::acos(1.5), 0);
  EXPECT_EQ(math::acos(-1.5), kPi);
}

TEST(Math, InfinitiesAndNansFollowTheStandard) {
  for (const double x : {kNan, kInfinity, -kInfinity}) {
    EXPECT_TRUE(std::isnan(math::sin(x)));
    EXPECT_TRUE(std::isnan(math::cos(x)));
    EXPECT_TRUE(std::isnan(math::tan(x)));
  }
  EXPECT_TRUE(std::isnan(math::asin(kNan)));
  EXPECT_TRUE(std::isnan(math::acos(kNan)));
  EXPECT_TRUE(std::isnan(math::atan2(kNan, 1)));
  EXPECT_EQ(math::exp(kInfinity), kInfinity);
  EXPECT_EQ(math::exp(-kInfinity), 0);
  EXPECT_EQ(math::exp(710), kInfinity);
  EXPECT_TRUE(std::isnan(math::exp(kNan)));
  EXPECT_EQ(math::log(0), -kInfinity);
  EXPECT_EQ(math::log(kInfinity), kInfinity);
  EXPECT_TRUE(std::isnan(math::log(-1)));
  EXPECT_TRUE(std::isnan(math::log(kNan)));
}

TEST(Math, PowerAgreesWithTheStandardAtEverySpecialPair) {
  const std::vector<double> values = {0.0,  -0.0,      1,          -1,     2,       -2,    3,      -3,   0.5,
                                      -0.5, 2.5,       -2.5,       1e300,  1e17,    -1e17, 1e-300, 4097, -4097,
                                      kNan, kInfinity, -kInfinity, 5e-324, -5e-324, 64,    65};
  for (const double x : values) {
    for (const double y : values) {
      const double got = math::pow(x, y);
      const double want = std::pow(x, y);
      EXPECT_LT(ulps_between(got, want), 4) << x << " to the power " << y;
      EXPECT_TRUE(std::isnan(want) || std::signbit(got) == std::signbit(want)) << x << " to the power " << y;
    }
  }
}

TEST(Math, HugeAnglesStayWithinTheUnitCircle) {
  for (const double x : {1e7, -3e12, 1e100, std::numeric_limits<double>::max()}) {
    EXPECT_LE(std::abs(math::sin(x)), 1);
    EXPECT_NEAR(math::sin(x) * math::sin(x) + math::cos(x) * math::cos(x), 1, 1e-15);
  }
}

TEST(Math, BytesAreThoseOfEveryOtherMachine) {
  std::vector<double> values;
  for (std::uint64_t k = 0; k < 10'000; ++k) {
    const double u = RandomKey(7).uniform(k);
    const double v = RandomKey(8).uniform(k);
    for (const double value : {math::sin(1000 * u), math::cos(1000 * u), math::tan(u), math::asin(u), math::acos(u),
                               math::atan2(u, v), math::exp(20 * u), math::log(u + v), math::pow(10 * u, 10 * v)}) {
      values.push_back(value);
    }
  }
  EXPECT_EQ(hash128_hex(std::as_bytes(std::span(values))), "3df3341405e279c1e6c38a40066f8431");
}

}  // namespace meristem::math_test
