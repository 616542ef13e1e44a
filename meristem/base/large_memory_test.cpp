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

}  // namespace meristem::large_memory_test
