// SPDX-License-Identifier: Apache-2.0
#include "meristem/shape/grass/bend_leaf.h"

#include <cmath>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "meristem/base/vec.h"
#include "tests/support/grass_leaves.h"

namespace meristem::bend_leaf_test {

testing::AssertionResult keeps_its_pieces(const GrassLeaf& before, const GrassLeaf& after) {
  for (std::size_t k = 1; k < before.point_count(); ++k) {
    const double a = std::hypot(before.x[k] - before.x[k - 1], before.y[k] - before.y[k - 1]);
    const double b = std::hypot(after.x[k] - after.x[k - 1], after.y[k] - after.y[k - 1]);
    if (!(std::abs(a - b) < 1e-12)) return testing::AssertionFailure() << "piece " << k << ": " << a << ", " << b;
  }
  return testing::AssertionSuccess();
}

TEST(BendLeaf, NoTurnsChangeNothing) {
  const GrassLeaf leaf = random_leaf(RandomKey(1), 20);
  EXPECT_LT(largest_shift(turned(leaf, {}), leaf), 1e-12);
  EXPECT_LT(largest_shift(turned(leaf, {{.from = 0.2, .to = 0.6, .angle = 0}}), leaf), 1e-12);
}

TEST(BendLeaf, AllBeyondATurnIsTurnedByItsAngle) {
  const GrassLeaf leaf = random_leaf(RandomKey(2), 40);
  const GrassLeaf now = turned(leaf, {{.from = 0.3, .to = 0.5, .angle = 0.8}});
  const std::vector<double> before = piece_angles(leaf), after = piece_angles(now);
  for (std::size_t k = 0; k < 40; ++k) {
    const double middle = (static_cast<double>(k) + 0.5) / 40;
    EXPECT_NEAR(after[k] - before[k], 0.8 * std::clamp((middle - 0.3) / 0.2, 0.0, 1.0), 1e-9);
  }
  EXPECT_TRUE(keeps_its_pieces(leaf, now));
}

TEST(BendLeaf, AKinkTurnsAtOneJoint) {
  const GrassLeaf now = turned(arching_leaf(10, 0.4, 0.4), {{.from = 0.5, .to = 0.5, .angle = kPi / 2}});
  const std::vector<double> angles = piece_angles(now);
  EXPECT_NEAR(angles[4], 0.4, 1e-12);
  EXPECT_NEAR(angles[5], 0.4 + kPi / 2, 1e-12);
}

TEST(BendLeaf, TurnsAddUpInAnyOrder) {
  const GrassLeaf leaf = random_leaf(RandomKey(3), 30);
  const LocalTurn a{.from = 0.1, .to = 0.7, .angle = 0.5}, b{.from = 0.4, .to = 0.5, .angle = -1.2};
  const GrassLeaf both = turned(leaf, {a, b});
  EXPECT_LT(largest_shift(both, turned(leaf, {b, a})), 1e-12);
  EXPECT_LT(largest_shift(both, turned(turned(leaf, {b}), {a})), 1e-12);
  EXPECT_LT(largest_shift(turned(both, {{a.from, a.to, -a.angle}, {b.from, b.to, -b.angle}}), leaf), 1e-12);
}

TEST(BendLeaf, AnEvenTurnOfAStraightLeafIsAnArc) {
  const GrassLeaf now = turned(arching_leaf(400, 0, 0), {{.from = 0, .to = 1, .angle = kPi / 2}});
  EXPECT_NEAR(now.x.back(), 2 / kPi, 1e-5);
  EXPECT_NEAR(now.y.back(), 2 / kPi, 1e-5);
}

TEST(BendLeaf, InclinedItLeavesTheStemAtTheAngleAskedFor) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const GrassLeaf leaf = random_leaf(RandomKey(seed), 15);
    for (const double angle : {-0.5, 0.0, 0.7, 2.5}) {
      const GrassLeaf now = inclined(leaf, angle);
      EXPECT_NEAR(inclination(now), angle, 1e-12);
      EXPECT_TRUE(keeps_its_pieces(leaf, now));
      EXPECT_NEAR(std::hypot(now.x.back(), now.y.back()), std::hypot(leaf.x.back(), leaf.y.back()), 1e-12);
    }
    EXPECT_LT(largest_shift(inclined(inclined(leaf, 2), inclination(leaf)), leaf), 1e-12);
  }
}

TEST(BendLeaf, WidenedItIsWiderAtThePlaceAlone) {
  const GrassLeaf leaf = arching_leaf(100, 0, 1);
  for (const double factor : {0.0, 0.5, 1.0, 3.0}) {
    const GrassLeaf now = widened(leaf, {{.from = 0.2, .to = 0.6, .factor = factor}});
    EXPECT_TRUE(keeps_its_pieces(leaf, now));
    for (std::size_t k = 0; k < leaf.point_count(); ++k) {
      const double before = leaf.width * leaf.r[k], after = now.width * now.r[k];
      const bool is_inside = leaf.s[k] > 0.2 && leaf.s[k] < 0.6;
      const double most = is_inside ? std::abs(factor - 1) * before : 0;
      EXPECT_LE(std::abs(after - before), most + 1e-12) << leaf.s[k];
      EXPECT_LE(now.r[k], 1 + 1e-12);
    }
    const double middle = now.width * along_leaf(now, now.r, 0.4), plain = leaf.width * along_leaf(leaf, leaf.r, 0.4);
    EXPECT_NEAR(middle, factor * plain, 1e-3 * plain) << factor;
  }
}

TEST(BendLeaf, RejectsWidthsOutOfRange) {
  const GrassLeaf leaf = arching_leaf(5, 0, 1);
  EXPECT_THROW(widened(leaf, {{.from = 0.5, .to = 0.5, .factor = 1}}), std::invalid_argument);
  EXPECT_THROW(widened(leaf, {{.from = 0.5, .to = 1.5, .factor = 1}}), std::invalid_argument);
  EXPECT_THROW(widened(leaf, {{.from = 0, .to = 1, .factor = -1}}), std::invalid_argument);
  EXPECT_THROW(widened(leaf, {{.from = 0, .to = 1, .factor = std::nan("")}}), std::invalid_argument);
}

TEST(BendLeaf, RejectsPlacesOutOfRange) {
  const GrassLeaf leaf = arching_leaf(5, 0, 1);
  EXPECT_THROW(turned(leaf, {{.from = -0.1, .to = 0.5, .angle = 1}}), std::invalid_argument);
  EXPECT_THROW(turned(leaf, {{.from = 0.5, .to = 0.4, .angle = 1}}), std::invalid_argument);
  EXPECT_THROW(turned(leaf, {{.from = 0.5, .to = 1.1, .angle = 1}}), std::invalid_argument);
  EXPECT_THROW(turned(leaf, {{.from = std::nan(""), .to = 1, .angle = 1}}), std::invalid_argument);
}

}  // namespace meristem::bend_leaf_test
