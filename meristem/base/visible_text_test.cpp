// SPDX-License-Identifier: Apache-2.0
#include "meristem/base/visible_text.h"

#include <gtest/gtest.h>

namespace meristem::visible_text_test {

TEST(VisibleText, LettersOfAllScriptsStayAsTheyAre) {
  for (const char* text : {"", "oak.json:3:4: a leaf", "Blätter, 40°", "日本語", "\xF0\x9F\x8C\xB3", "a\\u001b"}) {
    EXPECT_EQ(visible_text(text), text);
  }
}

TEST(VisibleText, EscapesWhatATerminalActsOn) {
  EXPECT_EQ(visible_text("a\x1B[31mb"), "a\\u001b[31mb");
  EXPECT_EQ(visible_text("a\nb\tc\rd"), "a\\u000ab\\u0009c\\u000dd");
  EXPECT_EQ(visible_text(std::string("\0", 1)), "\\u0000");
  EXPECT_EQ(visible_text("\x7F"), "\\u007f");
  EXPECT_EQ(visible_text("\xC2\x9B"), "\\u009b") << "the one-character form of escape and bracket";
}

TEST(VisibleText, EscapesMarksOfDirectionAndSeparators) {
  EXPECT_EQ(visible_text("\xE2\x80\xAEgpj.\xE2\x80\xAC"), "\\u202egpj.\\u202c");
  EXPECT_EQ(visible_text("\xE2\x80\x8E\xE2\x80\x8F\xD8\x9C"), "\\u200e\\u200f\\u061c");
  EXPECT_EQ(visible_text("\xE2\x81\xA6\xE2\x81\xA9"), "\\u2066\\u2069");
  EXPECT_EQ(visible_text("\xE2\x80\xA8\xE2\x80\xA9"), "\\u2028\\u2029");
  EXPECT_EQ(visible_text("\xE2\x80\xA7\xE2\x81\xA5"), "\xE2\x80\xA7\xE2\x81\xA5") << "their neighbours stay";
}

TEST(VisibleText, BytesThatAreNotUtf8AreEscaped) {
  EXPECT_EQ(visible_text("caf\xE9.json"), "caf\\xe9.json");
  EXPECT_EQ(visible_text("\x9B"), "\\x9b");
}

TEST(VisibleText, LinesKeepTheirEnds) { EXPECT_EQ(visible_lines("a\x1B\nb\r\n"), "a\\u001b\nb\\u000d\n"); }

TEST(VisibleText, IsItsOwnResult) {
  const std::string once = visible_text("\x1B\xFF\xE2\x80\xAE");
  EXPECT_EQ(visible_text(once), once);
}

TEST(VisibleText, ErrorsAndTheirDiagnosticsAreVisible) {
  const Diagnostic diagnostic{.message = "no '\x1B[2J'", .expected = "\xE2\x80\xAE", .nearest = "\x07", .path = "a\nb"};
  const InputError error(diagnostic);
  EXPECT_STREQ(error.what(), "a\\u000ab: no '\\u001b[2J'; expected \\u202e; did you mean '\\u0007'?");
  EXPECT_EQ(error.diagnostics()[0].message, "no '\\u001b[2J'");
  EXPECT_EQ(error.diagnostics()[0].expected, "\\u202e");
  EXPECT_EQ(error.diagnostics()[0].nearest, "\\u0007");
  EXPECT_EQ(error.diagnostics()[0].path, "a\nb") << "programs look it up";
}

}  // namespace meristem::visible_text_test
