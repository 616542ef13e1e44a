// SPDX-License-Identifier: Apache-2.0
#include "meristem/base/large_memory.h"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

namespace meristem::large_memory_test {

TEST(LargeMemory, IsAsLongAsAskedForAndEmpty) {
  for (const std::size_t count : {0, 3, 1'000'000, 10'000'000}) {
    std::vector<int> items;
    resize_large(items, count);
    EXPECT_EQ(items.size(), count);
    EXPECT_TRUE(std::all_of(items.begin(), items.end(), [](int item) { return item == 0; }));
  }
}

TEST(LargeMemory, GivenBackIsStillThereToAskFor) {
  { std::vector<std::vector<int>> many(1000, std::vector<int>(1000)); }
  give_back_memory();
  const std::vector<int> again(1'000'000, 3);
  EXPECT_EQ(again.back(), 3);
}

}  // namespace meristem::large_memory_test
