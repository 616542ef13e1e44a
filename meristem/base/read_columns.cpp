// SPDX-License-Identifier: Apache-2.0
// Reads tables in text form. The head line decides the separator, and each line is then split outside of quotes. Errors
// of all lines are collected with line and column.
#include "meristem/base/read_columns.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <unordered_map>
#include <utility>

#include <fmt/format.h>

#include "meristem/base/in_quotes.h"
#include "meristem/base/reading_stop.h"

namespace meristem {

namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
constexpr std::size_t kNone = static_cast<std::size_t>(-1);
constexpr std::size_t kLongestShown = 40;

struct Cell {
  std::string_view text;
  std::size_t offset = 0;  // bytes from the beginning of the line
};

std::string_view without_blanks(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

/// Returns the text without surrounding blanks and quotes.
std::string_view bare(std::string_view text) {
  text = without_blanks(text);
  const bool has_quotes = text.size() >= 2 && text.front() == '"' && text.back() == '"';
  return has_quotes ? without_blanks(text.substr(1, text.size() - 2)) : text;
}

/// Splits a line at the separator, outside of quotes.
void split(std::string_view line, char separator, std::vector<Cell>& cells) {
  cells.clear();
  std::size_t begin = 0;
  bool is_quoted = false;
  for (std::size_t at = 0; at <= line.size(); ++at) {
    if (at < line.size() && line[at] == '"') is_quoted = !is_quoted;
    if (at < line.size() && (is_quoted || line[at] != separator)) continue;
    cells.push_back({bare(line.substr(begin, at - begin)), begin});
    begin = at + 1;
  }
}

/// Returns the separator that occurs most often in the line, or the comma if none occurs.
char separator_of(std::string_view line) {
  char found = ',';
  for (const char candidate : {';', '\t'}) {
    if (std::ranges::count(line, candidate) > std::ranges::count(line, found)) found = candidate;
  }
  return found;
}

std::optional<double> number_of(std::string_view text, bool may_have_comma) {
  std::string with_point;
  if (may_have_comma && text.find(',') != std::string_view::npos) {
    with_point = text;
    std::ranges::replace(with_point, ',', '.');
    text = with_point;
  }
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool is_whole = error == std::errc() && end == text.data() + text.size();
  return is_whole && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

/// UTF-8 continuation bytes do not count as columns.
int column_at(std::string_view line, std::size_t offset) {
  const auto is_first = [](char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U; };
  return 1 + static_cast<int>(std::ranges::count_if(line.substr(0, offset), is_first));
}

class ColumnReader {
 public:
  ColumnReader(std::string_view text, const std::vector<ColumnRequest>& forms, const SizeLimits& limits, RowLimit rows)
      : rest_(text),
        forms_(forms),
        limits_(limits),
        max_rows_(rows == RowLimit::nodes ? limits.nodes : limits.points),
        limit_name_(rows == RowLimit::nodes ? "nodes" : "points") {
    if (rest_.starts_with(kByteOrderMark)) rest_.remove_prefix(kByteOrderMark.size());
  }

  Columns run() {
    found_.numbers.resize(forms_.size());
    if (!next_line())
      throw InputError(Diagnostic{.message = "the file has no lines", .expected = "a head line and rows"});
    separator_ = separator_of(line_);
    read_head();
    throw_if_any();
    while (next_line() && !is_full()) read_row();
    throw_if_any();
    if (found_.row_count() == 0) add_error(0, {.message = "the file has no rows below its head line"});
    throw_if_any();
    return std::move(found_);
  }

 private:
  bool is_full() const { return errors_.size() >= limits_.diagnostics; }

  bool next_line() {
    while (!rest_.empty()) {
      stop_.step();
      const std::size_t end = std::min(rest_.find('\n'), rest_.size());
      line_ = rest_.substr(0, end);
      rest_.remove_prefix(std::min(end + 1, rest_.size()));
      ++number_;
      if (!without_blanks(line_).empty()) return true;
    }
    return false;
  }

  void add_error(std::size_t offset, Diagnostic diagnostic) {
    diagnostic.line = number_;
    diagnostic.column = column_at(line_, offset);
    errors_.push_back(std::move(diagnostic));
  }

  void throw_if_any() {
    if (is_full()) errors_.resize(limits_.diagnostics);
    if (!errors_.empty()) throw InputError(std::move(errors_));
  }

  void read_head() {
    split(line_, separator_, cells_);
    width_ = cells_.size();
    std::vector<std::string> names;
    for (const Cell& cell : cells_) names.emplace_back(cell.text);
    for (const ColumnRequest& form : forms_) {
      const auto at = std::ranges::find(names, form.name);
      places_.push_back(at == names.end() ? kNone : static_cast<std::size_t>(at - names.begin()));
      if (at == names.end()) {
        if (!form.is_needed) continue;
        add_error(0, {.message = fmt::format("there is no column '{}'", form.name),
                      .expected = "a head line that names it",
                      .nearest = nearest_name(form.name, names)});
      } else if (const auto again = std::find(at + 1, names.end(), form.name); again != names.end()) {
        add_error(cells_[static_cast<std::size_t>(again - names.begin())].offset,
                  {.message = fmt::format("the column '{}' appears twice", form.name)});
      }
    }
  }

  void read_row() {
    split(line_, separator_, cells_);
    if (cells_.size() != width_) {
      add_error(0, {.message = fmt::format("the row has {} cells", cells_.size()),
                    .expected = fmt::format("{}, as the head line", width_)});
      return;
    }
    if (found_.row_count() >= max_rows_) {
      Diagnostic diagnostic =
          limit_diagnostic("rows of a table", static_cast<double>(found_.row_count()) + 1, max_rows_, limit_name_, "");
      diagnostic.line = number_;
      throw InputError(std::move(diagnostic));
    }
    found_.lines.push_back(number_);
    for (std::size_t k = 0; k < places_.size(); ++k) {
      if (places_[k] == kNone) continue;
      const Cell& cell = cells_[places_[k]];
      if (cell.text.empty() && forms_[k].may_be_empty) {
        found_.numbers[k].push_back(std::numeric_limits<double>::quiet_NaN());
        continue;
      }
      const std::optional<double> number = number_of(cell.text, separator_ != ',');
      if (!number) {
        add_error(cell.offset, {.message = fmt::format("{} in the column '{}' is not a number",
                                                       in_quotes(cell.text.substr(0, kLongestShown)), forms_[k].name),
                                .expected = "a finite number"});
      } else if (!forms_[k].limit.holds(*number)) {
        add_error(cell.offset, number_error(fmt::format("{} in the column '{}'", in_quotes(cell.text), forms_[k].name),
                                            forms_[k].limit));
      }
      found_.numbers[k].push_back(number.value_or(0));
    }
  }

  StopCounter stop_;
  std::string_view rest_;
  const std::vector<ColumnRequest>& forms_;
  const SizeLimits& limits_;
  std::uint64_t max_rows_;
  std::string_view limit_name_;
  std::string_view line_;
  int number_ = 0;
  char separator_ = ',';
  std::size_t width_ = 0;
  std::vector<Cell> cells_;
  std::vector<std::size_t> places_;  // for each requested column, its position among the cells, or kNone
  Columns found_;
  std::vector<Diagnostic> errors_;
};

/// Reads all columns. A column is numeric until a cell is not a number, and then becomes a column of texts.
class TableReader {
 public:
  TableReader(std::string_view text, const SizeLimits& limits) : text_(text), limits_(limits) {
    if (text_.starts_with(kByteOrderMark)) text_.remove_prefix(kByteOrderMark.size());
  }

  TextTable run() {
    const auto lines = static_cast<std::uint64_t>(std::ranges::count(text_, '\n'));
    if (lines > kMaxRows + kFewLines) throw_too_many(lines - 1);
    rest_ = text_;
    if (!next_line()) {
      throw InputError(Diagnostic{.message = "the file has no lines", .expected = "a head line and rows"});
    }
    read_head();
    throw_if_any();
    while (next_line() && errors_.size() < limits_.diagnostics) read_row();
    throw_if_any();
    if (table_.lines.empty()) add_error(0, {.message = "the file has no rows below its head line"});
    throw_if_any();
    if (table_.row_count() > kMaxRows) throw_too_many(table_.row_count());
    return std::move(table_);
  }

 private:
  static constexpr std::uint64_t kFewLines = 1000;        // allowance for empty lines and the head
  static constexpr std::uint64_t kMaxCells = 50'000'000;  // maximum number of cells of all columns

  [[noreturn]] static void throw_too_many(std::uint64_t rows) {
    throw InputError(Diagnostic{.message = fmt::format("the table has {} rows", rows),
                                .expected = fmt::format("at most {}", kMaxRows)});
  }

  bool next_line() {
    while (!rest_.empty()) {
      stop_.step();
      const std::size_t end = std::min(rest_.find('\n'), rest_.size());
      line_ = rest_.substr(0, end);
      rest_.remove_prefix(std::min(end + 1, rest_.size()));
      ++number_;
      if (!without_blanks(line_).empty()) return true;
    }
    return false;
  }

  void add_error(std::size_t offset, Diagnostic diagnostic) {
    diagnostic.line = number_;
    diagnostic.column = column_at(line_, offset);
    errors_.push_back(std::move(diagnostic));
  }

  void throw_if_any() {
    if (!errors_.empty()) throw InputError(std::move(errors_));
  }

  void read_head() {
    separator_ = separator_of(line_);
    split(line_, separator_, cells_);
    const auto lines = static_cast<std::uint64_t>(std::ranges::count(text_, '\n')) + 1;
    if (lines * cells_.size() > kMaxCells) {
      add_error(0, {.message = fmt::format("the table has {} columns in {} lines", cells_.size(), lines),
                    .expected = fmt::format("at most {} cells", kMaxCells)});
      return;
    }
    std::vector<std::string> names;
    for (const Cell& cell : cells_) {
      std::string name(cell.text.substr(0, kLongestName));
      if (!name.empty() && std::ranges::find(names, name) != names.end()) {
        add_error(cell.offset, {.message = fmt::format("the column {} appears twice", in_quotes(name))});
        if (errors_.size() >= limits_.diagnostics) return;
      }
      names.push_back(name);
      table_.columns.push_back({.name = std::move(name)});
    }
    numbers_of_text_.resize(cells_.size());
  }

  void read_row() {
    split(line_, separator_, cells_);
    if (cells_.size() != table_.columns.size()) {
      add_error(0, {.message = fmt::format("the row has {} cells", cells_.size()),
                    .expected = fmt::format("{}, as the head line", table_.columns.size())});
      return;
    }
    for (std::size_t k = 0; k < cells_.size(); ++k) {
      stop_.step();
      add(cells_[k], k);
    }
    table_.lines.push_back(number_);
  }

  void add(const Cell& cell, std::size_t k) {
    TextTable::Column& column = table_.columns[k];
    const std::size_t row = table_.lines.size();
    if (column.has_numbers() || row == 0) {
      const bool is_empty = cell.text.empty();
      const std::optional<double> number = is_empty ? std::nullopt : number_of(cell.text, separator_ != ',');
      if (number && !kFileNumber.holds(*number)) {
        add_error(cell.offset,
                  number_error(fmt::format("{} in the column {}", in_quotes(cell.text), in_quotes(column.name)),
                               kFileNumber));
      }
      if (number || is_empty) {
        column.numbers.push_back(number.value_or(std::numeric_limits<double>::quiet_NaN()));
        return;
      }
      become_texts(k);
      column.odd_row = row;
      column.odd_column = column_at(line_, cell.offset);
    }
    add_text(k, cell.text);
  }

  /// The texts of earlier cells are read again. Columns that become texts late are rare.
  void become_texts(std::size_t k) {
    table_.columns[k].numbers.clear();
    std::string_view rest = text_;
    std::vector<Cell> cells;
    bool is_head = true;
    for (int line = 1; line < number_; ++line) {
      stop_.step();
      const std::size_t end = std::min(rest.find('\n'), rest.size());
      const std::string_view one = rest.substr(0, end);
      rest.remove_prefix(std::min(end + 1, rest.size()));
      if (without_blanks(one).empty()) continue;
      if (!std::exchange(is_head, false)) {
        split(one, separator_, cells);
        if (k < cells.size()) add_text(k, cells[k].text);
      }
    }
  }

  void add_text(std::size_t k, std::string_view text) {
    TextTable::Column& column = table_.columns[k];
    const auto next = static_cast<std::uint32_t>(column.distinct.size());
    const auto [known, is_new] = numbers_of_text_[k].try_emplace(std::string(text), next);
    if (is_new) column.distinct.emplace_back(text);
    column.texts.push_back(known->second);
  }

  static constexpr std::size_t kLongestName = 100;

  StopCounter stop_;
  std::string_view text_;
  std::string_view rest_;
  const SizeLimits& limits_;
  std::string_view line_;
  int number_ = 0;
  char separator_ = ',';
  std::vector<Cell> cells_;
  std::vector<std::unordered_map<std::string, std::uint32_t>> numbers_of_text_;  // for each column
  TextTable table_;
  std::vector<Diagnostic> errors_;
};

}  // namespace

const TextTable::Column* TextTable::find(std::string_view name) const {
  const auto found = std::ranges::find(columns, name, &Column::name);
  return found == columns.end() ? nullptr : &*found;
}

std::vector<std::string> TextTable::names() const {
  std::vector<std::string> names;
  for (const Column& column : columns) names.push_back(column.name);
  return names;
}

TextTable read_text_table(std::string_view text, const SizeLimits& limits) { return TableReader(text, limits).run(); }

int column_of_cell(std::string_view text, int line, std::string_view column) {
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  std::string_view head;
  for (int number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view one = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (head.empty() && !without_blanks(one).empty()) head = one;
    if (number < line) continue;
    std::vector<Cell> names;
    std::vector<Cell> cells;
    split(head, separator_of(head), names);
    split(one, separator_of(head), cells);
    const auto found = std::ranges::find(names, column, &Cell::text);
    const auto k = static_cast<std::size_t>(found - names.begin());
    return found != names.end() && k < cells.size() ? column_at(one, cells[k].offset) : 1;
  }
  return 1;
}

Columns read_columns(std::string_view text, const std::vector<ColumnRequest>& forms, const SizeLimits& limits,
                     RowLimit rows) {
  return ColumnReader(text, forms, limits, rows).run();
}

}  // namespace meristem
