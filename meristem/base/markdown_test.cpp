// SPDX-License-Identifier: Apache-2.0
#include "meristem/base/markdown.h"

#include <gtest/gtest.h>

namespace meristem::markdown_test {

TEST(MarkdownCell, KeepsBarsInTheCell) {
  EXPECT_EQ(markdown_cell("all"), "all");
  EXPECT_EQ(markdown_cell("a|b||"), R"(a\|b\|\|)");
  EXPECT_EQ(markdown_cell(""), "");
}

TEST(MarkdownText, ShowsMarksAsTheyAre) {
  EXPECT_EQ(markdown_text("Oak, 20 years (old) - 1.5 m"), "Oak, 20 years (old) - 1.5 m");
  EXPECT_EQ(markdown_text("leaf_area of stem.length"), "leaf_area of stem.length");
  EXPECT_EQ(markdown_text("*a* _b_ `c` a|b ~~d~~ $e$ \\"), R"(\*a\* \_b\_ \`c\` a\|b \~\~d\~\~ \$e\$ \\)");
  EXPECT_EQ(markdown_text("![x](y)"), R"(!\[x\](y))");
  EXPECT_EQ(markdown_text("# a"), R"(\# a)");
  EXPECT_EQ(markdown_text("    - a"), R"(\- a)");
  EXPECT_EQ(markdown_text("12. a 3. b"), R"(12\. a 3. b)");
  EXPECT_EQ(markdown_text("1) a"), R"(1\) a)");
  EXPECT_EQ(markdown_text("a\n# b"), "a # b");
}

TEST(MarkdownText, MakesNeitherTagsNorLinks) {
  EXPECT_EQ(markdown_text("<script>alert('&amp;')</script>"), "&lt;script&gt;alert('&amp;amp;')&lt;/script&gt;");
  EXPECT_EQ(markdown_text("https://a.org www.a.org me@a.org"), R"(https\://a.org www\.a.org me\@a.org)");
}

TEST(MarkdownText, MakesInvisibleCharactersVisible) {
  EXPECT_EQ(markdown_text("a\x1b[31mb"), R"(a\\u001B\[31mb)");
  EXPECT_EQ(markdown_text("a\u202Eb\u0085c\u00E4\u2019"), "a\\\\u202Eb\\\\u0085c\u00E4\u2019");
  EXPECT_EQ(markdown_text("\U0001F333"), "\U0001F333");
  EXPECT_EQ(markdown_text("a\xE2<b>"), "a\xE2&lt;b&gt;") << "half a letter";
}

}  // namespace meristem::markdown_test
