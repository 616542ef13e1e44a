// SPDX-License-Identifier: Apache-2.0
#include "meristem/shape/grass/reduce_leaf.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/grass_leaves.h"

namespace meristem::reduce_leaf_test {

using Indices = std::vector<std::uint32_t>;

double distance_to_chord(const std::vector<double>& x, const std::vector<double>& y, std::size_t a, std::size_t k,
                         std::size_t b) {
  const glm::dvec2 from(x[a], y[a]), along = glm::dvec2(x[b], y[b]) - from, point(x[k], y[k]);
  const double square = glm::dot(along, along);
  const double share = square > 0 ? std::clamp(glm::dot(point - from, along) / square, 0.0, 1.0) : 0;
  return glm::distance(point, from + share * along);
}

/// Returns the order with all errors recomputed in every step.
ReductionOrder plain_order(const GrassLeaf& leaf, const std::vector<std::vector<double>>& also = {}) {
  ReductionOrder order;
  Indices left;
  for (std::size_t k = 0; k < leaf.point_count(); ++k) left.push_back(static_cast<std::uint32_t>(k));
  double largest = 0;
  while (left.size() > 2) {
    std::size_t best = 0;
    double min = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i + 1 < left.size(); ++i) {
      const std::size_t a = left[i - 1], k = left[i], b = left[i + 1];
      double square = std::pow(distance_to_chord(leaf.x, leaf.y, a, k, b), 2) +
                      std::pow(distance_to_chord(leaf.s, leaf.r, a, k, b), 2);
      for (const std::vector<double>& list : also) square += std::pow(distance_to_chord(leaf.s, list, a, k, b), 2);
      if (square < min) min = square, best = i;
    }
    largest = std::max(largest, std::sqrt(min));
    order.points.push_back(left[best]);
    order.errors.push_back(largest);
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(best));
  }
  return order;
}

/// Returns the Hausdorff distance of two midribs, from points to curves, both ways.
double hausdorff(const GrassLeaf& a, const GrassLeaf& b) {
  double largest = 0;
  for (std::size_t k = 0; k < a.point_count(); ++k)
    largest = std::max(largest, distance_to_midrib({a.x[k], a.y[k]}, b));
  for (std::size_t k = 0; k < b.point_count(); ++k)
    largest = std::max(largest, distance_to_midrib({b.x[k], b.y[k]}, a));
  return largest;
}

TEST(ReduceLeaf, GoesInTheOrderThatRescanningAllErrorsGives) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const GrassLeaf leaf = random_leaf(RandomKey(seed), 2 + seed * 3);
    const ReductionOrder order = reduction_order(leaf), plain = plain_order(leaf);
    EXPECT_EQ(order.points, plain.points) << seed;
    for (std::size_t k = 0; k < order.errors.size(); ++k) EXPECT_NEAR(order.errors[k], plain.errors[k], 1e-12);
  }
}

TEST(ReduceLeaf, FurtherFunctionsCountLikeWidths) {
  const GrassLeaf leaf = random_leaf(RandomKey(5), 60);
  const std::vector<std::vector<double>> also{random_leaf(RandomKey(6), 60).r, random_leaf(RandomKey(7), 60).r};
  EXPECT_EQ(reduction_order(leaf, also).points, plain_order(leaf, also).points);
  const GrassLeaf even = arching_leaf(60, 0.3, 0.3);
  GrassLeaf uneven = even;
  uneven.r = also[0];
  EXPECT_EQ(reduction_order(even, {also[0]}).points, reduction_order(uneven).points);
}

TEST(ReduceLeaf, EqualErrorsGoByTheLowerIndex) {
  // In a zigzag of exact numbers, every point is equally far from the chord of its neighbours.
  GrassLeaf zigzag = arching_leaf(8, 0, 0);
  zigzag.x = {0, 0.125, 0, 0.125, 0, 0.125, 0, 0.125, 0};
  for (std::size_t k = 0; k < 9; ++k) zigzag.y[k] = 0.125 * static_cast<double>(k);
  EXPECT_EQ(reduction_order(zigzag).points[0], 1U);
  EXPECT_EQ(reduction_order(zigzag).points, plain_order(zigzag).points);
}

TEST(ReduceLeaf, EveryInnerPointGoesOnceAndErrorsRise) {
  const ReductionOrder order = reduction_order(random_leaf(RandomKey(8), 100));
  Indices sorted = order.points;
  std::sort(sorted.begin(), sorted.end());
  ASSERT_EQ(sorted.size(), 99U);
  for (std::uint32_t k = 0; k < 99; ++k) EXPECT_EQ(sorted[k], k + 1);
  EXPECT_TRUE(std::is_sorted(order.errors.begin(), order.errors.end()));
}

TEST(ReduceLeaf, EndsStayAndCountsAreThoseAskedFor) {
  const ReductionOrder order = reduction_order(random_leaf(RandomKey(9), 50));
  for (std::size_t pieces = 0; pieces < 60; ++pieces) {
    const Indices kept = points_kept(order, pieces);
    EXPECT_EQ(kept.size(), std::clamp<std::size_t>(pieces, 1, 50) + 1);
    EXPECT_EQ(kept.front(), 0U);
    EXPECT_EQ(kept.back(), 50U);
    EXPECT_TRUE(std::is_sorted(kept.begin(), kept.end()));
  }
}

TEST(ReduceLeaf, CoarserLevelsArePartsOfFinerOnes) {
  const ReductionOrder order = reduction_order(random_leaf(RandomKey(10), 80));
  Indices finer = points_kept(order, 80);
  for (std::size_t pieces = 79; pieces > 0; --pieces) {
    const Indices coarser = points_kept(order, pieces);
    EXPECT_TRUE(std::includes(finer.begin(), finer.end(), coarser.begin(), coarser.end()));
    finer = coarser;
  }
}

TEST(ReduceLeaf, AreaAndLengthAreKept) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const GrassLeaf leaf = random_leaf(RandomKey(seed), 60);
    const ReductionOrder order = reduction_order(leaf);
    for (const std::size_t pieces : {1, 2, 5, 20, 60}) {
      const GrassLeaf now = reduced(leaf, points_kept(order, pieces));
      EXPECT_NEAR(area(now) / area(leaf), 1, 1e-12);
      EXPECT_EQ(now.length, leaf.length);
      EXPECT_EQ(now.x.back(), leaf.x.back());
      check_grass_leaf(now);
    }
  }
}

TEST(ReduceLeaf, AStraightLeafOfOneWidthIsOnePieceWithoutError) {
  const GrassLeaf leaf = arching_leaf(40, 0.5, 0.5);
  const Indices kept = points_within(reduction_order(leaf), 1e-12);
  EXPECT_EQ(kept, (Indices{0, 40}));
  EXPECT_NEAR(reduced(leaf, kept).width, leaf.width, 1e-12);
}

TEST(ReduceLeaf, AKinkAndTheWidestPlaceStayUntilTheLast) {
  GrassLeaf leaf = arching_leaf(40, 0.5, 0.5);
  for (std::size_t k = 26; k <= 40; ++k) leaf.x[k] += 0.1 * static_cast<double>(k - 25) / 15;
  for (std::size_t k = 0; k <= 40; ++k) leaf.r[k] = k < 10 ? 0.5 + 0.05 * static_cast<double>(k) : 1;
  EXPECT_EQ(points_within(reduction_order(leaf), 1e-9), (Indices{0, 10, 25, 40}));
}

TEST(ReduceLeaf, WithinAnErrorNoStepCostsMore) {
  const GrassLeaf leaf = with_blade(arching_leaf(60, 0.1, 2.5));
  const ReductionOrder order = reduction_order(leaf);
  std::size_t last = 100;
  for (const double error : {0.0, 1e-4, 1e-3, 1e-2, 1.0}) {
    const Indices kept = points_within(order, error);
    const std::size_t gone = 61 - kept.size();
    EXPECT_TRUE(gone == 0 || order.errors[gone - 1] <= error);
    EXPECT_TRUE(gone == 59 || order.errors[gone] > error);
    EXPECT_LE(kept.size(), last);
    last = kept.size();
    // Errors of steps add up, but only little.
    EXPECT_LE(hausdorff(reduced(leaf, kept), leaf), 3 * error + 1e-12);
  }
}

TEST(ReduceLeaf, ALeafOfTwoPointsHasNothingToLose) {
  const GrassLeaf leaf = arching_leaf(1, 0, 0);
  EXPECT_TRUE(reduction_order(leaf).points.empty());
  EXPECT_EQ(points_kept(reduction_order(leaf), 5), (Indices{0, 1}));
}

TEST(ReduceLeaf, ABladeWithoutAreaStaysAsWide) {
  GrassLeaf leaf = arching_leaf(4, 0, 1);
  leaf.r = {0, 0, 1, 0, 0};
  const GrassLeaf now = reduced(leaf, {0, 4});
  EXPECT_EQ(now.width, leaf.width);
}

TEST(ReduceLeaf, RejectsListsOfOtherLengths) {
  EXPECT_THROW(reduction_order(arching_leaf(4, 0, 1), {{1, 2}}), std::invalid_argument);
  EXPECT_THROW(reduction_order(GrassLeaf{}), std::invalid_argument);
}

TEST(ReduceLeaf, TenPiecesOfMeasuredLeavesAreWithinOnePercentOfAHundredInTheMedian) {
  for (const auto& [name, midribs, by_age, widths] : measured_grasses()) {
    SCOPED_TRACE(name);
    std::vector<double> distances;
    for (std::size_t k = 0; k < midribs.size(); ++k) {
      const GrassLeaf leaf = fit_leaf(midribs[k], widths[k % widths.size()], {.pieces = 99}).leaf;
      const GrassLeaf now = reduced(leaf, points_kept(reduction_order(leaf), 9));
      EXPECT_EQ(now.point_count(), 10U);
      EXPECT_NEAR(area(now) / area(leaf), 1, 1e-6);
      distances.push_back(hausdorff(now, leaf));
    }
    EXPECT_LT(median(distances), 0.01);
  }
}

}  // namespace meristem::reduce_leaf_test
