// SPDX-License-Identifier: Apache-2.0
#include "meristem/base/counted.h"

#include <gtest/gtest.h>

namespace meristem::counted_test {

TEST(Counted, HasItsPluralButForOne) {
  EXPECT_EQ(counted(0, "plant"), "0 plants");
  EXPECT_EQ(counted(1, "plant"), "1 plant");
  EXPECT_EQ(counted(12, "plant"), "12 plants");
}

}  // namespace meristem::counted_test
