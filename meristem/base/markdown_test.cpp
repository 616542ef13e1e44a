// SPDX-License-Identifier: Apache-2.0
#include "meristem/base/markdown.h"

#include <gtest/gtest.h>

namespace meristem::markdown_test {

TEST(MarkdownCell, KeepsBarsInTheCell) {
  EXPECT_EQ(markdown_cell("all"), "all");
  EXPECT_EQ(markdown_cell("a|b||"), R"(a\|b\|\|)");
  EXPECT_EQ(markdown_cell(""), "");
}

}  // namespace meristem::markdown_test
