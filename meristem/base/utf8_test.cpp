// SPDX-License-Identifier: Apache-2.0
#include "meristem/base/utf8.h"

#include <gtest/gtest.h>

namespace meristem::utf8_test {

TEST(Utf8, FindsTheFirstByteThatIsNotText) {
  EXPECT_EQ(find_invalid_utf8(""), 0U);
  EXPECT_EQ(find_invalid_utf8("h\xC3\xA9 \xF0\x9F\x8C\xB3"), 8U);
  EXPECT_EQ(find_invalid_utf8("Weide (K\xF6hler)"), 8U);          // Latin-1
  EXPECT_EQ(find_invalid_utf8("a\xC0\xAF"), 1U);                  // an overlong slash
  EXPECT_EQ(find_invalid_utf8("a\xE0\x80\xAF"), 1U);              // also overlong
  EXPECT_EQ(find_invalid_utf8("a\xED\xA0\xBD\xED\xBC\xB3"), 1U);  // surrogates
  EXPECT_EQ(find_invalid_utf8("a\xF4\x90\x80\x80"), 1U);          // above U+10FFFF
  EXPECT_EQ(find_invalid_utf8("ab\xE2\x82"), 2U);                 // ends within a character
}

TEST(Utf8, ReplacesOnlyBytesThatAreNotText) {
  EXPECT_EQ(with_valid_utf8("h\xC3\xA9"), "h\xC3\xA9");
  EXPECT_EQ(with_valid_utf8("K\xF6hl\xE9r"), "K\xEF\xBF\xBDhl\xEF\xBF\xBDr");
  EXPECT_EQ(with_valid_utf8("\xFF\xC3\xA9\xC3"), "\xEF\xBF\xBD\xC3\xA9\xEF\xBF\xBD");
  EXPECT_EQ(find_invalid_utf8(with_valid_utf8("\xED\xA0\xBD")), 9U);
}

}  // namespace meristem::utf8_test
