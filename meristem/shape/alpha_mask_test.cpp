// SPDX-License-Identifier: Apache-2.0
#include "meristem/shape/alpha_mask.h"

#include <gtest/gtest.h>

namespace meristem {
namespace {

TEST(AlphaMask, IsAHoleBelowOneHalf) {
  const AlphaMask mask({2, 2, {0, 0, 0, 255, 0, 0, 0, 128, 0, 0, 0, 127, 0, 0, 0, 0}});
  EXPECT_FALSE(mask.is_hole({0.25F, 0.75F}));
  EXPECT_FALSE(mask.is_hole({0.75F, 0.75F}));
  EXPECT_TRUE(mask.is_hole({0.25F, 0.25F}));
  EXPECT_TRUE(mask.is_hole({0.75F, 0.25F}));
}

}  // namespace
}  // namespace meristem
