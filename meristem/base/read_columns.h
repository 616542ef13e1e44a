// SPDX-License-Identifier: Apache-2.0
// Numbers of a text in columns, as spreadsheets and digitisers write them.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "meristem/base/limits.h"
#include "meristem/base/number_limit.h"

namespace meristem {

/// Which limit counts the rows of a table.
enum class RowLimit { points, nodes };

/// A column that a reader asks for by its name in the head line.
struct ColumnRequest {
  std::string name;
  bool is_needed = true;
  bool may_be_empty = false;  ///< a cell without text is NaN
  NumberLimit limit = kFileNumber;
};

/// The columns asked for, in that order.
struct Columns {
  std::vector<std::vector<double>> numbers;  ///< a list per column; empty for one that is not there
  std::vector<int> lines;                    ///< of each row in the text, from 1

  std::size_t row_count() const { return lines.size(); }
  bool has(std::size_t column) const { return !numbers[column].empty(); }
};

/// Reads a text whose first line names its columns; commas, semicolons or tabs part them, and where it is not commas, a
/// number may have one in place of its point. Cells may stand in quotes, empty lines do not count, and of columns that
/// nobody asks for nothing is read. Throws an InputError with all faults by line and column: a column that is missing
/// (with the nearest name) or there twice, a row with more or fewer cells than the head, a cell that is no finite
/// number or not within the limit of its column, no rows, more rows than the limit that counts them.
Columns read_columns(std::string_view text, const std::vector<ColumnRequest>& forms, const Limits& limits,
                     RowLimit rows = RowLimit::points);

/// A table of numbers and texts, whatever its columns.
struct TextTable {
  struct Column {
    std::string name;
    /// The numbers of a column whose cells are all numbers or empty, which are NaN; else empty.
    std::vector<double> numbers;
    /// The texts of any other column: indices into `distinct`.
    std::vector<std::uint32_t> texts;
    std::vector<std::string> distinct;  ///< in the order in which they come first
    std::size_t odd_row = 0;            ///< the first whose cell is not a number
    int odd_column = 0;                 ///< of that cell in its line, from 1

    bool has_numbers() const { return texts.empty(); }
    const std::string& text(std::size_t row) const { return distinct[texts[row]]; }
  };
  std::vector<Column> columns;
  std::vector<int> lines;  ///< of each row in the text, from 1

  std::size_t row_count() const { return lines.size(); }
  const Column* find(std::string_view name) const;
  std::vector<std::string> names() const;
};

/// Where the cell of a named column begins in the line `line` of a table's text, in characters from 1, for messages.
/// Returns 1 if there is no such cell. Cost linear in the text.
int column_of_cell(std::string_view text, int line, std::string_view column);

/// Rows that a table may have.
inline constexpr std::uint64_t kMostRows = 1'000'000;

/// Reads all columns of a text that is written as read_columns() expects it. Throws an InputError with all faults by
/// line and column: no columns, two of one name, a row with more or fewer cells than the head, a number that
/// kFileNumber does not hold, no rows; and where there are more than kMostRows of them, before they are read.
TextTable read_text_table(std::string_view text, const Limits& limits);

}  // namespace meristem
