// SPDX-License-Identifier: Apache-2.0
#include "meristem/base/limits.h"

#include <gtest/gtest.h>

#include "meristem/base/diagnostic.h"

namespace meristem::limits_test {

std::string limit_message(double wanted) {
  try {
    throw_limit("attraction points", wanted, 10'000'000, "points", "components.tree.points");
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST(Limits, AnErrorNamesTheParameterTheNumberAndTheLimit) {
  EXPECT_EQ(limit_message(1e9),
            "components.tree.points: 1000000000 attraction points are too many; expected at most 10000000 "
            "(limits.points)");
}

TEST(Limits, AnErrorRoundsNumbersBeyondTheDigitsOfADouble) {
  EXPECT_EQ(limit_message(1e300),
            "components.tree.points: 1e+300 attraction points are too many; expected at most 10000000 (limits.points)");
}

}  // namespace meristem::limits_test
