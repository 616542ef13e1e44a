// SPDX-License-Identifier: Apache-2.0
#include "meristem/base/read_columns.h"

#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "meristem/base/diagnostic.h"

namespace meristem::read_columns_test {

using List = std::vector<double>;

const std::vector<ColumnRequest> kForms{{"rank", false}, {"x"}, {"y"}};

Columns read(std::string_view text) { return read_columns(text, kForms, {}); }

std::vector<Diagnostic> errors_of(std::string_view text, const SizeLimits& limits = {}) {
  try {
    read_columns(text, kForms, limits);
  } catch (const InputError& error) {
    return error.diagnostics();
  }
  return {};
}

/// Returns the error of a text with one error.
Diagnostic error_of(std::string_view text) {
  const std::vector<Diagnostic> errors = errors_of(text);
  EXPECT_EQ(errors.size(), 1U) << text;
  return errors.empty() ? Diagnostic{} : errors.front();
}

TEST(ReadColumns, GivesColumnsByNameWhateverTheirOrder) {
  const Columns columns = read("y,note,x\n1,first,2\n-3e2,,0.5\n");
  EXPECT_FALSE(columns.has(0));
  EXPECT_EQ(columns.numbers[1], (List{2, 0.5}));
  EXPECT_EQ(columns.numbers[2], (List{1, -300}));
  EXPECT_EQ(columns.lines, (std::vector<int>{2, 3}));
}

TEST(ReadColumns, CommasSemicolonsAndTabsReadTheSame) {
  const std::vector<std::vector<double>> wanted = read("x,y\n1.5,2\n").numbers;
  EXPECT_EQ(read("x;y\n1.5;2\n").numbers, wanted);
  EXPECT_EQ(read("x\ty\n1.5\t2\n").numbers, wanted);
}

TEST(ReadColumns, DecimalCommasReadWhereTheyPartNoCells) {
  EXPECT_EQ(read("x;y\n2,5;-0,25\n").numbers, read("x,y\n2.5,-0.25\n").numbers);
  EXPECT_EQ(read("x\ty\n2,5\t1\n").numbers[1], List{2.5});
  EXPECT_EQ(error_of("x,y\n2,5,1\n").message, "the row has 3 cells");
}

TEST(ReadColumns, QuotesBlanksReturnsAndPlusSignsDoNotCount) {
  const Columns columns = read("\"rank\", \"x\" ,y\r\n\"1\", +2 ,\" 3\"\r\n");
  EXPECT_EQ(columns.numbers[0], List{1});
  EXPECT_EQ(columns.numbers[1], List{2});
  EXPECT_EQ(columns.numbers[2], List{3});
}

TEST(ReadColumns, SeparatorsInQuotesPartNothing) { EXPECT_EQ(read("name,x,y\n\"a,b\",1,2\n").numbers[1], List{1}); }

TEST(ReadColumns, AByteOrderMarkIsNoPartOfTheFirstName) {
  EXPECT_EQ(read("\xEF\xBB\xBFx,y\n1,2\n").numbers[1], List{1});
}

TEST(ReadColumns, EmptyLinesCountAsLinesButNotAsRows) {
  const Columns columns = read("\nx,y\n\n1,2\n   \n3,4");
  EXPECT_EQ(columns.lines, (std::vector<int>{4, 6}));
  EXPECT_EQ(columns.row_count(), 2U);
}

TEST(ReadColumns, RejectsATextWithoutLines) {
  for (const char* text : {"", "\n\n", "\xEF\xBB\xBF", "  \r\n"}) {
    EXPECT_EQ(error_of(text).message, "the file has no lines");
  }
}

TEST(ReadColumns, RejectsAHeadLineAlone) {
  EXPECT_EQ(error_of("x,y\n").message, "the file has no rows below its head line");
}

TEST(ReadColumns, RejectsAMissingColumnWithTheNearestName) {
  const std::vector<ColumnRequest> forms{{"lindex"}, {"x"}};
  try {
    read_columns("lindx,x\n1,2\n", forms, {});
    FAIL();
  } catch (const InputError& error) {
    const Diagnostic& found = error.diagnostics().front();
    EXPECT_EQ(found.message, "there is no column 'lindex'");
    EXPECT_EQ(found.nearest, "lindx");
    EXPECT_EQ(found.line, 1);
  }
}

TEST(ReadColumns, RejectsAColumnThatIsThereTwiceAtItsSecondPlace) {
  const Diagnostic found = error_of("x,y,x\n1,2,3\n");
  EXPECT_EQ(found.message, "the column 'x' appears twice");
  EXPECT_EQ(found.line, 1);
  EXPECT_EQ(found.column, 5);
  EXPECT_EQ(read("x,y,note,note\n1,2,3,4\n").row_count(), 1U) << "nobody asks for it";
}

TEST(ReadColumns, RejectsWhatIsNoFiniteNumberAtItsLineAndColumn) {
  for (const char* cell : {"abc", "", "1.2.3", "1 2", "nan", "inf", "1e999", "--1", "0x10", "+-1"}) {
    const Diagnostic found = error_of(std::string("x,y\n1,2\n3,") + cell + "\n");
    EXPECT_NE(found.message.find("in the column 'y' is not a number"), std::string::npos) << cell;
    EXPECT_EQ(found.line, 3) << cell;
    EXPECT_EQ(found.column, 3) << cell;
  }
}

TEST(ReadColumns, RejectsNumbersBeyondTheLimitOfTheirColumn) {
  const Diagnostic found = error_of("x,y\n1,2\n3,1e39\n");
  EXPECT_EQ(found.text(), "3:3: '1e39' in the column 'y' is out of range; expected a number from -3.4e+38 to 3.4e+38");
  const NumberLimit few{0, 10, "a count"};
  try {
    read_columns("x\n11\n", {{.name = "x", .limit = few}}, SizeLimits());
    ADD_FAILURE() << "11 is beyond the limit";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "2:1: '11' in the column 'x' is out of range; expected a count from 0 to 10");
  }
}

TEST(ReadColumns, FindsTheCellOfANamedColumn) {
  const std::string text = "\nname;x;y\n\nBl\xC3\xA4tter;?;2\n\"a;b\";3;4\n";
  EXPECT_EQ(column_of_cell(text, 4, "y"), 11);
  EXPECT_EQ(column_of_cell(text, 5, "x"), 7);
  EXPECT_EQ(column_of_cell(text, 5, "z"), 1);
  EXPECT_EQ(column_of_cell(text, 9, "x"), 1);
}

TEST(ReadColumns, ColumnsOfFaultsAreCharactersAndNotBytes) {
  EXPECT_EQ(error_of("name,x,y\nBl\xC3\xA4tter,?,2\n").column, 9);
}

TEST(ReadColumns, RejectsRowsOfAnotherWidth) {
  for (const char* row : {"1", "1,2,3"}) {
    const Diagnostic found = error_of(std::string("x,y\n1,2\n") + row + "\n");
    EXPECT_NE(found.message.find("cells"), std::string::npos);
    EXPECT_EQ(found.expected, "2, as the head line");
    EXPECT_EQ(found.line, 3);
  }
}

TEST(ReadColumns, GathersAllFaultsOfRowsUpToTheLimit) {
  std::string text = "x,y\n";
  for (int row = 0; row < 50; ++row) text += "a,b\n";
  EXPECT_EQ(errors_of(text).size(), 100U);
  SizeLimits limits;
  limits.diagnostics = 7;
  EXPECT_EQ(errors_of(text, limits).size(), 7U);
}

std::vector<Diagnostic> table_errors(std::string_view text, const SizeLimits& limits = {}) {
  try {
    read_text_table(text, limits);
  } catch (const InputError& error) {
    return error.diagnostics();
  }
  return {};
}

TEST(ReadTextTable, ColumnsWithATextAreTextsAndOthersNumbers) {
  const TextTable table = read_text_table("x,kind,y\n1,oak,2\n\n3,\"a, b\",\n4,oak,6\n", {});
  EXPECT_EQ(table.names(), (std::vector<std::string>{"x", "kind", "y"}));
  EXPECT_EQ(table.row_count(), 3U);
  EXPECT_EQ(table.lines, (std::vector<int>{2, 4, 5}));
  EXPECT_EQ(table.find("x")->numbers, (List{1, 3, 4}));
  ASSERT_TRUE(table.find("y")->has_numbers());
  EXPECT_TRUE(std::isnan(table.find("y")->numbers[1])) << "an empty cell";
  const TextTable::Column& kind = *table.find("kind");
  EXPECT_FALSE(kind.has_numbers());
  EXPECT_EQ(kind.distinct, (std::vector<std::string>{"oak", "a, b"}));
  EXPECT_EQ(kind.text(1), "a, b");
  EXPECT_EQ(kind.text(2), "oak");
  EXPECT_EQ(table.find("z"), nullptr);
}

TEST(ReadTextTable, AColumnKnowsItsFirstCellThatIsNoNumber) {
  const TextTable table = read_text_table("x;y\n1;2,5\n2;about 3\n3;4\n", {});
  const TextTable::Column& column = *table.find("y");
  EXPECT_FALSE(column.has_numbers());
  EXPECT_EQ(column.odd_row, 1U);
  EXPECT_EQ(column.odd_column, 3);
  EXPECT_EQ(column.text(0), "2,5");
}

TEST(ReadTextTable, RejectsTablesThatAreNone) {
  for (const char* text : {"", "\n\n", "x,y\n"}) EXPECT_EQ(table_errors(text).size(), 1U) << text;
}

TEST(ReadTextTable, RejectsTwoColumnsOfOneNameAndRowsOfAnotherWidth) {
  const std::vector<Diagnostic> twice = table_errors("x,y,x\n1,2,3\n");
  ASSERT_EQ(twice.size(), 1U);
  EXPECT_EQ(twice[0].line, 1);
  EXPECT_EQ(twice[0].column, 5);
  const std::vector<Diagnostic> rows = table_errors("x,y\n1\n1,2\n1,2,3\n");
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].line, 2);
  EXPECT_EQ(rows[1].line, 4);
}

TEST(ReadTextTable, RejectsNumbersBeyondAllFiles) {
  const std::vector<Diagnostic> errors = table_errors("x,y\n1,2\n3,1e300\n");
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_EQ(errors[0].line, 3);
  EXPECT_EQ(errors[0].column, 3);
}

TEST(ReadTextTable, RejectsMoreRowsThanATableMayHave) {
  std::string text = "x\n";
  for (std::uint64_t k = 0; k <= kMaxRows; ++k) text += "1\n";
  const std::vector<Diagnostic> errors = table_errors(text);
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_NE(errors[0].text().find("1000000"), std::string::npos) << errors[0].text();
}

}  // namespace meristem::read_columns_test
