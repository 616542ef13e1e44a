// SPDX-License-Identifier: Apache-2.0
#include "meristem/base/number_limit.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace meristem::number_limit_test {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(NumberLimit, HoldsItsEndsButNoInfinityAndNoNan) {
  for (const NumberLimit& limit : {kFileNumber, kFileCoordinate, kFileRadius}) {
    EXPECT_TRUE(limit.holds(limit.min));
    EXPECT_TRUE(limit.holds(limit.max));
    EXPECT_FALSE(limit.holds(std::nextafter(limit.max, kInfinity)));
    EXPECT_FALSE(limit.holds(std::nextafter(limit.min, -kInfinity)));
    EXPECT_FALSE(limit.holds(kInfinity));
    EXPECT_FALSE(limit.holds(-kInfinity));
    EXPECT_FALSE(limit.holds(std::numeric_limits<double>::quiet_NaN()));
  }
}

TEST(NumberLimit, NumbersAndSquaresOfLengthsFitIntoFloats) {
  EXPECT_TRUE(std::isfinite(static_cast<float>(kFileNumber.max)));
  for (const NumberLimit& limit : {kFileCoordinate, kFileRadius}) {
    EXPECT_TRUE(std::isfinite(static_cast<float>(3 * limit.max * limit.max))) << limit.noun;
  }
}

TEST(NumberLimit, FaultSaysWhatWasExpected) {
  EXPECT_EQ(number_error("the radius -1", kFileRadius).text(),
            "the radius -1 is out of range; expected a radius or diameter from 0 to 1e+09");
}

}  // namespace meristem::number_limit_test
