// SPDX-License-Identifier: Apache-2.0
// Numbers of a text in columns, as spreadsheets and digitisers write them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "meristem/base/limits.h"

namespace meristem {

/// A column that a reader asks for by its name in the head line.
struct ColumnRequest {
  std::string name;
  bool is_needed = true;
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
/// number, no rows.
Columns read_columns(std::string_view text, const std::vector<ColumnRequest>& forms, const Limits& limits);

}  // namespace meristem
