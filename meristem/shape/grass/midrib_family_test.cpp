// SPDX-License-Identifier: Apache-2.0
#include "meristem/shape/grass/midrib_family.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/grass_leaves.h"

namespace meristem::midrib_family_test {

using AgedMidribs = std::vector<std::pair<double, GrassLeaf>>;

const GrassLeaf kLeaf = with_blade(arching_leaf(48, 0.2, 2.4));

double midrib_length(const GrassLeaf& leaf) {
  double length = 0;
  for (std::size_t k = 1; k < leaf.point_count(); ++k) {
    length += std::hypot(leaf.x[k] - leaf.x[k - 1], leaf.y[k] - leaf.y[k - 1]);
  }
  return length;
}

testing::AssertionResult are_alike(const GrassLeaf& a, const GrassLeaf& b, double tolerance) {
  if (a.point_count() != b.point_count()) return testing::AssertionFailure() << "other points";
  double widths = 0;
  for (std::size_t k = 0; k < a.point_count(); ++k) {
    widths = std::max(widths, std::abs(a.width * a.r[k] - b.width * b.r[k]) / b.width);
  }
  const double shift = largest_shift(a, b), length = std::abs(a.length / b.length - 1);
  const bool holds = shift <= tolerance && widths <= tolerance && length <= tolerance;
  return holds ? testing::AssertionSuccess()
               : testing::AssertionFailure() << "shift " << shift << ", widths " << widths << ", length " << length;
}

/// Returns kLeaf after a life with constant rates.
GrassLeaf lived_with(GrowthRates rates, double time = 1, double step = 0.01) {
  return lived(kLeaf, MidribFamily(kLeaf), time, step, [rates](double, double) { return rates; });
}

TEST(MidribFamily, OneLeafIsStraightAtAge0AndItselfAtAge1) {
  const MidribFamily family(kLeaf);
  for (const double angle : family.angles(0)) EXPECT_EQ(angle, 0);
  EXPECT_TRUE(are_alike(aged(kLeaf, family, 1), kLeaf, 1e-12));
  const std::vector<double> half = family.angles(0.5), own = piece_angles(kLeaf);
  for (std::size_t k = 0; k < own.size(); ++k) EXPECT_NEAR(half[k], 0.5 * own[k], 1e-12);
}

TEST(MidribFamily, AtTheAgesGivenItIsTheMidribsGiven) {
  const AgedMidribs midribs{
      {2, arching_leaf(20, 0, 0.5)}, {5, arching_leaf(20, 0.2, 1)}, {6, arching_leaf(20, 0.4, 2.6)}};
  const MidribFamily family(midribs);
  EXPECT_EQ(family.first_age(), 2);
  EXPECT_EQ(family.last_age(), 6);
  for (const auto& [age, leaf] : midribs) EXPECT_LT(largest_shift(aged(leaf, family, age), leaf), 1e-12);
  EXPECT_LT(largest_shift(aged(kLeaf, family, 99), midribs.back().second), 1e-12) << "older than all";
}

/// Returns an upright leaf that is turned by `angle` degrees from `fold` of its length on, so that it hangs down.
GrassLeaf folded_leaf(std::size_t pieces, double fold, double angle) {
  GrassLeaf leaf = arching_leaf(pieces, 0, 0);
  std::vector<double> angles(pieces, 0);
  for (std::size_t k = 0; k < pieces; ++k) {
    if (static_cast<double>(k) >= fold * static_cast<double>(pieces)) angles[k] = radians(angle);
  }
  set_piece_angles(leaf, angles);
  return leaf;
}

TEST(MidribFamily, AFoldRemainsAFoldBetweenAges) {
  // The fold alternates between angles below and above half a turn, which is a fold to the other side. Its position
  // also moves.
  for (const double second : {165.0, 178.0, 184.0, 195.0}) {
    for (const double place : {0.5, 0.55}) {
      const MidribFamily family(AgedMidribs{
          {0, folded_leaf(40, 0.5, 172)}, {1, folded_leaf(40, place, second)}, {2, folded_leaf(40, 0.5, 170)}});
      for (const double age : {0.25, 0.5, 0.75, 1.25, 1.5}) {
        const GrassLeaf between = aged(kLeaf, family, age, 0.01);
        EXPECT_LT(between.y.back(), 0.25) << second << " at " << age << ": the tip hangs beside the base";
        EXPECT_LT(std::cos(family.angles(age).back()), -0.9) << second << " at " << age;
      }
    }
  }
}

TEST(MidribFamily, ACurlIsUnrolledAndNotWoundTheOtherWay) {
  const MidribFamily family(AgedMidribs{{0, arching_leaf(40, 0, 0)}, {1, arching_leaf(40, 0, 3 * kPi)}});
  EXPECT_NEAR(family.angles(1).back(), 3 * kPi * 39.5 / 40, 1e-6);
  EXPECT_NEAR(family.angles(0.5).back(), 1.5 * kPi * 39.5 / 40, 1e-6);
}

TEST(MidribFamily, MidribsOfOtherPieceCountsAreBroughtToThoseOfTheFirst) {
  const MidribFamily family(AgedMidribs{{0, arching_leaf(30, 0, 0)}, {1, arching_leaf(90, 0, 2)}});
  EXPECT_EQ(family.piece_count(), 30U);
  EXPECT_LT(largest_shift(aged(kLeaf, family, 1), arching_leaf(30, 0, 2)), 1e-6);
}

TEST(MidribFamily, LengthIsKeptBetweenAges) {
  const MidribFamily family(AgedMidribs{
      {0, random_leaf(RandomKey(1), 30)}, {0.4, random_leaf(RandomKey(2), 30)}, {1, random_leaf(RandomKey(3), 30)}});
  for (int k = 1; k <= 20; ++k) EXPECT_NEAR(midrib_length(aged(kLeaf, family, 0.05 * k)), 1, 1e-12);
}

TEST(MidribFamily, RejectsAgesThatDoNotRise) {
  EXPECT_THROW(MidribFamily(AgedMidribs{{1, kLeaf}}), std::invalid_argument);
  EXPECT_THROW(MidribFamily(AgedMidribs{{1, kLeaf}, {1, kLeaf}}), std::invalid_argument);
  EXPECT_THROW(MidribFamily(AgedMidribs{{1, kLeaf}, {std::nan(""), kLeaf}}), std::invalid_argument);
}

TEST(Aged, NothingCanBeSeenAtAge0) {
  EXPECT_EQ(aged(kLeaf, MidribFamily(kLeaf), 0).length, 0);
  EXPECT_EQ(area(aged(kLeaf, MidribFamily(kLeaf), -1)), 0);
}

TEST(Aged, AgesThatAreNoNumbersAreRefused) {
  const MidribFamily family(kLeaf);
  EXPECT_THROW(aged(kLeaf, family, std::nan("")), std::invalid_argument);
  EXPECT_THROW(aged(kLeaf, family, 1, std::nan("")), std::invalid_argument);
  EXPECT_THROW(aged(kLeaf, family, 1, 0), std::invalid_argument);
}

TEST(Aged, LengthAndAreaGrowWithAge) {
  const MidribFamily family(kLeaf);
  double length = 0, seen = 0;
  for (int k = 1; k <= 50; ++k) {
    const GrassLeaf now = aged(kLeaf, family, 0.02 * k);
    check_grass_leaf(now);
    EXPECT_NEAR(now.length, 0.02 * k * kLeaf.length, 1e-12);
    EXPECT_GT(now.length, length);
    EXPECT_GT(area(now), seen);
    length = now.length, seen = area(now);
  }
  EXPECT_NEAR(seen, area(kLeaf), 1e-12);
}

TEST(Aged, TheTipComesOutFirst) {
  const GrassLeaf now = aged(kLeaf, MidribFamily(kLeaf), 0.25);
  EXPECT_EQ(now.r.back(), kLeaf.r.back());
  EXPECT_NEAR(now.r.front(), along_leaf(kLeaf, kLeaf.r, 0.75), 1e-12);
  // The area of the outer quarter, as the integral of its widths.
  double tip = 0;
  for (int k = 0; k < 1000; ++k) tip += 0.25 / 1000 * along_leaf(kLeaf, kLeaf.r, 0.75 + 0.25 * (k + 0.5) / 1000);
  EXPECT_NEAR(area(now), kLeaf.length * kLeaf.width * tip, 1e-3 * area(kLeaf));
}

TEST(Aged, FullAgeIsWhenAllCanBeSeen) {
  const MidribFamily family(kLeaf);
  EXPECT_EQ(aged(kLeaf, family, 0.3, 0.6).length, 0.5 * kLeaf.length);
  EXPECT_EQ(aged(kLeaf, family, 0.7, 0.6).length, kLeaf.length);
}

TEST(Lived, WithRatesOf1ItIsTheAgedLeaf) {
  const MidribFamily family(kLeaf);
  for (const double time : {0.0, 0.13, 0.5, 1.0, 1.5}) {
    for (const double step : {0.01, 0.07, 1.0}) {
      const GrassLeaf now = lived(kLeaf, family, time, step, [](double, double) { return GrowthRates{}; });
      if (time == 0) {
        EXPECT_EQ(now.length, 0);
      } else {
        EXPECT_TRUE(are_alike(now, aged(kLeaf, family, time), 1e-9)) << time << ", " << step;
      }
    }
  }
}

TEST(Lived, TwiceTheLengthIsTheSameFormTwiceAsLong) {
  GrassLeaf wanted = aged(kLeaf, MidribFamily(kLeaf), 0.6);
  wanted.length *= 2;
  EXPECT_TRUE(are_alike(lived_with({.length = 2}, 0.6), wanted, 1e-9));
}

TEST(Lived, WidthIsMultiplied) {
  for (const double factor : {0.5, 1.5}) {
    GrassLeaf wanted = kLeaf;
    wanted.width *= factor;
    const GrassLeaf now = lived_with({.width = factor});
    EXPECT_TRUE(are_alike(now, wanted, 1e-9));
    EXPECT_LE(*std::max_element(now.r.begin(), now.r.end()), 1);
  }
}

TEST(Lived, WithoutBendingItStaysStraight) {
  const GrassLeaf now = lived_with({.bend = 0});
  for (std::size_t k = 0; k < now.point_count(); ++k) EXPECT_EQ(now.x[k], 0);
  EXPECT_NEAR(now.y.back(), 1, 1e-12);
}

TEST(Lived, BendTurnsPiecesAsManyTimesAsFar) {
  for (const double bend : {-1.0, 0.5, 1.7}) {
    const std::vector<double> angles = piece_angles(lived_with({.bend = bend})), own = piece_angles(kLeaf);
    for (std::size_t k = 0; k < own.size(); ++k) EXPECT_NEAR(angles[k], bend * own[k], 1e-9);
  }
}

TEST(Lived, AtTwiceTheRateItAgesTwiceAsFast) {
  EXPECT_TRUE(are_alike(lived_with({.age = 2}, 0.3), aged(kLeaf, MidribFamily(kLeaf), 0.6), 1e-9));
  EXPECT_EQ(lived_with({.age = 0}).length, 0);
}

TEST(Lived, NegativeRatesOfAgeLengthAndWidthCountAs0) {
  EXPECT_EQ(lived_with({.age = -1}).length, 0);
  EXPECT_EQ(lived_with({.length = -1}).length, 0);
  EXPECT_EQ(area(lived_with({.width = -1})), 0);
}

TEST(Lived, RatesThatChangeConvergeToTheirIntegral) {
  // Length emerges at the rate 1 + lived, which gives 1.5 by age 1.
  const auto error = [](double step) {
    const GrassLeaf now =
        lived(kLeaf, MidribFamily(kLeaf), 1, step, [](double time, double) { return GrowthRates{.length = 1 + time}; });
    return std::abs(now.length / kLeaf.length - 1.5);
  };
  EXPECT_NEAR(error(0.1), 0.05, 1e-9);
  EXPECT_NEAR(error(0.01), 0.005, 1e-9);
}

TEST(Lived, RatesAreAskedWithTimeAndVisibleShare) {
  std::vector<std::pair<double, double>> asked;
  lived(kLeaf, MidribFamily(kLeaf), 0.5, 0.25, [&](double time, double visible) {
    asked.emplace_back(time, visible);
    return GrowthRates{.age = 2};
  });
  EXPECT_EQ(asked, (std::vector<std::pair<double, double>>{{0, 0}, {0.25, 0.5}}));
}

TEST(Lived, AWidthThatChangesStaysWithWhatCameOutThen) {
  // Narrow while the outer half emerges, wide afterwards.
  const GrassLeaf now = lived(arching_leaf(40, 0, 0), MidribFamily(arching_leaf(40, 0, 0)), 1, 0.01,
                              [](double time, double) { return GrowthRates{.width = time < 0.495 ? 0.5 : 1}; });
  EXPECT_NEAR(now.r[5], 1, 1e-12);
  EXPECT_NEAR(now.r[15], 1, 1e-12);
  EXPECT_NEAR(now.r[25], 0.5, 1e-12);
  EXPECT_NEAR(now.r[40], 0.5, 1e-12);
}

TEST(Lived, RejectsStepsThatAreNoneOrTooMany) {
  const auto rates = [](double, double) { return GrowthRates{}; };
  const MidribFamily family(kLeaf);
  EXPECT_THROW(lived(kLeaf, family, 1, 0, rates), std::invalid_argument);
  EXPECT_THROW(lived(kLeaf, family, 1, -1, rates), std::invalid_argument);
  EXPECT_THROW(lived(kLeaf, family, 1, 1e-9, rates), std::invalid_argument);
  EXPECT_THROW(lived(kLeaf, family, std::nan(""), 0.1, rates), std::invalid_argument);
}

/// Returns the midribs of each leaf class by age.
std::map<int, AgedMidribs> midribs_by_class(const MeasuredGrass& grass) {
  std::map<int, AgedMidribs> by_class;
  for (const MeasuredCurve& midrib : grass.by_age) {
    by_class[midrib.lindex.value()].emplace_back(midrib.age.value(), fit_leaf(midrib, plain_widths()).leaf);
  }
  return by_class;
}

/// Interpolates an age from all other ages. Returns the distance of the tip from its measured place.
double error_without(const AgedMidribs& midribs, std::size_t left_out) {
  AgedMidribs others = midribs;
  others.erase(others.begin() + static_cast<std::ptrdiff_t>(left_out));
  const auto& [age, leaf] = midribs[left_out];
  // The whole leaf is visible from the first age on.
  const GrassLeaf guessed = aged(leaf, MidribFamily(others), age, 1e-3);
  return std::hypot(guessed.x.back() - leaf.x.back(), guessed.y.back() - leaf.y.back());
}

TEST(MidribFamily, MeasuredAgesThatAreLeftOutAreMetWithin5PercentInTheMedian) {
  for (const MeasuredGrass& grass : measured_grasses()) {
    SCOPED_TRACE(grass.name);
    const std::map<int, AgedMidribs> by_class = midribs_by_class(grass);
    EXPECT_EQ(by_class.size(), 2U);
    for (const auto& [leaf_class, midribs] : by_class) {
      std::vector<double> errors;
      for (std::size_t k = 1; k + 1 < midribs.size(); ++k) errors.push_back(error_without(midribs, k));
      EXPECT_EQ(errors.size(), grass.by_age.size() / 2 - 2) << "all ages but the first and the last";
      EXPECT_LT(median(errors), 0.05) << "class " << leaf_class;
    }
  }
}

TEST(MidribFamily, EachMeasuredLeafIsItselfAtAge1) {
  for (const MeasuredGrass& grass : measured_grasses()) {
    for (const GrassLeaf& leaf : grass.fitted(90)) {
      EXPECT_TRUE(are_alike(aged(leaf, MidribFamily(leaf), 1), leaf, 1e-9)) << grass.name;
    }
  }
}

}  // namespace meristem::midrib_family_test
