// SPDX-License-Identifier: Apache-2.0
#include "meristem/base/name_table.h"

#include <gtest/gtest.h>

namespace meristem::name_table_test {

TEST(NameTable, FindsTheFirstPositionOfEachName) {
  NameTable table(std::vector<std::string>{"a", "b"});
  table.add("a");
  table.add("c");
  EXPECT_EQ(table.names(), (std::vector<std::string>{"a", "b", "a", "c"}));
  EXPECT_EQ(table.find("a"), 0u);
  EXPECT_EQ(table.find("b"), 1u);
  EXPECT_EQ(table.find("c"), 3u);
  EXPECT_EQ(table.find("d"), std::nullopt);
}

TEST(NameTable, CopiesAndMovesKeepTheirNames) {
  NameTable first;
  for (int k = 0; k < 1000; ++k) first.add("n" + std::to_string(k));
  NameTable copy = first;
  const NameTable moved = std::move(first);
  copy.add("more");
  EXPECT_EQ(moved.find("n999"), 999u);
  EXPECT_EQ(copy.find("more"), 1000u);
  EXPECT_FALSE(moved.contains("more"));
}

}  // namespace meristem::name_table_test
