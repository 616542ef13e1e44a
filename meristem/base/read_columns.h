// SPDX-License-Identifier: Apache-2.0
// Reads text tables of numbers, as spreadsheets and digitisers write them.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "meristem/base/limits.h"
#include "meristem/base/number_limit.h"

namespace meristem {

/// The limit on the number of rows of a table.
enum class RowLimit { points, nodes };

/// A column that a reader requests by its name in the head line.
struct ColumnRequest {
  std::string name;
  bool is_needed = true;
  bool may_be_empty = false;  ///< if true, a cell without text is NaN
  NumberLimit limit = kFileNumber;
};

/// The requested columns, in the order of the requests.
struct Columns {
  std::vector<std::vector<double>> numbers;  ///< one list per column; empty if the column does not exist
  std::vector<int> lines;                    ///< line of each row in the text, from 1

  std::size_t row_count() const { return lines.size(); }
  bool has(std::size_t column) const { return !numbers[column].empty(); }
};

/// Reads a text whose first line names its columns. Commas, semicolons or tabs separate cells. With semicolons or tabs,
/// numbers may have a decimal comma. Cells may be in quotes, empty lines are ignored, and columns that were not
/// requested are not read. Throws an InputError with all errors by line and column: a missing column (with the nearest
/// name), a repeated column, a row with more or fewer cells than the head, a cell that is not a finite number or
/// exceeds the limit of its column, no rows, or more rows than the limit allows.
Columns read_columns(std::string_view text, const std::vector<ColumnRequest>& forms, const SizeLimits& limits,
                     RowLimit rows = RowLimit::points);

/// A table of numbers and texts with any columns.
struct TextTable {
  struct Column {
    std::string name;
    /// The numbers of a column in which every cell is a number or empty (NaN). Empty for all other columns.
    std::vector<double> numbers;
    /// The texts of all other columns, as indices into `distinct`.
    std::vector<std::uint32_t> texts;
    std::vector<std::string> distinct;  ///< in the order of their first occurrence
    std::size_t odd_row = 0;            ///< first row whose cell is not a number
    int odd_column = 0;                 ///< column of that cell in its line, from 1

    bool has_numbers() const { return texts.empty(); }
    const std::string& text(std::size_t row) const { return distinct[texts[row]]; }
  };
  std::vector<Column> columns;
  std::vector<int> lines;  ///< line of each row in the text, from 1

  std::size_t row_count() const { return lines.size(); }
  const Column* find(std::string_view name) const;
  std::vector<std::string> names() const;
};

/// Returns where the cell of a named column begins in line `line` of a table's text, in characters from 1, for
/// messages. Returns 1 if there is no such cell. The cost is linear in the text.
int column_of_cell(std::string_view text, int line, std::string_view column);

/// Maximum number of rows of a table.
inline constexpr std::uint64_t kMaxRows = 1'000'000;

/// Reads all columns of a text in the format of read_columns(). Throws an InputError with all errors by line and
/// column: no columns, two columns of one name, a row with more or fewer cells than the head, a number outside
/// kFileNumber, or no rows. More than kMaxRows rows are an error before the rows are read.
TextTable read_text_table(std::string_view text, const SizeLimits& limits);

}  // namespace meristem
