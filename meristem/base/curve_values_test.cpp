// SPDX-License-Identifier: Apache-2.0
#include "meristem/base/curve_values.h"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "meristem/base/random.h"

namespace meristem::curve_values_test {

TEST(CurveValues, AreThoseOfTheCurveToTheLastBit) {
  const RandomKey key(5);
  for (std::uint64_t run = 0; run < 20; ++run) {
    std::vector<Vec2> points;
    float x = -1;
    for (std::uint64_t k = 0; k < 1 + run; ++k) {
      x += static_cast<float>(key.child(run).uniform(2 * k, 0.01, 1));
      points.emplace_back(x, static_cast<float>(key.child(run).uniform(2 * k + 1, -1, 1)));
    }
    // Positions before, on, between and behind the points. Some positions occur twice.
    std::vector<double> rising;
    for (double position = -1.5; position < x + 0.5; position += 0.0625) rising.insert(rising.end(), 2, position);
    for (const Vec2 point : points) rising.push_back(point.x);
    std::sort(rising.begin(), rising.end());
    const CurvePositions positions(points, rising);
    for (const CurveKind kind : {CurveKind::spline, CurveKind::linear}) {
      const Curve curve(points, kind);
      const std::vector<double> values = positions.values(points, kind);
      ASSERT_EQ(values.size(), rising.size());
      for (std::size_t k = 0; k < rising.size(); ++k) EXPECT_EQ(values[k], curve(rising[k])) << rising[k];
    }
  }
}

TEST(CurveValues, ServeAllCurvesWithTheSameX) {
  const std::vector<Vec2> points{{0, 1}, {0.5F, 3}, {2, -1}};
  const std::vector<Vec2> others{{0, -2}, {0.5F, 0}, {2, 7}};
  const std::vector<double> rising{-1, 0.25, 1, 1.75, 3};
  const std::vector<double> values = CurvePositions(points, rising).values(others, CurveKind::spline);
  const Curve curve(others);
  for (std::size_t k = 0; k < rising.size(); ++k) EXPECT_EQ(values[k], curve(rising[k]));
}

}  // namespace meristem::curve_values_test
