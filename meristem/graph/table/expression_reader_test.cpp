// SPDX-License-Identifier: Apache-2.0
#include "meristem/graph/table/expression_reader.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace meristem::expression_reader_test {

const DocumentPath kTop;
const DocumentPath kCurl(kTop, "curl");

/// A reader of a document with the variable `tilt`, and its errors.
struct Reading {
  ReadErrors errors{SizeLimits()};
  ExpressionReader reader{{{"tilt", 40}}, errors};

  std::optional<Expression> read(const Value& value) { return reader.read(value, kCurl, reader.instance_names()); }
};

TEST(ExpressionReader, KnowsTheVariablesOfTheDocument) {
  Reading reading;
  const auto read = reading.read("2 * tilt");
  ASSERT_TRUE(read);
  EXPECT_TRUE(read->is_constant());
  EXPECT_EQ(read->evaluate(), 80);
  EXPECT_EQ(reading.errors.error_count(), 0U);
}

TEST(ExpressionReader, InstanceNamesComeAfterTheSiteVariables) {
  Reading reading;
  const std::size_t before = reading.reader.instance_names().size();
  EXPECT_FALSE(reading.read("vigour"));
  reading.reader.add_instance_names(std::vector<std::string>{"vigour"});
  EXPECT_EQ(reading.reader.instance_names().size(), before + 1);
  EXPECT_EQ(reading.reader.instance_names().back(), "vigour");
  const auto read = reading.read("vigour + i");
  ASSERT_TRUE(read);
  EXPECT_FALSE(read->is_constant());
}

TEST(ExpressionReader, AnErrorLiesAtTheByteOfTheText) {
  Reading reading;
  EXPECT_FALSE(reading.read("2 + tild"));
  ASSERT_EQ(reading.errors.diagnostics().size(), 1U);
  const Diagnostic& found = reading.errors.diagnostics()[0];
  EXPECT_EQ(found.path, "curl");
  EXPECT_EQ(found.text_offset, 4);
  EXPECT_EQ(found.nearest, "tilt");
}

TEST(ExpressionReader, ARefusedNameHasItsReason) {
  Reading reading;
  reading.reader.refuse_instance_name("species", "is a column of texts");
  EXPECT_FALSE(reading.read("1 + species"));
  ASSERT_EQ(reading.errors.diagnostics().size(), 1U);
  EXPECT_EQ(reading.errors.diagnostics()[0].message, "'species' is a column of texts");
}

TEST(ExpressionReader, ANumberIsNoExpression) {
  Reading reading;
  EXPECT_FALSE(reading.read(3));
  EXPECT_EQ(reading.errors.diagnostics().at(0).message, "an expression cannot be the number 3");
}

TEST(ExpressionReader, PathsOfExpressionsAreCollectedOnRequest) {
  Reading reading;
  std::vector<std::string> paths;
  reading.read("1");
  reading.reader.note_expressions(&paths);
  reading.read("2");
  reading.reader.note_expressions(nullptr);
  reading.read("3");
  EXPECT_EQ(paths, std::vector<std::string>{"curl"});
}

TEST(ExpressionReader, TheHashDependsOnNamesAndValuesOfTheVariables) {
  const auto hash = [](const char* name, double value) {
    ReadErrors errors{SizeLimits()};
    return ExpressionReader({{name, value}}, errors).constants_hash();
  };
  EXPECT_EQ(hash("a", 1), hash("a", 1));
  EXPECT_NE(hash("a", 1), hash("b", 1));
  EXPECT_NE(hash("a", 1), hash("a", 2));
}

}  // namespace meristem::expression_reader_test
