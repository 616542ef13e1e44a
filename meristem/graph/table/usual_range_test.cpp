// SPDX-License-Identifier: Apache-2.0
#include "meristem/graph/table/usual_range.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <gtest/gtest.h>

namespace meristem::usual_range_test {

using Ends = std::pair<double, double>;

Ends usual(const NumberRange& form, const Value& fallback = {}, ParameterKind kind = ParameterKind::number) {
  Parameter row;
  row.kind = kind;
  row.form = form;
  const UsualSpan span = usual_range(row, fallback);
  return {span.low, span.high};
}

TEST(UsualRange, IsWhatTheRowSays) {
  EXPECT_EQ(usual({.min = 0, .max = 1000, .usual = {1, 30}}, 5), Ends(1, 30));
  EXPECT_EQ(usual({.min = 0, .max = 1000, .usual = {.high = 30}}, 5), Ends(0, 30));
  EXPECT_EQ(usual({.min = 0, .max = 1000, .usual = {.low = 1}}, 5), Ends(1, 20));
  EXPECT_EQ(usual({.min = 0, .max = 1000, .usual = {.low = 100}}, 100), Ends(100, 1000));
  EXPECT_EQ(usual({.min = 0, .max = 1000, .usual = {.low = 100}}), Ends(100, 200));
}

TEST(UsualRange, HoldsTheDefault) {
  EXPECT_EQ(usual({.min = 0, .max = 1000, .usual = {1, 30}}, 50), Ends(1, 50));
  EXPECT_EQ(usual({.unit = Unit::degree, .min = -36000, .max = 36000}, 720), Ends(-180, 720));
}

TEST(UsualRange, IsTheHardRangeWhereThatIsNarrow) {
  EXPECT_EQ(usual({.min = 0, .max = 1}, 0.01), Ends(0, 1));
  EXPECT_EQ(usual({.min = -1, .max = 1}), Ends(-1, 1));
  EXPECT_EQ(usual({.min = 0, .max = 50}, 5), Ends(0, 50));
}

TEST(UsualRange, GoesToAFewTimesTheDefault) {
  EXPECT_EQ(usual({.unit = Unit::metre, .min = 0, .max = 100}, 0.06), Ends(0, 0.5));
  EXPECT_EQ(usual({.unit = Unit::metre, .min = 0}, 2.5e-6), Ends(0, 1e-5));
  EXPECT_EQ(usual({.unit = Unit::metre, .min = -100, .max = 100}, 1), Ends(-5, 5));
  EXPECT_EQ(usual({.min = 1, .max = 1e6}, 5, ParameterKind::integer), Ends(1, 20));
}

TEST(UsualRange, FollowsTheUnitWithoutADefault) {
  EXPECT_EQ(usual({.unit = Unit::metre, .min = 0, .max = 1e5}), Ends(0, 1));
  EXPECT_EQ(usual({.unit = Unit::metre}, 0), Ends(-1, 1));
  EXPECT_EQ(usual({.unit = Unit::degree, .min = 0, .max = 36000}), Ends(0, 360));
  EXPECT_EQ(usual({.unit = Unit::degree, .min = -90, .max = 90}), Ends(-90, 90));
  EXPECT_EQ(usual({.min = 0}, {}, ParameterKind::integer), Ends(0, 10));
  EXPECT_EQ(usual({.min = 16, .max = 4096}), Ends(16, 50));
  EXPECT_EQ(usual({.max = -16}), Ends(-50, -16));
}

TEST(UsualRange, LeavesOutAnEndThatIsNotAllowed) {
  EXPECT_EQ(usual({.unit = Unit::metre, .min = 0, .max = 100, .above_min = true}, 0.5), Ends(0.05, 2));
  EXPECT_EQ(usual({.min = 0, .max = 1, .above_min = true}), Ends(0.01, 1));
  EXPECT_EQ(usual({.min = 0, .max = 1, .above_min = true}, 0), Ends(0.01, 1));
  EXPECT_EQ(usual({.min = 0, .above_min = true}, 3, ParameterKind::integer), Ends(1, 20));
}

TEST(UsualRange, HoldsAllNumbersOfAList) {
  const Value::List offset{0, 3, -0.5};
  EXPECT_EQ(usual({.unit = Unit::metre, .min = -1e4, .max = 1e4}, offset, ParameterKind::vector), Ends(-20, 20));
  const Value::List corners{Value::List{-1, 0, -1}, Value::List{1, 30, 1}};
  EXPECT_EQ(usual({.usual = {-5, 5}}, corners, ParameterKind::box), Ends(-5, 30));
}

TEST(UsualRange, IsNeverEmptyAndLiesInTheHardRange) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const double min : {-kInfinity, -1e6, -3.0, 0.0, 1e-9, 7.0, 1e7}) {
    for (const double width : {1e-3, 0.5, 40.0, 1e9, kInfinity}) {
      for (const double share : {0.0, 1e-4, 0.5, 1.0}) {
        for (const bool above_min : {false, true}) {
          const NumberRange form{.min = min, .max = std::max(min, -1e7) + width, .above_min = above_min};
          const double low = std::max(form.min, -1e8), high = std::min(form.max, 1e8);
          const double fallback = std::min(high, low + share * (high - low));
          if (above_min && fallback == form.min) continue;
          const Ends ends = usual(form, fallback);
          EXPECT_LT(ends.first, ends.second) << min << ' ' << width << ' ' << fallback;
          EXPECT_GE(ends.first, form.min);
          EXPECT_TRUE(!above_min || ends.first > form.min) << min << ' ' << width << ' ' << fallback;
          EXPECT_LE(ends.second, form.max);
          EXPECT_LE(ends.first, fallback);
          EXPECT_GE(ends.second, fallback);
          EXPECT_TRUE(std::isfinite(ends.first) && std::isfinite(ends.second));
        }
      }
    }
  }
}

}  // namespace meristem::usual_range_test
