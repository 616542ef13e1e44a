// SPDX-License-Identifier: Apache-2.0
#include "meristem/graph/table/read_errors.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace meristem::read_errors_test {

const DocumentPath kTop;
const DocumentPath kLeaf(kTop, "leaf");

TEST(ReadErrors, AnErrorHasItsPathAndWhatWasExpected) {
  ReadErrors errors{SizeLimits()};
  errors.add_error(DocumentPath(kLeaf, "curl"), "it is wrong", "a number", "cup", 3);
  ASSERT_EQ(errors.diagnostics().size(), 1U);
  const Diagnostic& found = errors.diagnostics()[0];
  EXPECT_EQ(found.path, "leaf.curl");
  EXPECT_EQ(found.expected, "a number");
  EXPECT_EQ(found.nearest, "cup");
  EXPECT_EQ(found.text_offset, 3);
  EXPECT_EQ(found.severity, Severity::error);
}

TEST(ReadErrors, AllErrorsAreCountedAndTheFirstAreKept) {
  SizeLimits limits;
  limits.diagnostics = 2;
  ReadErrors errors(limits);
  for (int k = 0; k < 5; ++k) errors.add_error(kLeaf, std::to_string(k));
  EXPECT_EQ(errors.error_count(), 5U);
  ASSERT_EQ(errors.diagnostics().size(), 2U);
  EXPECT_EQ(errors.diagnostics()[1].message, "1");
}

TEST(ReadErrors, WarningsAreNoErrors) {
  ReadErrors errors{SizeLimits()};
  errors.warn(kLeaf, "it is odd");
  errors.add_found(kLeaf, {.severity = Severity::warning, .message = "so is this"});
  EXPECT_EQ(errors.error_count(), 0U);
  ASSERT_EQ(errors.diagnostics().size(), 2U);
  EXPECT_EQ(errors.diagnostics()[1].severity, Severity::warning);
}

TEST(ReadErrors, AParameterWithoutEffectIsListedWithTheOther) {
  ReadErrors errors{SizeLimits()};
  const DocumentPath other(kLeaf, "file");
  errors.add_meaning_error(DocumentPath(kLeaf, "length"), "no meaning", "one of them", &other);
  errors.add_meaning_error(DocumentPath(kLeaf, "width"), "no meaning", "'length' beside it");
  ASSERT_EQ(errors.meaningless().size(), 2U);
  EXPECT_EQ(errors.meaningless()[0].file_path, "leaf.length");
  EXPECT_EQ(errors.meaningless()[0].other, "leaf.file");
  EXPECT_EQ(errors.meaningless()[1].other, "");
  EXPECT_EQ(errors.error_count(), 2U);
}

TEST(ReadErrors, SimilarNamesAreSearchedUntilTheyCostTooMuch) {
  const std::vector<std::string> names{"length", "width"};
  ReadErrors errors{SizeLimits()};
  EXPECT_EQ(errors.nearest("lenght", names), "length");
  errors.count_compared(kMaxNamesCompared - 2);
  EXPECT_FALSE(errors.may_compare(2));
  EXPECT_EQ(errors.nearest("lenght", names), "");
}

TEST(ReadErrors, NoSimilarNamesAreSearchedForErrorsThatAreNotShown) {
  SizeLimits limits;
  limits.diagnostics = 1;
  ReadErrors errors(limits);
  errors.add_error(kLeaf, "one");
  EXPECT_EQ(errors.nearest("lenght", std::vector<std::string>{"length"}), "");
}

TEST(ReadErrors, ALimitNamesTheLimitToRaise) {
  ReadErrors errors{SizeLimits()};
  errors.add_limit_error(kLeaf, "corners", 700, 500, "corners");
  ASSERT_EQ(errors.diagnostics().size(), 1U);
  EXPECT_NE(errors.diagnostics()[0].text().find("limits.corners"), std::string::npos) << errors.diagnostics()[0].text();
}

}  // namespace meristem::read_errors_test
