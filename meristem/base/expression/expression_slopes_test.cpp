// SPDX-License-Identifier: Apache-2.0
// Compares slopes with symmetric differences, function by function, and with known slopes.
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "meristem/base/expression/expression.h"

namespace meristem::expression_slopes_test {

const ExpressionNames kNames{{"x", "y", "z"}, {}};

struct ValueWithSlopes {
  double value = 0;
  std::array<double, 3> slopes{};
};

/// Returns value and slopes at one point. The point is the last lane in a batch of `lanes`.
ValueWithSlopes at(const std::string& text, std::array<double, 3> point, std::size_t lanes = 1,
                   RandomKey key = RandomKey()) {
  const Expression expression = Expression::compile(text, kNames);
  std::vector<std::vector<double>> columns;
  std::vector<const double*> variables;
  for (const double coordinate : point) columns.emplace_back(lanes, coordinate);
  for (std::vector<double>& column : columns) {
    for (std::size_t k = 0; k + 1 < lanes; ++k) column[k] = 0.1 * static_cast<double>(k);
    variables.push_back(column.data());
  }
  const std::vector<RandomKey> keys(lanes, key);
  std::vector<double> value(lanes), by_x(lanes), by_y(lanes), by_z(lanes);
  const std::array<std::size_t, 3> by{0, 1, 2};
  const std::array<double*, 3> slopes{by_x.data(), by_y.data(), by_z.data()};
  expression.evaluate_with_slopes(lanes, variables, keys, value.data(), by, slopes);
  EXPECT_EQ(value.back(), expression.evaluate(point, key)) << text;
  return {value.back(), {by_x.back(), by_y.back(), by_z.back()}};
}

double difference(const std::string& text, std::array<double, 3> point, std::size_t k, RandomKey key = RandomKey()) {
  const Expression expression = Expression::compile(text, kNames);
  constexpr double kStep = 1e-5;
  const double middle = point[k];
  point[k] = middle + kStep;
  const double above = expression.evaluate(point, key);
  point[k] = middle - kStep;
  return (above - expression.evaluate(point, key)) / (2 * kStep);
}

class ExpressionSlopes : public testing::TestWithParam<const char*> {};

TEST_P(ExpressionSlopes, AreThoseOfDifferences) {
  const std::string text = GetParam();
  const RandomKey key = RandomKey(7).child("slopes");
  for (const std::array<double, 3> point : {std::array{0.3, 0.7, 0.45}, std::array{0.81, 0.12, 0.93}}) {
    for (const std::size_t lanes : {1, 9, 73}) {
      const ValueWithSlopes found = at(text, point, lanes, key);
      for (std::size_t k = 0; k < 3; ++k) {
        const double expected = difference(text, point, k, key);
        EXPECT_NEAR(found.slopes[k], expected, 1e-6 * std::max(1.0, std::abs(expected))) << text << " by " << k;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(OfEachFunction, ExpressionSlopes,
                         testing::Values("x + y - z", "x * y * z", "x / (y + z)", "-x", "x ^ 3 + 2 ^ y", "x ^ y",
                                         "(x - 2) ^ 3", "sin(90*x*y)", "cos(200*x)", "tan(40*y)", "asin(x)", "acos(y)",
                                         "atan(z)", "atan2(x, y)", "sqrt(x)", "cbrt(y)", "exp(x*z)", "log(x)",
                                         "log2(y)", "log10(z)", "abs(x - y)", "sign(x)", "floor(x)", "ceil(y)",
                                         "round(z)", "trunc(x)", "frac(7*x)", "mod(7*x, y + 1)", "7*x % 2",
                                         "min(x, y, z)", "max(x, y, z)", "clamp(x, y, z)", "clamp(x, 0.2, 0.9)",
                                         "lerp(x, y, z)", "smoothstep(0, 1, x)", "smoothstep(x - 1, y + 1, z)",
                                         "step(0.5, x)", "noise(3*x)", "noise(x, 2*y)", "noise(3*x, 3*y, 3*z)",
                                         "x > y ? x*x : y*z", "(x < y) * z", "rand() * x", "rand(x, y)", "gauss(x, y)",
                                         "ran(x) * y", "x == y ? 1 : x", "!x + y", "7", "x + 0.4*y^2*sin(30*z)"));

TEST(ExpressionSlopesAtKinks, AreThoseOfOneSide) {
  EXPECT_EQ(at("abs(x)", {0, 0, 0}).slopes[0], 1);
  EXPECT_EQ(at("max(x, 0)", {0, 0, 0}).slopes[0], 1);
  EXPECT_EQ(at("sqrt(x)", {0, 0, 0}).slopes[0], INFINITY);
  EXPECT_EQ(at("y + 0*sqrt(x)", {0, 0, 0}).slopes[1], 1);
}

TEST(ExpressionSlopesAtKinks, APowerOfNothingHasOne) {
  EXPECT_EQ(at("x^2", {0, 0, 0}).slopes[0], 0);
  EXPECT_EQ(at("x^1", {0, 0, 0}).slopes[0], 1);
  EXPECT_EQ(at("x^0", {0, 0, 0}).slopes[0], 0);
}

TEST(ExpressionHash, IsOfWhatItDoes) {
  const auto hash = [](const std::string& text, double k) {
    return Expression::compile(text, {{"x", "y"}, {{"k", k}}}).hash();
  };
  EXPECT_EQ(hash("k*x", 2), hash(" 2 * x", 3));
  EXPECT_NE(hash("k*x", 2), hash("k*x", 3));
  EXPECT_NE(hash("k*x", 2), hash("k*y", 2));
}

}  // namespace meristem::expression_slopes_test
