// SPDX-License-Identifier: Apache-2.0
#include "meristem/shape/grass/grass_leaf.h"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "meristem/base/vec.h"
#include "tests/support/grass_leaves.h"

namespace meristem::grass_leaf_test {

/// Returns the angle reduced to half a turn to either side.
double around(double angle) { return std::remainder(angle, 2 * kPi); }

TEST(GrassLeaf, AreaIsThatOfItsTrapezia) {
  GrassLeaf leaf = arching_leaf(3, 0.2, 1.9);
  EXPECT_NEAR(area(leaf), leaf.length * leaf.width, 1e-15);
  leaf.r = {0.5, 1, 0.75, 0};
  EXPECT_NEAR(area(leaf), leaf.length * leaf.width * (0.75 + 0.875 + 0.375) / 3, 1e-15);
}

TEST(GrassLeaf, AnglesOfPiecesAreThoseItWasMadeOf) {
  const std::vector<double> angles = piece_angles(arching_leaf(10, -0.3, 2.7));
  for (std::size_t k = 0; k < 10; ++k) {
    EXPECT_NEAR(angles[k], -0.3 + 3.0 * (static_cast<double>(k) + 0.5) / 10, 1e-12);
  }
}

TEST(GrassLeaf, AnglesOfALeafThatRollsUpGoOnBeyondPi) {
  const std::vector<double> angles = piece_angles(arching_leaf(200, 0, 15));
  EXPECT_NEAR(angles.back(), 15 - 0.5 * 15 / 200, 1e-9);
  const std::vector<double> other = piece_angles(arching_leaf(200, 0, -15));
  EXPECT_NEAR(other.back(), -15 + 0.5 * 15 / 200, 1e-9);
}

TEST(GrassLeaf, PutTogetherAnewFromItsAnglesItIsTheSame) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const GrassLeaf leaf = random_leaf(RandomKey(seed), 30);
    GrassLeaf again = leaf;
    set_piece_angles(again, piece_angles(leaf));
    EXPECT_LT(largest_shift(leaf, again), 1e-12);
  }
}

TEST(GrassLeaf, AnglesThatDifferByWholeTurnsAreOneForm) {
  const GrassLeaf leaf = random_leaf(RandomKey(3), 12);
  std::vector<double> angles = piece_angles(leaf);
  for (std::size_t k = 0; k < angles.size(); k += 2) angles[k] += 2 * kPi;
  GrassLeaf again = leaf;
  set_piece_angles(again, angles);
  const std::vector<double> read = piece_angles(again);
  for (std::size_t k = 0; k < angles.size(); ++k) EXPECT_NEAR(around(read[k] - angles[k]), 0, 1e-9);
}

TEST(GrassLeaf, ResampledToAsManyEqualPiecesItStays) {
  const GrassLeaf leaf = random_leaf(RandomKey(4), 25);
  const GrassLeaf again = resampled(leaf, 25);
  EXPECT_LT(largest_shift(leaf, again), 1e-12);
  for (std::size_t k = 0; k < leaf.point_count(); ++k) EXPECT_NEAR(again.r[k], leaf.r[k], 1e-12);
}

TEST(GrassLeaf, ResamplingConvergesAtSecondOrder) {
  const auto error = [](std::size_t pieces) {
    const GrassLeaf coarse = resampled(arching_leaf(480, 0.1, 2), pieces);
    return std::hypot(coarse.x.back() - arching_leaf(480, 0.1, 2).x.back(),
                      coarse.y.back() - arching_leaf(480, 0.1, 2).y.back());
  };
  EXPECT_LT(error(12), 1e-3);
  EXPECT_NEAR(error(6) / error(12), 4, 0.3);
}

TEST(GrassLeaf, ResamplingKeepsTheLength) {
  const GrassLeaf leaf = resampled(random_leaf(RandomKey(5), 40), 7);
  double length = 0;
  for (std::size_t k = 1; k < leaf.point_count(); ++k) {
    length += std::hypot(leaf.x[k] - leaf.x[k - 1], leaf.y[k] - leaf.y[k - 1]);
  }
  EXPECT_NEAR(length, 1, 1e-12);
  EXPECT_EQ(leaf.s.back(), 1);
  check_grass_leaf(leaf);
}

TEST(GrassLeaf, NumbersAlongItAreLinearBetweenPoints) {
  const GrassLeaf leaf = arching_leaf(4, 0, 1);
  const std::vector<double> list{3, 5, 1, 0, 8};
  EXPECT_EQ(along_leaf(leaf, list, -1), 3);
  EXPECT_EQ(along_leaf(leaf, list, 0.125), 4);
  EXPECT_EQ(along_leaf(leaf, list, 0.75), 0);
  EXPECT_EQ(along_leaf(leaf, list, 0.9375), 6);
  EXPECT_EQ(along_leaf(leaf, list, 1), 8);
}

TEST(GrassLeaf, AnglesAlongItAreLinearBetweenMiddlesOfPieces) {
  const GrassLeaf leaf = arching_leaf(4, 0, 1);
  const std::vector<double> angles{0.1, 0.3, 0.7, 0.2};
  EXPECT_EQ(angle_along(leaf, angles, 0), 0.1);
  EXPECT_EQ(angle_along(leaf, angles, 0.125), 0.1);
  EXPECT_NEAR(angle_along(leaf, angles, 0.25), 0.2, 1e-15);
  EXPECT_NEAR(angle_along(leaf, angles, 0.5), 0.5, 1e-15);
  EXPECT_EQ(angle_along(leaf, angles, 1), 0.2);
}

TEST(GrassLeaf, RejectsWhatIsNoLeaf) {
  const auto error_of = [](auto change) {
    GrassLeaf leaf = arching_leaf(4, 0, 1);
    change(leaf);
    EXPECT_THROW(check_grass_leaf(leaf), std::invalid_argument);
  };
  check_grass_leaf(arching_leaf(4, 0, 1));
  error_of([](GrassLeaf& leaf) { leaf.length = 0; });
  error_of([](GrassLeaf& leaf) { leaf.width = -1; });
  error_of([](GrassLeaf& leaf) { leaf.width = std::numeric_limits<double>::infinity(); });
  error_of([](GrassLeaf& leaf) { leaf.x.pop_back(); });
  error_of([](GrassLeaf& leaf) { leaf.s = leaf.x = leaf.y = leaf.r = {0}; });
  error_of([](GrassLeaf& leaf) { leaf.s[2] = leaf.s[1]; });
  error_of([](GrassLeaf& leaf) { leaf.s[0] = 0.01; });
  error_of([](GrassLeaf& leaf) { leaf.s[4] = 1.01; });
  error_of([](GrassLeaf& leaf) { leaf.r[2] = -0.1; });
  error_of([](GrassLeaf& leaf) { leaf.y[2] = std::nan(""); });
}

}  // namespace meristem::grass_leaf_test
