// SPDX-License-Identifier: Apache-2.0
#include "text_units.h"

#include <stdexcept>

#include <rapidcheck/gtest.h>

namespace meristem::studio::text_units_test {

const std::string kTree = "h\u00e9 \U0001f333";  // a letter of two bytes, a tree of four

TEST(TextUnits, HashAsThePageDoes) {
  EXPECT_EQ(text_hash(""), "488bdcb81aee8d83");
  EXPECT_EQ(text_hash("{\"meristem\": 1}"), "a3a506818f059667");
  EXPECT_EQ(text_hash(kTree), "c1f37d5b4891e0a0");
}

TEST(TextUnits, CountAsJavaScriptDoes) {
  EXPECT_EQ(unit_count(kTree), 5U);
  const TextPatch patch = in_bytes(kTree, {{1, 1, "e"}, {3, 2, "tree"}});
  EXPECT_EQ(patch, (TextPatch{{1, 2, "e"}, {4, 4, "tree"}}));
  EXPECT_EQ(apply_patch(kTree, patch), "he tree");
  EXPECT_EQ(in_units(kTree, patch), (std::vector<UnitSplice>{{1, 1, "e"}, {3, 2, "tree"}}));
}

TEST(TextUnits, RefuseSplicesThatDoNotFit) {
  EXPECT_THROW(in_bytes(kTree, {{4, 1, ""}}), std::invalid_argument);  // within the tree
  EXPECT_THROW(in_bytes(kTree, {{3, 1, ""}}), std::invalid_argument);
  EXPECT_THROW(in_bytes(kTree, {{6, 0, ""}}), std::invalid_argument);
  EXPECT_THROW(in_bytes(kTree, {{0, 9'007'199'254'740'991, ""}}), std::invalid_argument);
  EXPECT_THROW(in_bytes(kTree, {{2, 1, ""}, {1, 1, ""}}), std::invalid_argument);
  EXPECT_THROW(in_bytes(kTree, {{0, 2, ""}, {1, 1, ""}}), std::invalid_argument);
}

TEST(TextUnits, FindLinesAndColumns) {
  const std::string text = "\xef\xbb\xbf{\r\n  \"\U0001f333\": 1}";
  // In any order; (2, 5) is behind the tree, line 9 behind the text.
  const std::vector<LineColumn> places{{9, 1}, {2, 5}, {1, 1}, {2, 1}, {2, 5}};
  EXPECT_EQ(units_of(text, places), (std::vector<std::size_t>{unit_count(text), 9, 1, 4, 9}));
}

RC_GTEST_PROP(TextUnits, TakeAnyPatchThereAndBack, (std::string text, unsigned first, unsigned second)) {
  for (char& letter : text) letter = static_cast<char>(letter & 0x7f);
  const std::size_t begin = first % (text.size() + 1);
  const std::size_t length = second % (text.size() - begin + 1);
  const TextPatch patch{{begin, length, "x"}};
  RC_ASSERT(in_bytes(text, in_units(text, patch)) == patch);
}

}  // namespace meristem::studio::text_units_test
