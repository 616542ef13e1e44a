// SPDX-License-Identifier: Apache-2.0
// Compares trees that respond to light with the published evaluation, and light response B with trees that do not use
// it. The tests check trends over ten clouds, with the tolerances in the specification of space colonization.
//
// Based on: J. Jansen, Space Colonization-gestützte Generierung realitätskonformer Vegetationsszenarien, TU Dortmund
// 2020, chapter 5.
#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/evaluation.h"

namespace meristem::light_growth_test {

/// Returns the difference of two azimuths, degrees.
double apart(double a, double b) { return std::abs(std::remainder(a - b, 360)); }

/// Returns the evaluations of 11 shifts: 0, `step`, 2 `step`, ... metres.
std::vector<Evaluation> shifted(const Scene& scene) {
  std::vector<Evaluation> means;
  for (int k = 0; k <= 10; ++k) means.push_back(evaluate(scene, {.shift = 0.001 * k}));
  return means;
}

/// Returns the share of the variance that a straight line explains, for values at equal distances.
double explained_by_a_line(const std::vector<Evaluation>& means, double Evaluation::*value) {
  const auto count = static_cast<double>(means.size());
  double x_mean = (count - 1) / 2;
  double y_mean = 0;
  for (const Evaluation& mean : means) y_mean += mean.*value / count;
  double xx = 0;
  double xy = 0;
  double yy = 0;
  for (std::size_t k = 0; k < means.size(); ++k) {
    const double x = static_cast<double>(k) - x_mean;
    const double y = means[k].*value - y_mean;
    xx += x * x;
    xy += x * y;
    yy += y * y;
  }
  return xy * xy / (xx * yy);
}

TEST(LightGrowth, RootsOfTheWalledSceneAreInShadeAroundNoonOnly) {
  const Scene scene = evaluation_scene_b();
  ASSERT_EQ(scene.light.sun.size(), 15U);
  for (std::size_t k = 0; k < 15; ++k) {
    const bool is_noon = k >= 6 && k <= 8;  // 11, 12 and 13 h
    EXPECT_EQ(scene.obstacles.first_hit(Vec3(0), scene.light.sun[k].toward, 1e9).has_value(), is_noon) << k;
  }
}

TEST(LightGrowth, ShiftedCloudsLeanTowardAStillSun) {
  const std::vector<Evaluation> means = shifted(evaluation_scene_a());
  EXPECT_GT(means[0].spread, 45);
  for (std::size_t k = 5; k <= 10; ++k) EXPECT_LT(apart(means[k].azimuth, 180), 6) << k;
  for (std::size_t k = 2; k <= 10; ++k) EXPECT_LT(means[k].altitude, means[k - 1].altitude) << k;
  EXPECT_NEAR(means[0].altitude, 88.8, 1.5);
  EXPECT_NEAR(means[10].altitude, 67.4, 1.5);
  EXPECT_GE(explained_by_a_line(means, &Evaluation::altitude), 0.95);
  EXPECT_NEAR(means[0].height, 3.6, 0.2);
  EXPECT_NEAR(means[10].height, 6.8, 0.2);
  EXPECT_GT(means[0].lit_share - means[10].lit_share, 3);
  EXPECT_LT(means[0].lit_share - means[10].lit_share, 8);
}

TEST(LightGrowth, ShiftedCloudsFleeABuildingUntilTheyRiseAboveItsShade) {
  const std::vector<Evaluation> means = shifted(evaluation_scene_b());
  for (std::size_t k = 2; k <= 6; ++k) EXPECT_LT(apart(means[k].azimuth, 0), 30) << k;
  for (std::size_t k = 9; k <= 10; ++k) EXPECT_LT(apart(means[k].azimuth, 180), 20) << k;
  // The lowest altitude is among small shifts, and the highest where north and south are in balance.
  const auto lower = [](const Evaluation& a, const Evaluation& b) { return a.altitude < b.altitude; };
  const auto lowest = std::min_element(means.begin() + 1, means.begin() + 7, lower) - means.begin();
  EXPECT_GE(lowest, 3);
  EXPECT_LE(lowest, 5);
  const auto highest = std::max_element(means.begin() + 1, means.end(), lower) - means.begin();
  EXPECT_GE(highest, 7);
  EXPECT_LE(highest, 8);
  const auto scatters = [](const Evaluation& a, const Evaluation& b) { return a.spread < b.spread; };
  const auto widest = std::max_element(means.begin() + 1, means.end(), scatters) - means.begin();
  EXPECT_GE(widest, 7);
  EXPECT_LE(widest, 8);
  for (std::size_t k = 1; k <= 10; ++k) EXPECT_LT(apart(means[k].centroid_azimuth, 0), 30) << k;
  const auto nearer = [](const Evaluation& a, const Evaluation& b) { return a.centroid_radius < b.centroid_radius; };
  const auto farthest = std::max_element(means.begin(), means.end(), nearer) - means.begin();
  EXPECT_GE(farthest, 6);
  EXPECT_LE(farthest, 8);
  EXPECT_GE(means[10].lit_share - means[0].lit_share, 5);
  EXPECT_LE(means[10].lit_share - means[0].lit_share, 7);
}

TEST(LightGrowth, ShiftedCloudsOfTheRightSizeGainLightAtTheSameHeight) {
  const Evaluation still = evaluate_at_height(evaluation_scene_b(), {}, 3.7);
  const Evaluation shifted = evaluate_at_height(evaluation_scene_b(), {.shift = 0.005}, 3.7);
  EXPECT_NEAR(still.height, 3.7, 0.05);
  EXPECT_NEAR(shifted.height, 3.7, 0.05);
  EXPECT_GE(shifted.lit_share - still.lit_share, 0.8);
  EXPECT_LE(shifted.lit_share - still.lit_share, 2.5);
}

TEST(LightGrowth, LimitedSpaceLightsMoreOfTheCrownAtTheSameHeight) {
  const Evaluation plain = evaluate(evaluation_scene_a(), {});
  const Evaluation third = evaluate(evaluation_scene_a(), {.limit = {.share = 0.36, .radius = 0.3, .k = 0.1}});
  const Evaluation max = evaluate(evaluation_scene_a(), {.limit = {.share = 0.6, .radius = 0.3, .k = 0.1}});
  EXPECT_GE(third.lit_share - plain.lit_share, 4);
  EXPECT_GE(max.lit_share - plain.lit_share, 8);
  EXPECT_NEAR(third.height, plain.height, 0.02 * plain.height);
  EXPECT_NEAR(max.height, plain.height, 0.02 * plain.height);
}

TEST(LightGrowth, DriftingPointsOfHeldHeightGainTheDaysLightBesideABuilding) {
  const Evaluation plain = evaluate(evaluation_scene_b(), {});
  const Evaluation drifting =
      evaluate(evaluation_scene_b(), {.drift = 0.018, .sunlit_weight = 0.25, .hold_height = true});
  EXPECT_GE(drifting.lit_share - plain.lit_share, 6);
  EXPECT_NEAR(drifting.height, plain.height, 0.02 * plain.height);
}

}  // namespace meristem::light_growth_test
