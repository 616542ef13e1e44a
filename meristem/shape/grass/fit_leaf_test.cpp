// SPDX-License-Identifier: Apache-2.0
#include "meristem/shape/grass/fit_leaf.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "meristem/base/vec.h"
#include "tests/support/grass_leaves.h"

namespace meristem::fit_leaf_test {

MeasuredCurve curve(std::vector<glm::dvec2> points) { return {.points = std::move(points)}; }

/// Returns a quarter of a circle of radius 20: up from the collar, then level.
MeasuredCurve quarter_circle(int count) {
  MeasuredCurve midrib;
  for (int k = 0; k < count; ++k) {
    const double angle = kPi / 2 * k / (count - 1);
    midrib.points.emplace_back(20 * (1 - std::cos(angle)), 20 * std::sin(angle));
  }
  return midrib;
}

/// Returns the root mean square distance of the digitised points from the leaf's midrib, in lengths.
double distance_of(const FittedLeaf& fitted, const MeasuredCurve& midrib) {
  double squares = 0;
  for (const glm::dvec2 point : midrib.points) {
    const double distance = distance_to_midrib((point - midrib.points[0]) / fitted.midrib_length, fitted.leaf);
    squares += distance * distance;
  }
  return std::sqrt(squares / static_cast<double>(midrib.points.size()));
}

/// Returns the area of trapezoids over measured widths.
double trapezoids(const MeasuredCurve& widths) {
  double sum = 0;
  for (std::size_t k = 1; k < widths.points.size(); ++k) {
    sum += 0.5 * (widths.points[k].x - widths.points[k - 1].x) * (widths.points[k].y + widths.points[k - 1].y);
  }
  return sum;
}

double longest(const GrassLeaf& leaf) {
  double length = 0;
  for (std::size_t k = 1; k < leaf.point_count(); ++k) {
    length += std::hypot(leaf.x[k] - leaf.x[k - 1], leaf.y[k] - leaf.y[k - 1]);
  }
  return length;
}

TEST(FitLeaf, AQuarterCircleOf12PointsHasItsLengthAndArea) {
  const FittedLeaf fitted = fit_leaf(quarter_circle(12), plain_widths());
  EXPECT_NEAR(fitted.midrib_length / (20 * kPi / 2), 1, 0.005);
  EXPECT_NEAR(fitted.midrib_length / fitted.polyline_length, 1, 0.01);
  EXPECT_LT(fitted.distance / fitted.midrib_length, 0.0025);
  EXPECT_NEAR(area(fitted.leaf) / (fitted.leaf.length * trapezoids(plain_widths())), 1, 0.02);
  EXPECT_NEAR(fitted.leaf.x.back(), 2 / kPi, 0.01);
  EXPECT_NEAR(fitted.leaf.y.back(), 2 / kPi, 0.01);
}

TEST(FitLeaf, WithoutSmoothingTheMidribGoesThroughItsPoints) {
  const MeasuredCurve midrib = curve({{0, 0}, {1, 6}, {4, 11}, {9, 12}, {12, 8}});
  const FittedLeaf fitted = fit_leaf(midrib, plain_widths(), {.smoothing = 0, .pieces = 400});
  EXPECT_NEAR(fitted.midrib_length, fitted.polyline_length, 1e-3 * fitted.polyline_length);
  EXPECT_LT(distance_of(fitted, midrib), 1e-3);
}

TEST(FitLeaf, MoreSmoothingIsFartherFromThePoints) {
  MeasuredCurve midrib = quarter_circle(15);
  for (std::size_t k = 1; k < 14; ++k) midrib.points[k].x += k % 2 == 0 ? 0.4 : -0.4;
  double last = -1;
  for (const double smoothing : {0.0, 0.002, 0.005, 0.02}) {
    const double now = fit_leaf(midrib, plain_widths(), {.smoothing = smoothing}).distance;
    EXPECT_GT(now, last);
    EXPECT_LE(now, smoothing * 32 + 0.1) << "what a chord cuts off at most";
    last = now;
  }
}

TEST(FitLeaf, StartsAtItsFirstPointAndItsPiecesAreEqual) {
  MeasuredCurve midrib = quarter_circle(9);
  for (glm::dvec2& point : midrib.points) point += glm::dvec2(-30, 100);
  const FittedLeaf fitted = fit_leaf(midrib, plain_widths(), {.pieces = 20});
  EXPECT_EQ(fitted.leaf.x[0], 0);
  EXPECT_EQ(fitted.leaf.y[0], 0);
  EXPECT_LT(largest_shift(fitted.leaf, fit_leaf(quarter_circle(9), plain_widths(), {.pieces = 20}).leaf), 1e-6);
  EXPECT_EQ(fitted.leaf.point_count(), 21U);
  EXPECT_NEAR(longest(fitted.leaf), 1, 1e-12);
  check_grass_leaf(fitted.leaf);
}

TEST(FitLeaf, FollowsTheUnitOfItsPoints) {
  MeasuredCurve midrib = quarter_circle(10);
  const FittedLeaf plain = fit_leaf(midrib, plain_widths());
  for (glm::dvec2& point : midrib.points) point *= 0.01;
  const FittedLeaf scaled = fit_leaf(midrib, plain_widths());
  EXPECT_NEAR(scaled.leaf.length, 0.01 * plain.leaf.length, 1e-8);
  EXPECT_EQ(scaled.leaf.width, plain.leaf.width);
  EXPECT_LT(largest_shift(plain.leaf, scaled.leaf), 1e-6);
}

TEST(FitLeaf, PlacesThatEndElsewhereThanAt1AreOfTheBladesOwnLength) {
  MeasuredCurve widths = plain_widths();
  for (glm::dvec2& point : widths.points) point *= glm::dvec2(34, 1.5);
  const FittedLeaf fitted = fit_leaf(quarter_circle(12), widths);
  EXPECT_EQ(fitted.leaf.length, 34);
  EXPECT_NEAR(fitted.midrib_length, 10 * kPi, 0.2) << "what was digitised is shorter";
  EXPECT_NEAR(fitted.leaf.width, 1.5, 0.03);
}

TEST(FitLeaf, TheWidestIsAtAPointAndNoShareIsOutside0To1) {
  const MeasuredCurve spike = curve({{0, 0.1}, {0.2, 0}, {0.4, 0}, {0.43, 1}, {0.46, 0}, {0.8, 0}, {1, 0.3}});
  for (const double smoothing : {0.0, 0.01, 0.3, 1.0}) {
    const GrassLeaf leaf = fit_leaf(quarter_circle(12), spike, {.width_smoothing = smoothing}).leaf;
    EXPECT_EQ(*std::max_element(leaf.r.begin(), leaf.r.end()), 1);
    EXPECT_GE(*std::min_element(leaf.r.begin(), leaf.r.end()), 0);
    check_grass_leaf(leaf);
  }
}

TEST(FitLeaf, ABladeNarrowerThanItsPiecesStaysABlade) {
  const MeasuredCurve spike = curve({{0, 0}, {0.505, 0}, {0.51, 2}, {0.515, 0}, {1, 0}});
  const GrassLeaf leaf = fit_leaf(quarter_circle(12), spike, {.width_smoothing = 0}).leaf;
  check_grass_leaf(leaf);
  EXPECT_EQ(leaf.width, 2);
  EXPECT_EQ(leaf.r[24], 1) << "the point nearest to 0.51";
}

TEST(FitLeaf, EndsOfWidthsStay) {
  const MeasuredCurve widths = curve({{0, 0.7}, {0.2, 0.95}, {0.4, 1}, {0.6, 0.9}, {0.8, 0.7}, {1, 0.25}});
  const GrassLeaf leaf = fit_leaf(quarter_circle(12), widths).leaf;
  EXPECT_NEAR(leaf.width * leaf.r.front(), 0.7, 1e-3);
  EXPECT_NEAR(leaf.width * leaf.r.back(), 0.25, 1e-3);
}

TEST(FitLeaf, WidthsThatBeginBeyondTheBaseAreAsWideBeforeIt) {
  const MeasuredCurve widths = curve({{0.25, 0.8}, {0.5, 1}, {1, 0}});
  const GrassLeaf leaf = fit_leaf(quarter_circle(12), widths, {.width_smoothing = 0}).leaf;
  for (std::size_t k = 0; leaf.s[k] <= 0.25; ++k) EXPECT_NEAR(leaf.r[k] * leaf.width, 0.8, 1e-6);
  const MeasuredCurve hardly = curve({{1e-300, 0.8}, {0.5, 1}, {1, 0}});
  check_grass_leaf(fit_leaf(quarter_circle(12), hardly).leaf);
}

TEST(FitLeaf, AProfileFromTheTipGivesTheSameLeaf) {
  MeasuredCurve turned = plain_widths();
  std::reverse(turned.points.begin(), turned.points.end());
  const FittedLeaf plain = fit_leaf(quarter_circle(12), plain_widths());
  const FittedLeaf falling = fit_leaf(quarter_circle(12), turned);
  EXPECT_FALSE(plain.was_turned);
  EXPECT_TRUE(falling.was_turned);
  EXPECT_EQ(falling.leaf.r, plain.leaf.r);
}

TEST(FitLeaf, HangingTipsLoopsAndBasesBehindTheStemKeepTheirForm) {
  const std::vector<MeasuredCurve> odd{
      curve({{0, 0}, {2, 9}, {6, 14}, {11, 12}, {13, 3}, {12.5, -6}}),            // hangs below its collar
      curve({{0, 0}, {-0.8, 3}, {-0.5, 7}, {2, 12}, {7, 15}}),                    // begins behind its stem
      curve({{0, 0}, {3, 6}, {8, 8}, {12, 5}, {11, 0}, {7, -1}, {5, 2}, {8, 4}})  // rolls up
  };
  for (const MeasuredCurve& midrib : odd) {
    const FittedLeaf fitted = fit_leaf(midrib, plain_widths());
    check_grass_leaf(fitted.leaf);
    EXPECT_LT(distance_of(fitted, midrib), 0.006);
  }
}

TEST(FitLeaf, AMidribThatTurnsBackOnItselfStaysFinite) {
  for (const double smoothing : {0.0, 0.003, 1.0}) {
    const FittedLeaf fitted =
        fit_leaf(curve({{0, 0}, {1, 0}, {0, 0}, {1, 0}, {0, 0}}), plain_widths(), {.smoothing = smoothing});
    check_grass_leaf(fitted.leaf);
    EXPECT_NEAR(longest(fitted.leaf), 1, 1e-9);
  }
}

TEST(FitLeaf, RejectsOptionsOutOfRangeAndBadCurves) {
  const MeasuredCurve midrib = quarter_circle(5), widths = plain_widths();
  EXPECT_THROW(fit_leaf(midrib, widths, {.smoothing = -0.1}), std::invalid_argument);
  EXPECT_THROW(fit_leaf(midrib, widths, {.width_smoothing = 1.1}), std::invalid_argument);
  EXPECT_THROW(fit_leaf(midrib, widths, {.smoothing = std::nan("")}), std::invalid_argument);
  EXPECT_THROW(fit_leaf(midrib, widths, {.pieces = 1}), std::invalid_argument);
  EXPECT_THROW(fit_leaf(curve({{0, 0}, {1, 1}}), widths), InputError);
  EXPECT_THROW(fit_leaf(midrib, curve({{0, 1}, {0.5, -1}, {1, 0}})), InputError);
}

TEST(FitLeafOfGrasses, PointsAreMetWithin15PerMilAnd7InTheMedian) {
  for (const MeasuredGrass& grass : measured_grasses()) {
    SCOPED_TRACE(grass.name);
    std::vector<double> distances;
    for (const MeasuredCurve& midrib : grass.midribs) {
      if (midrib.points.size() < 12) continue;
      const FittedLeaf fitted = fit_leaf(midrib, grass.widths[0]);
      distances.push_back(distance_of(fitted, midrib));
      EXPECT_NEAR(fitted.distance / fitted.midrib_length, distances.back(), 5e-4) << "line " << midrib.lines[0];
      EXPECT_LT(distances.back(), 0.015) << "line " << midrib.lines[0];
    }
    EXPECT_GT(distances.size(), 4 * grass.midribs.size() / 9);
    EXPECT_LT(median(distances), 0.007);
  }
}

TEST(FitLeafOfGrasses, SmoothMidribsKeepTheirLengthWithinOnePercent) {
  for (const MeasuredGrass& grass : measured_grasses()) {
    SCOPED_TRACE(grass.name);
    for (const MeasuredCurve& midrib : grass.by_age) {
      const FittedLeaf fitted = fit_leaf(midrib, grass.widths[0]);
      EXPECT_NEAR(fitted.midrib_length / fitted.polyline_length, 1, 0.01) << "line " << midrib.lines[0];
    }
  }
}

TEST(FitLeaf, FewRowsOfWidthsKeepTheirArea) {
  const std::vector<std::vector<glm::dvec2>> blades{{{0, 0.6}, {0.5, 1}, {1, 0}},
                                                    {{0, 0.4}, {0.3, 1}, {1, 0}},
                                                    {{0, 0.7}, {0.35, 1}, {0.7, 0.7}, {1, 0}},
                                                    {{0, 0.1}, {0.2, 1}, {0.6, 1}, {1, 0}},
                                                    {{0, 1}, {0.9, 0.9}, {1, 0}}};
  for (const std::vector<glm::dvec2>& points : blades) {
    const MeasuredCurve widths{.points = points};
    const FittedLeaf fitted = fit_leaf(quarter_circle(12), widths);
    EXPECT_NEAR(area(fitted.leaf) / (fitted.leaf.length * trapezoids(widths)), 1, 0.02) << points[1].x;
    EXPECT_NEAR(fitted.leaf.width, 1, 0.05) << points[1].x;
  }
}

TEST(FitLeafOfGrasses, AllSurviveWithWidthsOfAnyClassAndKeepTheirAreaWithin2Percent) {
  for (const MeasuredGrass& grass : measured_grasses()) {
    SCOPED_TRACE(grass.name);
    for (const MeasuredCurve& midrib : grass.midribs) {
      for (const MeasuredCurve& widths : grass.widths) {
        const FittedLeaf fitted = fit_leaf(midrib, widths);
        check_grass_leaf(fitted.leaf);
        EXPECT_NEAR(area(fitted.leaf) / (fitted.leaf.length * trapezoids(widths)), 1, 0.02)
            << "line " << midrib.lines[0] << ", class " << *widths.rank;
      }
    }
  }
}

}  // namespace meristem::fit_leaf_test
