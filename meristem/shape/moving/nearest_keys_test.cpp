// SPDX-License-Identifier: Apache-2.0
#include "meristem/shape/moving/nearest_keys.h"

#include <gtest/gtest.h>

namespace meristem::nearest_keys_test {

std::vector<std::size_t> nearest(const std::vector<bool>& there) {
  return nearest_keys(there.size(), [&](std::size_t key) { return there[key]; });
}

TEST(NearestKeys, TheKeyItselfOrTheNextOrTheLastBefore) {
  using Keys = std::vector<std::size_t>;
  EXPECT_EQ(nearest({true, true, true}), (Keys{0, 1, 2}));
  EXPECT_EQ(nearest({false, true, false, false, true, false, false}), (Keys{1, 1, 4, 4, 4, 4, 4}));
  EXPECT_EQ(nearest({true, false, false}), (Keys{0, 0, 0}));
  EXPECT_EQ(nearest({false, false}), (Keys{0, 1}));
}

}  // namespace meristem::nearest_keys_test
