// SPDX-License-Identifier: Apache-2.0
#include "meristem/base/in_quotes.h"

#include <gtest/gtest.h>

namespace meristem::in_quotes_test {

TEST(InQuotes, KeepsShortTexts) {
  EXPECT_EQ(in_quotes("leaf"), "'leaf'");
  EXPECT_EQ(in_quotes(""), "''");
  EXPECT_EQ(in_quotes(std::string(40, 'a')), "'" + std::string(40, 'a') + "'");
}

TEST(InQuotes, ShortensLongOnes) { EXPECT_EQ(in_quotes(std::string(41, 'a')), "'" + std::string(40, 'a') + "...'"); }

TEST(InQuotes, KeepsCharactersWhole) {
  const std::string before(39, 'a');
  EXPECT_EQ(in_quotes(before + "é and more"), "'" + before + "...'");
  EXPECT_EQ(in_quotes(before + "b" + "é and more"), "'" + before + "b...'");
}

TEST(InQuotes, EndsForBytesThatAreNoText) { EXPECT_EQ(in_quotes(std::string(50, '\x80')), "'...'"); }

}  // namespace meristem::in_quotes_test
