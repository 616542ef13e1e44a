// SPDX-License-Identifier: Apache-2.0
#include "meristem/base/seed.h"

#include <string>

#include <gtest/gtest.h>

namespace meristem::seed_test {

TEST(Seed, IsAWholeNumberUpToTwoToThe53) {
  EXPECT_EQ(seed_of_text("0"), 0U);
  EXPECT_EQ(seed_of_text("007"), 7U);
  EXPECT_EQ(seed_of_text("9007199254740992"), kLargestSeed);
}

TEST(Seed, NothingElseIsOne) {
  for (const char* text :
       {"", " 1", "1 ", "-1", "+1", "1.0", "1e3", "0x10", "9007199254740993", "18446744073709551616", "seven", "1\n"}) {
    EXPECT_EQ(seed_of_text(text), std::nullopt) << '\'' << text << '\'';
  }
}

TEST(Seed, RangeInWordsEndsWithTheLargest) {
  EXPECT_TRUE(std::string(kSeedRange).ends_with(' ' + std::to_string(kLargestSeed)));
}

}  // namespace meristem::seed_test
